//! Detections from a view.

use bica_field::FIELD;
use bica_motion::model::NAO;
use bica_motion::side::Side;
use bica_sim::World;
use bica_vision::frame::Frame;
use bica_vision::pipeline::{Detections, Pipeline};
use bica_vision::profile::BUILT_IN_TABLE;
use bica_vision::projection::Camera;

use super::view::View;

/// Camera from the joint angles, and the detections.
pub(crate) fn see(view: &View) -> (Camera, Detections) {
    let mut world = view.world.clone();
    let sensors = world.sensors();
    let image = sensors.image.expect("there is a new one");
    let frame = Frame::from_image(&image).expect("a frame");
    let camera = Camera::of(NAO, image.camera, &sensors.angles, Side::Left, image.width, image.height);
    let seen = Pipeline::<512, 1024>::new(FIELD.ball_radius()).detect(&frame, &BUILT_IN_TABLE, Some(&camera));
    (camera, seen)
}
