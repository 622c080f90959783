//! Behaviour: from the root of the activation tree to single skills.

mod dribble;
mod face_ball;
mod fixmove;
mod follow_ball;
mod go_round;
mod look_around;
mod player;
mod safety_guard;
mod search_ball;
mod search_net;

pub use dribble::Dribble;
pub use face_ball::FaceBall;
pub use fixmove::Fixmove;
pub use follow_ball::FollowBall;
pub use go_round::GoRound;
pub use look_around::LookAround;
pub use player::Player;
pub use safety_guard::SafetyGuard;
pub use search_ball::SearchBall;
pub use search_net::SearchNet;
