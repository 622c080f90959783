//! Reproducible random numbers, and sightings with the errors of a projection.

use bica_motion::model::NAO;
use bica_motion::robot::CameraId;
use bica_vision::projection::Camera;
use bica_vision::uncertainty::{self, Covariance, Errors};
use glam::{Mat2, Vec2};

/// Random number generator (xorshift*, Vigna 2016).
#[derive(Clone, Debug)]
pub(crate) struct Noise(u64);

impl Noise {
    pub(crate) fn new(seed: u64) -> Self {
        let mut noise = Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        (0..8).for_each(|_| _ = noise.unit());
        noise
    }

    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f32 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 40) as f32 / (1 << 24) as f32
    }

    pub(crate) fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.unit()
    }

    /// Standard normal.
    pub(crate) fn normal(&mut self) -> f32 {
        (-2.0 * (1.0 - self.unit()).ln()).sqrt() * (core::f32::consts::TAU * self.unit()).cos()
    }

    /// Random vector with a covariance.
    pub(crate) fn off_by(&mut self, covariance: &Covariance) -> Vec2 {
        root(covariance) * Vec2::new(self.normal(), self.normal())
    }
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
