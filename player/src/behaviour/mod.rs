//! What the forward does: from the root of the activation tree to the single skills.

mod dribble;
mod face_ball;
mod fall_guard;
mod fixmove;
mod follow_ball;
mod go_round;
mod look_around;
mod player;
mod search_ball;
mod search_net;

pub use dribble::Dribble;
pub use face_ball::FaceBall;
pub use fall_guard::FallGuard;
pub use fixmove::Fixmove;
pub use follow_ball::FollowBall;
pub use go_round::GoRound;
pub use look_around::LookAround;
pub use player::Player;
pub use search_ball::SearchBall;
pub use search_net::SearchNet;
