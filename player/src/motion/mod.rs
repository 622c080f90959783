//! Motion: from requested velocities and directions to joint targets.

mod body;
mod go_straight;
mod head;
mod kicker;
mod turn;
mod walk;

pub use body::Body;
pub use go_straight::GoStraight;
pub use head::Head;
pub use kicker::Kicker;
pub use turn::Turn;
pub use walk::Walk;
