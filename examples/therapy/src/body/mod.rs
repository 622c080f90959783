//! What moves, sounds and shines.

mod keys;
mod lights;
mod motors;
mod mover;
mod sound;

pub use lights::{Lights, Shining};
pub use motors::{Motors, REST};
pub use mover::{Mover, Tempo};
pub use sound::{Sound, Sounding};
