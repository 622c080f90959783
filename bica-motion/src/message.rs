//! Sensor values and commands as messages: how they are encoded, and the schemas that name their values.
//!
//! The encoded form of a struct of numbers is that of an array. Deserialisation reads the array in a loop: code that serde
//! generates reads each number separately, which costs a microcontroller's flash.

use core::fmt;

use bica_core::{Blob, Format};
use postcard_schema::Schema;
use postcard_schema::schema::{DataModelType, NamedType, NamedValue};
use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::joints::{JOINTS, Joints};
use crate::robot::{Buttons, CameraId, Command, FootPressure, Image, Inertial, Lights, Sensors};

struct Numbers<const N: usize>;

impl<'de, const N: usize> Visitor<'de> for Numbers<N> {
    type Value = [f32; N];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an array of numbers")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<[f32; N], A::Error> {
        let mut values = [0.0; N];
        for (count, value) in values.iter_mut().enumerate() {
            *value = sequence.next_element()?.ok_or_else(|| A::Error::invalid_length(count, &self))?;
        }
        Ok(values)
    }
}

fn numbers<'de, const N: usize, D: Deserializer<'de>>(from: D) -> Result<[f32; N], D::Error> {
    from.deserialize_tuple(N, Numbers)
}

impl<'de> Deserialize<'de> for Joints<f32> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        numbers(from).map(Joints)
    }
}

impl<'de> Deserialize<'de> for FootPressure {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let [front_left, front_right, rear_left, rear_right] = numbers(from)?;
        Ok(Self { front_left, front_right, rear_left, rear_right })
    }
}

impl<'de> Deserialize<'de> for Inertial {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let [gx, gy, gz, ax, ay, az, roll, pitch] = numbers(from)?;
        Ok(Self { gyro: [gx, gy, gz].into(), acceleration: [ax, ay, az].into(), roll, pitch })
    }
}

impl Serialize for Inertial {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let ([gx, gy, gz], [ax, ay, az]) = (self.gyro.to_array(), self.acceleration.to_array());
        [gx, gy, gz, ax, ay, az, self.roll, self.pitch].serialize(to)
    }
}

/// Frame of an image of the bottom camera.
const BOTTOM: &str = "bottom_camera";
/// Frame of an image of the top camera.
const TOP: &str = "top_camera";

impl CameraId {
    /// Name of the camera's coordinate frame.
    #[must_use]
    pub const fn frame(self) -> &'static str {
        match self {
            Self::Top => TOP,
            Self::Bottom => BOTTOM,
        }
    }
}

impl Serialize for Image<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let format = Format::Yuyv { width: self.width, height: self.height };
        Blob { bytes: self.yuyv, format, frame: self.camera.frame() }.serialize(to)
    }
}

impl<'de: 'a, 'a> Deserialize<'de> for Image<'a> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        /// The [`Blob`] of an image. Its frame is read as bytes: text would be checked.
        #[derive(Deserialize)]
        struct Pixels<'a> {
            yuyv: &'a [u8],
            format: Yuyv,
            frame: &'a [u8],
        }

        /// The only [`Format`] of an image.
        #[derive(Deserialize)]
        enum Yuyv {
            Yuyv { width: u16, height: u16 },
        }

        let Pixels { yuyv, format: Yuyv::Yuyv { width, height }, frame } = Pixels::deserialize(from)?;
        let camera = if frame == BOTTOM.as_bytes() { CameraId::Bottom } else { CameraId::Top };
        Ok(Image { camera, width, height, yuyv })
    }
}

/// Reads an image; none if its pixels were lost on their way, or are not as many as its size says.
pub(crate) fn whole_image<'de: 'a, 'a, D: Deserializer<'de>>(from: D) -> Result<Option<Image<'a>>, D::Error> {
    let is_whole = |image: &Image<'_>| image.yuyv.len() == 2 * usize::from(image.width) * usize::from(image.height);
    Ok(Option::deserialize(from)?.filter(is_whole))
}

const fn number(name: &'static str) -> NamedValue {
    NamedValue { name, ty: f32::SCHEMA }
}

/// One number for each joint, with its name.
const JOINT_VALUES: &NamedType = &NamedType {
    name: "Joints",
    ty: &DataModelType::Struct(
        const {
            &[
                &number("HeadYaw"),
                &number("HeadPitch"),
                &number("LShoulderPitch"),
                &number("LShoulderRoll"),
                &number("LElbowYaw"),
                &number("LElbowRoll"),
                &number("LWristYaw"),
                &number("LHipYawPitch"),
                &number("LHipRoll"),
                &number("LHipPitch"),
                &number("LKneePitch"),
                &number("LAnklePitch"),
                &number("LAnkleRoll"),
                &number("RHipRoll"),
                &number("RHipPitch"),
                &number("RKneePitch"),
                &number("RAnklePitch"),
                &number("RAnkleRoll"),
                &number("RShoulderPitch"),
                &number("RShoulderRoll"),
                &number("RElbowYaw"),
                &number("RElbowRoll"),
                &number("RWristYaw"),
                &number("LHand"),
                &number("RHand"),
            ] as &[_; JOINTS]
        },
    ),
};

const VECTOR: &NamedType =
    &NamedType { name: "Vector", ty: &DataModelType::Struct(&[&number("x"), &number("y"), &number("z")]) };

impl Schema for Inertial {
    const SCHEMA: &'static NamedType = &NamedType {
        name: "Inertial",
        ty: &DataModelType::Struct(&[
            &NamedValue { name: "gyro", ty: VECTOR },
            &NamedValue { name: "acceleration", ty: VECTOR },
            &number("roll"),
            &number("pitch"),
        ]),
    };
}

impl Schema for Sensors<'_> {
    const SCHEMA: &'static NamedType = &NamedType {
        name: "Sensors",
        ty: &DataModelType::Struct(&[
            &NamedValue { name: "angles", ty: JOINT_VALUES },
            &NamedValue { name: "temperatures", ty: JOINT_VALUES },
            &NamedValue { name: "currents", ty: JOINT_VALUES },
            &NamedValue { name: "inertial", ty: Inertial::SCHEMA },
            &NamedValue { name: "left_foot", ty: FootPressure::SCHEMA },
            &NamedValue { name: "right_foot", ty: FootPressure::SCHEMA },
            &NamedValue { name: "buttons", ty: Buttons::SCHEMA },
            &NamedValue { name: "image", ty: Option::<Blob<'static>>::SCHEMA },
        ]),
    };
}

impl Schema for Command {
    const SCHEMA: &'static NamedType = &NamedType {
        name: "Command",
        ty: &DataModelType::Struct(&[
            &NamedValue { name: "targets", ty: JOINT_VALUES },
            &NamedValue { name: "stiffness", ty: JOINT_VALUES },
            &NamedValue { name: "lights", ty: Lights::SCHEMA },
            &NamedValue { name: "camera", ty: CameraId::SCHEMA },
        ]),
    };
}
