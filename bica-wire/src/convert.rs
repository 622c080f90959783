//! Between the wire and what a robot's mind works with.

use core::fmt;

use bica_motion::joints::Joints;
use bica_motion::robot::{self, Buttons, CameraId, FootPressure, Image, Inertial, Light, Lights};

use crate::message::{Command, Picture, Sensors};

/// A command that no robot may be given: a value is no number, or out of its range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoCommand;

impl fmt::Display for NoCommand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the command holds a value that is no number or out of range: nothing of it is obeyed")
    }
}

impl core::error::Error for NoCommand {}

impl Sensors {
    /// What is sensed at a time (µs); `image` is the number that the pieces of its image were sent under.
    #[must_use]
    pub fn new(time_us: u64, sensors: &robot::Sensors<'_>, image: u32) -> Self {
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
            picture: sensors.image.map(|Image { camera, width, height, .. }| Picture {
                image,
                bottom: camera == CameraId::Bottom,
                width,
                height,
            }),
        }
    }

    /// The same for a robot's mind. `yuyv` are the pixels of [`Self::picture`]; without them there is no image.
    #[must_use]
    pub fn sensed<'a>(&self, yuyv: Option<&'a [u8]>) -> robot::Sensors<'a> {
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
            image: self.picture.zip(yuyv).map(|(picture, yuyv)| Image {
                camera: camera(picture.bottom),
                width: picture.width,
                height: picture.height,
                yuyv,
            }),
        }
    }
}

impl Command {
    /// A command that follows the sensors of a time, µs.
    #[must_use]
    pub fn new(time_us: u64, command: &robot::Command) -> Self {
        let Lights { chest, left_eye, right_eye } = command.lights;
        let mut lights = [0.0; 9];
        for (to, Light(red, green, blue)) in lights.as_chunks_mut().0.iter_mut().zip([chest, left_eye, right_eye]) {
            *to = [red, green, blue];
        }
        let bottom = command.camera == CameraId::Bottom;
        Self { time_us, targets: command.targets.0, stiffness: command.stiffness.0, lights, bottom }
    }

    /// The same for a robot.
    ///
    /// # Errors
    /// [`NoCommand`] if a value is no number, or a stiffness or light is not within 0 and 1.
    pub fn obeyed(&self) -> Result<robot::Command, NoCommand> {
        let part = |value: &f32| (0.0..=1.0).contains(value);
        let fits = self.targets.iter().all(|target| target.is_finite())
            && self.stiffness.iter().all(part)
            && self.lights.iter().all(part);
        let [cr, cg, cb, lr, lg, lb, rr, rg, rb] = self.lights;
        fits.then_some(robot::Command {
            targets: Joints(self.targets),
            stiffness: Joints(self.stiffness),
            lights: Lights { chest: Light(cr, cg, cb), left_eye: Light(lr, lg, lb), right_eye: Light(rr, rg, rb) },
            camera: camera(self.bottom),
        })
        .ok_or(NoCommand)
    }
}

const fn camera(bottom: bool) -> CameraId {
    if bottom { CameraId::Bottom } else { CameraId::Top }
}
