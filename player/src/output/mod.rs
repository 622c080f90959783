//! Output components: written by motion and behaviour, read after a tick.

mod camera_selector;
mod motors;

pub use camera_selector::CameraSelector;
pub use motors::{JointCommand, Motors};
