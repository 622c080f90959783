//! A forward that a referee commands through the `GameController`.
//!
//! [`TeamForward`] is its tree: the components of the forward, and above [`Player`](crate::behaviour::Player) the root
//! [`TeamPlayer`], whose states are those of the rules. [`GameController`] keeps what the referee sends, and [`Reporter`] answers.
//! Play with other robots is in [`team`](crate::team).
//! Sockets belong to the program: it passes the datagrams through an [`Inbox`] and into [`TeamSensors`].

mod field_pose;
mod game_controller;
mod go_to;
mod inbox;
mod interface;
mod order;
pub mod packet;
mod places;
mod reporter;
mod team_forward;
mod team_player;
mod whistle;

pub use field_pose::FieldPose;
pub use game_controller::GameController;
pub use go_to::{GoTo, Going};
pub use inbox::Inbox;
pub use interface::{Answer, Identity, Received, TeamCommand, TeamSensors};
pub use order::Order;
pub use reporter::Reporter;
pub use team_forward::TeamForward;
pub use team_player::TeamPlayer;
pub use whistle::Whistle;
