//! What comes from outside: filled before a tick, read by perception.

mod colours;
mod eye;
mod measured;

pub use colours::Colours;
pub use eye::{EYE_BYTES, Eye, FrameTooLarge};
pub use measured::Measured;
