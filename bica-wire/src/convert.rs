//! Conversion between messages and the robot interface of [`bica_motion::robot`].

use core::fmt;

use bica_motion::joints::Joints;
use bica_motion::robot::{self, Buttons, CameraId, FootPressure, Image, Inertial, Light, Lights};

use crate::message::{Command, ImageInfo, Sensors};

/// The command contains a value that is not finite or out of range, so no part of it may be executed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InvalidCommand;

impl fmt::Display for InvalidCommand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the command contains a value that is not finite or out of range")
    }
}

impl core::error::Error for InvalidCommand {}

impl Sensors {
    /// Creates the message for sensor values measured at `time_us`, µs. `image_id` is the number under which the chunks of
    /// the image were sent.
    #[must_use]
    pub fn new(time_us: u64, sensors: &robot::Sensors<'_>, image_id: u32) -> Self {
        let (inertial, buttons) = (&sensors.inertial, &sensors.buttons);
        let ([gx, gy, gz], [ax, ay, az]) = (inertial.gyro.to_array(), inertial.acceleration.to_array());
        let foot = |foot: &FootPressure| [foot.front_left, foot.front_right, foot.rear_left, foot.rear_right];
        let ([a, b, c, d], [e, f, g, h]) = (foot(&sensors.left_foot), foot(&sensors.right_foot));
        Self {
            time_us,
            angles: sensors.angles.0,
            temperatures: sensors.temperatures.0,
            currents: sensors.currents.0,
            inertial: [gx, gy, gz, ax, ay, az, inertial.roll, inertial.pitch],
            feet: [a, b, c, d, e, f, g, h],
            buttons: [buttons.chest, buttons.left_bumper, buttons.right_bumper],
            image: sensors.image.map(|Image { camera, width, height, .. }| ImageInfo {
                id: image_id,
                bottom_camera: camera == CameraId::Bottom,
                width,
                height,
            }),
        }
    }

    /// Returns the sensor values. `yuyv` are the pixels of [`Self::image`]; without them there is no image.
    #[must_use]
    pub fn to_sensors<'a>(&self, yuyv: Option<&'a [u8]>) -> robot::Sensors<'a> {
        let [gx, gy, gz, ax, ay, az, roll, pitch] = self.inertial;
        let [chest, left_bumper, right_bumper] = self.buttons;
        let [a, b, c, d, e, f, g, h] = self.feet;
        let foot = |[front_left, front_right, rear_left, rear_right]: [f32; 4]| FootPressure {
            front_left,
            front_right,
            rear_left,
            rear_right,
        };
        robot::Sensors {
            angles: Joints(self.angles),
            temperatures: Joints(self.temperatures),
            currents: Joints(self.currents),
            inertial: Inertial { gyro: [gx, gy, gz].into(), acceleration: [ax, ay, az].into(), roll, pitch },
            left_foot: foot([a, b, c, d]),
            right_foot: foot([e, f, g, h]),
            buttons: Buttons { chest, left_bumper, right_bumper },
            image: self.image.zip(yuyv).map(|(info, yuyv)| Image {
                camera: info.camera(),
                width: info.width,
                height: info.height,
                yuyv,
            }),
        }
    }
}

impl ImageInfo {
    /// Returns the camera that took the image.
    #[must_use]
    pub const fn camera(&self) -> CameraId {
        camera(self.bottom_camera)
    }
}

impl Command {
    /// Creates the message for a command computed from the sensor values of `time_us`, µs.
    #[must_use]
    pub fn new(time_us: u64, command: &robot::Command) -> Self {
        let Lights { chest, left_eye, right_eye } = command.lights;
        let mut lights = [0.0; 9];
        for (to, Light(red, green, blue)) in lights.as_chunks_mut().0.iter_mut().zip([chest, left_eye, right_eye]) {
            *to = [red, green, blue];
        }
        let bottom_camera = command.camera == CameraId::Bottom;
        Self { time_us, targets: command.targets.0, stiffness: command.stiffness.0, lights, bottom_camera }
    }

    /// Returns the command.
    ///
    /// # Errors
    /// [`InvalidCommand`] if a target is not finite, or a stiffness or light is not within 0 and 1.
    pub fn to_command(&self) -> Result<robot::Command, InvalidCommand> {
        let is_fraction = |value: &f32| (0.0..=1.0).contains(value);
        let valid = self.targets.iter().all(|target| target.is_finite())
            && self.stiffness.iter().all(is_fraction)
            && self.lights.iter().all(is_fraction);
        let [cr, cg, cb, lr, lg, lb, rr, rg, rb] = self.lights;
        valid
            .then_some(robot::Command {
                targets: Joints(self.targets),
                stiffness: Joints(self.stiffness),
                lights: Lights { chest: Light(cr, cg, cb), left_eye: Light(lr, lg, lb), right_eye: Light(rr, rg, rb) },
                camera: camera(self.bottom_camera),
            })
            .ok_or(InvalidCommand)
    }
}

const fn camera(is_bottom: bool) -> CameraId {
    if is_bottom { CameraId::Bottom } else { CameraId::Top }
}
