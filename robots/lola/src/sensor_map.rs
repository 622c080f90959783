//! The map that the robot sends every 12 ms.

use bica_motion::joints::{JOINTS, Joints};
use bica_motion::robot::{Buttons, FootPressure, Inertial, Sensors};
use glam::Vec3;

use crate::identity::Identity;
use crate::mistake::{Mistake, Undecoded};
use crate::reader::Reader;
use crate::writer::Writer;

/// Size of a sensor map of a NAO V6, bytes. Sources: B-Human 2023, rUNSWift 2019, nidhogg, HULKs 2025.
pub const SENSOR_MAP_BYTES: usize = 896;
/// Newtons per kilogram: LoLA measures the forces on the soles in kg.
const GRAVITY: f32 = 9.81;
/// Least value of a pressed button: LoLA sends 0 or 1.
const PRESSED: f32 = 0.5;

/// Keys of the map.
const KEYS: [&str; 13] = [
    "RobotConfig",
    "Accelerometer",
    "Angles",
    "Battery",
    "Current",
    "FSR",
    "Gyroscope",
    "Position",
    "Sonar",
    "Stiffness",
    "Temperature",
    "Touch",
    "Status",
];

/// Measurements of one cycle, in LoLA's order and units. The order of the joints is that of [`Joint`](bica_motion::joints::Joint).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SensorMap {
    /// Who the robot is.
    pub identity: Identity,
    /// Negated specific force, m/s²: (0, 0, -9.81) in an upright robot.
    pub accelerometer: [f32; 3],
    /// Roll and pitch of the torso, rad.
    pub angles: [f32; 2],
    /// Charge (0 to 1), status (bits of an `i16`), current (A), temperature.
    pub battery: [f32; 4],
    /// Currents of the motors, A.
    pub current: [f32; JOINTS],
    /// Forces on the soles, kg: front left, front right, rear left, rear right of the left foot, then of the right one.
    pub fsr: [f32; 8],
    /// Turn rates, rad/s.
    pub gyroscope: [f32; 3],
    /// Angles of the joints, rad; of a hand 0 to 1.
    pub position: [f32; JOINTS],
    /// Distances, left and right, m.
    pub sonar: [f32; 2],
    /// Stiffness in force, 0 to 1.
    pub stiffness: [f32; JOINTS],
    /// Temperatures of the motors, °C.
    pub temperature: [f32; JOINTS],
    /// Buttons: chest; head front, middle, rear; left bumper left, right; left hand back, left, right; right bumper left, right; right
    /// hand back, left, right.
    pub touch: [f32; 14],
    /// State of the motors: 0 regular, 1 hot, 2 very hot, 3 critical.
    pub status: [u8; JOINTS],
}

impl SensorMap {
    /// Decodes the map at the start of `bytes`; returns it and its size in bytes. Keys may be in any order; unknown ones are skipped.
    ///
    /// # Errors
    /// [`Undecoded::Incomplete`] if the bytes end within the map; otherwise the first [`Mistake`].
    pub fn decode(bytes: &[u8]) -> Result<(Self, usize), Undecoded> {
        let mut reader = Reader::new(bytes);
        let (mut map, mut seen) = (Self::default(), [false; KEYS.len()]);
        for _ in 0..reader.map()? {
            let key = reader.key()?;
            let Some(index) = KEYS.iter().position(|known| *known == key) else {
                reader.skip()?;
                continue;
            };
            if core::mem::replace(&mut seen[index], true) {
                return Err(Mistake::Twice { key: KEYS[index] }.into());
            }
            map.read(KEYS[index], &mut reader)?;
        }
        match seen.iter().position(|seen| !seen) {
            Some(missing) => Err(Mistake::Missing { key: KEYS[missing] }.into()),
            None => Ok((map, reader.position())),
        }
    }

    /// Reads the value of a key.
    fn read(&mut self, key: &'static str, reader: &mut Reader<'_>) -> Result<(), Undecoded> {
        match key {
            "Accelerometer" => self.accelerometer = reader.floats(key)?,
            "Angles" => self.angles = reader.floats(key)?,
            "Battery" => self.battery = reader.floats(key)?,
            "Current" => self.current = reader.floats(key)?,
            "FSR" => self.fsr = reader.floats(key)?,
            "Gyroscope" => self.gyroscope = reader.floats(key)?,
            "Position" => self.position = reader.floats(key)?,
            "Sonar" => self.sonar = reader.floats(key)?,
            "Stiffness" => self.stiffness = reader.floats(key)?,
            "Temperature" => self.temperature = reader.floats(key)?,
            "Touch" => self.touch = reader.floats(key)?,
            "Status" => self.status = reader.small(key)?,
            _ => self.identity = Identity::new(reader.texts(key)?),
        }
        Ok(())
    }

    /// Encodes the map as a robot sends it, for stand-ins.
    #[must_use]
    pub fn encode(&self) -> Vec<u8> {
        let mut writer = Writer::new(KEYS.len() as u32);
        writer.texts("RobotConfig", &self.identity.texts());
        writer.floats("Accelerometer", &self.accelerometer);
        writer.floats("Angles", &self.angles);
        writer.floats("Battery", &self.battery);
        writer.floats("Current", &self.current);
        writer.floats("FSR", &self.fsr);
        writer.floats("Gyroscope", &self.gyroscope);
        writer.floats("Position", &self.position);
        writer.floats("Sonar", &self.sonar);
        writer.floats("Stiffness", &self.stiffness);
        writer.floats("Temperature", &self.temperature);
        writer.floats("Touch", &self.touch);
        writer.small("Status", &self.status);
        writer.finish()
    }

    /// The measurements in the units and signs of a robot program, without an image.
    #[must_use]
    pub fn sensors(&self) -> Sensors<'static> {
        let foot = |first: usize| {
            let [front_left, front_right, rear_left, rear_right] = [0, 1, 2, 3].map(|i| GRAVITY * self.fsr[first + i]);
            FootPressure { front_left, front_right, rear_left, rear_right }
        };
        let [roll, pitch] = self.angles;
        let pressed = |button: usize| self.touch[button] >= PRESSED;
        Sensors {
            angles: self.positions(),
            temperatures: Joints(self.temperature),
            currents: Joints(self.current.map(f32::abs)),
            inertial: Inertial {
                gyro: Vec3::from_array(self.gyroscope),
                acceleration: -Vec3::from_array(self.accelerometer),
                roll,
                pitch,
            },
            left_foot: foot(0),
            right_foot: foot(4),
            buttons: Buttons {
                chest: pressed(0),
                left_bumper: pressed(4) || pressed(5),
                right_bumper: pressed(9) || pressed(10),
            },
            image: None,
        }
    }

    /// Measured angles of the joints, rad.
    #[must_use]
    pub const fn positions(&self) -> Joints {
        Joints(self.position)
    }
}
