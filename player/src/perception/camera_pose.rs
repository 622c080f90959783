//! The pose of the camera.

mod params;

use bica::prelude::*;
use bica::visual::{CameraCalibration, ImagePoint, ImageSegment, Pose3};
use bica_motion::model::RobotModel;
use bica_vision::projection::{Camera, Intrinsics, Mounting};
use bica_vision::uncertainty::Errors;

use super::ego_motion::LastImage;
use crate::MODEL;
use crate::input::{CameraInput, RobotState};
use crate::shapes;

pub use params::{CameraErrors, CameraMounting};

/// The pose of the camera when it took the newest image, from the joint angles and the support foot.
#[derive(Debug)]
pub struct CameraPose {
    model: &'static RobotModel,
    camera: Option<Camera>,
    /// Rotation since the previous image, rad.
    turned: f32,
    is_steady: bool,
    mounting: Mounting,
    errors: Errors,
    image: LastImage,
}

#[component(budget_us = 5)]
impl CameraPose {
    /// Creates the component with an unknown pose.
    #[must_use]
    pub const fn new() -> Self {
        let (mounting, errors) = (Mounting::EXACT, Errors::NAO);
        Self { model: MODEL, camera: None, turned: 0.0, is_steady: true, mounting, errors, image: LastImage::new() }
    }

    fn step(
        &mut self,
        mounting: &Tuned<CameraMounting>,
        errors: &Tuned<CameraErrors>,
        input: &CameraInput,
        state: &RobotState,
    ) {
        if self.image.take_new(input) {
            self.model = state.model();
            let image = input.image();
            (self.mounting, self.errors) = (mounting.of(image.camera), errors.errors());
            let camera =
                Camera::of(self.model, image.camera, input.angles(), state.support(), image.width, image.height)
                    .corrected(&self.mounting);
            let [before, now] = [self.camera.unwrap_or(camera), camera].map(|camera| camera.pose().matrix3.x_axis);
            self.turned = now.distance(before);
            self.is_steady = self.turned < errors.max_rotation;
            self.camera = Some(camera);
        }
    }

    /// The model of the robot that carries the camera.
    pub(super) const fn model(&self) -> &'static RobotModel {
        self.model
    }

    /// Counts a cycle since the last image.
    pub(super) const fn pass_cycle(&mut self) {
        self.image.age.pass_cycle();
    }

    /// Whether the rotation since the previous image is so small that the newest image is sharp.
    #[output]
    #[must_use]
    pub const fn is_steady(&self) -> bool {
        self.is_steady
    }

    /// Rotation of the camera between the last two images.
    #[output(unit = "rad")]
    const fn rotation(&self) -> f32 {
        self.turned
    }

    /// Pose of the camera that took the newest image.
    #[output(frame = "robot", child = "camera")]
    fn camera_pose(&self) -> Option<Pose3> {
        self.camera.map(|camera| shapes::pose_in_space(&camera.pose()))
    }

    /// Intrinsic parameters of the camera that took the newest image.
    #[output(unit = "px", frame = "camera")]
    fn calibration(&self) -> Option<CameraCalibration> {
        self.camera.map(|camera| {
            let Intrinsics { focal, centre } = camera.intrinsics();
            CameraCalibration { focal_x: focal.x, focal_y: focal.y, centre_x: centre.x, centre_y: centre.y }
        })
    }

    /// The horizon, from the left edge of the newest image to the right one.
    #[output(unit = "px", frame = "camera")]
    fn horizon(&self) -> Option<ImageSegment> {
        let camera = self.camera?;
        let at = |x: f32| camera.horizon(x).map(|y| ImagePoint { x, y });
        Some(ImageSegment { start: at(0.0)?, end: at(2.0 * camera.intrinsics().centre.x)? })
    }

    /// Standard deviations of the pose of the camera.
    #[must_use]
    pub const fn errors(&self) -> &Errors {
        &self.errors
    }

    /// Correction of the mounting of the camera that took the newest image.
    #[must_use]
    pub const fn mounting(&self) -> &Mounting {
        &self.mounting
    }

    /// The camera with its pose in the ground frame; `None` if there was no image for half a second.
    #[must_use]
    pub const fn camera(&self) -> Option<&Camera> {
        if self.image.age.is_fresh() { self.camera.as_ref() } else { None }
    }
}

#[cfg(all(test, not(feature = "small-frames")))]
mod tests {
    extern crate std;

    use bica_motion::joints::{JOINTS, Joints};
    use bica_motion::robot::{CameraId, Image};

    use super::super::Bearing;
    use super::*;

    #[test]
    fn tilted_mounting_affects_one_camera_only() {
        let axis = |camera: CameraId, top_tilt: f32| {
            let (mut input, mut pose) = (std::boxed::Box::new(CameraInput::new()), CameraPose::new());
            let image = Image { camera, width: 16, height: 12, yuyv: &[128; 2 * 16 * 12] };
            input.receive(&image, &Joints([0.0; JOINTS])).expect("the image fits");
            let mounting = CameraMounting { top_tilt, ..CameraMounting::DEFAULT };
            pose.step(&Tuned::new(mounting), &Tuned::DEFAULT, &input, &RobotState::new());
            Bearing::of(pose.camera().expect("an image").pose().matrix3.x_axis.into()).down
        };
        assert!((axis(CameraId::Top, 0.1) - axis(CameraId::Top, 0.0) - 0.1).abs() < 1e-5);
        assert_eq!(axis(CameraId::Bottom, 0.1).to_bits(), axis(CameraId::Bottom, 0.0).to_bits());
    }
}
