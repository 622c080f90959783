//! Components that command the joints, the sound and the lights.

mod keys;
mod lights;
mod motors;
mod mover;
mod sound;
mod walk;

pub use lights::Shining;
pub use sound::Sounding;

pub(crate) use lights::Lights;
pub(crate) use motors::{Motors, REST};
pub(crate) use mover::Mover;
#[cfg(test)]
pub(crate) use mover::way;
pub(crate) use sound::Sound;
pub(crate) use walk::Walk;
