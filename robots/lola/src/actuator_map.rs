//! The map that answers each sensor map.

use bica_motion::joints::{JOINTS, Joints};
use bica_motion::robot::{Light, Lights};

use crate::mistake::{Mistake, Undecoded};
use crate::reader::Reader;
use crate::writer::Writer;

/// Lights of an eye: eight red ones, then eight green ones, then eight blue ones.
const EYE: usize = 24;

/// Targets, stiffness and lights of one cycle. LoLA keeps what a map does not contain: ears, feet, skull and sonar are left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ActuatorMap {
    /// Target angles, rad; of a hand 0 to 1. A [`Limiter`](crate::Limiter) keeps them within what the robot may be sent.
    pub position: Joints,
    /// Stiffness, 0 to 1.
    pub stiffness: Joints,
    /// Lights, 0 to 1; others are clamped.
    pub lights: Lights,
}

impl ActuatorMap {
    /// Encodes the map.
    #[must_use]
    pub fn encode(&self) -> Vec<u8> {
        let Lights { chest, left_eye, right_eye } = self.lights;
        let mut writer = Writer::new(5);
        writer.floats("Position", &self.position.0);
        writer.floats("Stiffness", &self.stiffness.0);
        writer.floats("Chest", &rgb(chest));
        writer.floats("LEye", &eye(left_eye));
        writer.floats("REye", &eye(right_eye));
        writer.finish()
    }

    /// Decodes any map that LoLA accepts, for stand-ins: returns its targets and its stiffness, if it contains them, and its size in
    /// bytes.
    ///
    /// # Errors
    /// [`Undecoded::Incomplete`] if the bytes end within the map; otherwise the first [`Mistake`].
    pub fn decode(bytes: &[u8]) -> Result<(Option<Joints>, Option<Joints>, usize), Undecoded> {
        let mut reader = Reader::new(bytes);
        let (mut position, mut stiffness) = (None, None);
        for _ in 0..reader.map()? {
            match reader.key()? {
                "Position" => position = Some(Joints(reader.floats::<JOINTS>("Position")?)),
                "Stiffness" => stiffness = Some(Joints(reader.floats::<JOINTS>("Stiffness")?)),
                "LEye" => lights::<EYE>(&mut reader, "LEye")?,
                "REye" => lights::<EYE>(&mut reader, "REye")?,
                "LEar" => lights::<10>(&mut reader, "LEar")?,
                "REar" => lights::<10>(&mut reader, "REar")?,
                "Chest" => lights::<3>(&mut reader, "Chest")?,
                "LFoot" => lights::<3>(&mut reader, "LFoot")?,
                "RFoot" => lights::<3>(&mut reader, "RFoot")?,
                "Skull" => lights::<12>(&mut reader, "Skull")?,
                "Sonar" => drop(reader.booleans::<2>("Sonar")?),
                _ => return Err(Mistake::Unknown.into()),
            }
        }
        Ok((position, stiffness, reader.position()))
    }
}

fn lights<const N: usize>(reader: &mut Reader<'_>, key: &'static str) -> Result<(), Undecoded> {
    let lights = reader.floats::<N>(key)?;
    let are_fractions = lights.iter().all(|light| (0.0..=1.0).contains(light));
    if are_fractions { Ok(()) } else { Err(Mistake::Type { key }.into()) }
}

/// A share of the full brightness; a light that is no number is off.
fn share(light: f32) -> f32 {
    if light.is_nan() { 0.0 } else { light.clamp(0.0, 1.0) }
}

fn rgb(Light(red, green, blue): Light) -> [f32; 3] {
    [red, green, blue].map(share)
}

fn eye(light: Light) -> [f32; EYE] {
    let mut lights = [0.0; EYE];
    for (colour, lights) in rgb(light).into_iter().zip(lights.chunks_exact_mut(8)) {
        lights.fill(colour);
    }
    lights
}
