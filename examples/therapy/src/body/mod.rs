//! What moves, sounds and shines.

mod keys;
mod lights;
mod motors;
mod mover;
mod sound;
mod walk;

pub use lights::{Lights, Shining};
pub use motors::{Motors, REST};
pub use mover::{Mover, Tempo};
pub use sound::{Sound, Sounding};
pub use walk::Walk;
