//! The pose of the camera.

use bica::prelude::*;
use bica::visual::Pose3;
use bica_motion::kinematics::{camera, ground_from_robot};
use bica_motion::model::RobotModel;
use bica_motion::robot::CameraId;
use glam::{Affine3A, Vec2, Vec3};

use crate::input::RobotState;
use crate::league::input::CameraInput;
use crate::perception::ego_motion::LastImage;
use crate::{MODEL, shapes};

/// The pose of the camera when it took the newest view, from the joint angles and the support foot.
#[derive(Debug)]
pub struct CameraPose {
    model: &'static RobotModel,
    pose: Option<Affine3A>,
    image: LastImage,
}

#[component(budget_us = 5)]
impl CameraPose {
    /// Creates the component with an unknown pose.
    #[must_use]
    pub const fn new() -> Self {
        Self { model: MODEL, pose: None, image: LastImage::new() }
    }

    fn step(&mut self, input: &CameraInput, state: &RobotState) {
        if self.image.take_new(input) {
            self.model = state.model();
            let angles = input.angles();
            self.pose = Some(
                ground_from_robot(self.model, state.support(), angles) * camera(self.model, CameraId::Top, angles),
            );
        }
    }

    /// Pose of the camera that took the newest view.
    #[output(frame = "robot", child = "camera")]
    fn camera_pose(&self) -> Option<Pose3> {
        self.pose.as_ref().map(shapes::pose_in_space)
    }

    /// The model of the robot that carries the camera.
    pub(super) const fn model(&self) -> &'static RobotModel {
        self.model
    }

    /// Counts a cycle since the last image.
    pub(crate) const fn pass_cycle(&mut self) {
        self.image.age.pass_cycle();
    }

    const fn pose(&self) -> Option<Affine3A> {
        if self.image.age.is_fresh() { self.pose } else { None }
    }

    /// The direction of a sight in the ground frame between the feet, as a vector from the camera, m.
    #[must_use]
    pub fn direction(&self, sight: [f32; 3]) -> Option<Vec3> {
        self.pose().map(|pose| pose.transform_vector3(sight.into()))
    }

    /// The position of a sight whose height over the ground is known, m, in the ground frame between the feet. The distance is
    /// measured exactly, the tilt of the camera is not: the height and the distance give the distance on the ground.
    #[must_use]
    pub fn ground(&self, sight: [f32; 3], height: f32) -> Option<Vec2> {
        let (pose, sight) = (self.pose()?, Vec3::from(sight));
        let camera: Vec3 = pose.translation.into();
        let drop = camera.z - height;
        let along = libm::sqrtf((sight.length_squared() - drop * drop).max(0.0));
        let way = pose.transform_vector3(sight).truncate().try_normalize()?;
        Some(camera.truncate() + along * way)
    }
}
