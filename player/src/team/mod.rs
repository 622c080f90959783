//! Play of several robots as a team.
//!
//! Each robot decides by itself, with what it has heard of the others: there is no captain. [`TeamComm`] writes its messages, within the
//! budget that the `GameController` shows; [`TeamInbox`] refuses what is no new message of the team; [`TeamMates`] keeps the newest message
//! of each player, [`TeamBall`] the ball by all sightings, and [`Roles`] decides the own part. [`TeamPlay`] plays it: the striker as the
//! forward does, the others by [`Positioning`].

mod ball;
mod codec;
mod comm;
mod election;
mod formation;
mod inbox;
mod mates;
mod message;
mod pacer;
mod positioning;
mod refusal;
mod roles;
mod team_play;

pub use ball::{Fusion, TeamBall};
pub use codec::MESSAGE_BYTES;
pub use comm::{News, TeamComm};
pub use election::Claiming;
pub use formation::Formation;
pub use inbox::TeamInbox;
pub use mates::{Mate, Silence, TeamMates};
pub use message::{Heard, Intention, PoseCovariance, Role, SeenBall, TeamMessage};
pub use positioning::Positioning;
pub use refusal::{Refusal, Refused};
pub use roles::{Reach, Roles};
pub use team_play::{Joining, TeamPlay};
