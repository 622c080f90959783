//! Sightings with the errors of a projection.

use bica_body::random::Random;
use bica_motion::model::NAO;
use bica_motion::robot::CameraId;
use bica_vision::projection::Camera;
use bica_vision::uncertainty::{self, Covariance, Errors};
use glam::{Mat2, Vec2};

/// Random vector with a covariance.
pub(crate) fn off_by(random: &mut Random, covariance: &Covariance) -> Vec2 {
    root(covariance) * Vec2::new(random.normal(), random.normal())
}

/// Cholesky decomposition: the lower triangular matrix whose product with its transpose is the covariance.
pub(crate) fn root(covariance: &Covariance) -> Mat2 {
    let (xx, xy, yy) = (covariance.x_axis.x, covariance.x_axis.y, covariance.y_axis.y);
    let below = xy / xx.sqrt();
    let root = Mat2::from_cols(Vec2::new(xx.sqrt(), below), Vec2::new(0.0, (yy - below * below).sqrt()));
    assert!(root.is_finite(), "no covariance: {covariance}");
    root
}

/// Covariance of a ball sighting at a position, for a standing NAO.
pub(crate) fn spread(place: Vec2) -> Covariance {
    let camera = Camera::of(NAO, CameraId::Top, &NAO.stand, bica_motion::side::Side::Left, 320, 240);
    let pixel = camera.pixel(place.extend(0.0325)).unwrap_or(Vec2::new(160.0, 239.0));
    let spread = uncertainty::of_ground(&camera, pixel, 0.0325, &Errors::NAO).expect("on the ground");
    spread + uncertainty::round(0.002)
}
