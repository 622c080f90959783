//! What goes out: written by behaviour and motion, read after a tick.

mod gaze;
mod motors;

pub use gaze::Gaze;
pub use motors::Motors;
