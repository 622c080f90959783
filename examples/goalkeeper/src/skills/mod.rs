//! Components that the goalkeeper needs in addition to the forward's.

mod ball_path;
mod dive;
mod guard_post;

pub use ball_path::{BallPath, Crossing, Shooting};
pub use dive::Dive;
pub use guard_post::{GuardPost, Guarding};
