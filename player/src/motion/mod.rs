//! Motion: from requested velocities and directions to joint targets.

mod body;
mod choice;
mod go_straight;
mod head;
mod kicker;
mod turn;
mod walk;

pub use body::{Body, Request};
pub use choice::{KickChoice, SideChoice};
pub use go_straight::GoStraight;
pub use head::{Head, HeadMotion};
pub use kicker::{KickTuning, Kicker};
pub use turn::Turn;
pub use walk::{Walk, WalkTuning};
