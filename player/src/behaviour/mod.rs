//! Behaviour: from the root of the activation tree to single skills.

mod dribble;
mod face_ball;
mod fixmove;
mod follow_ball;
mod go_round;
mod line_up;
mod look_around;
mod player;
mod safety_guard;
mod search;
mod search_ball;
mod search_net;

pub use dribble::{Dribble, Dribbling};
pub use face_ball::{FaceBall, Facing};
pub use fixmove::Fixmove;
pub use follow_ball::{Approach, FollowBall, Stall};
pub use go_round::{Circling, GoRound};
pub use line_up::LineUp;
pub use look_around::{Glancing, LookAround};
pub use player::Player;
pub use safety_guard::SafetyGuard;
pub use search::Search;
pub use search_ball::SearchBall;
pub use search_net::SearchNet;

/// Time of a component that ran last so many milliseconds ago.
#[cfg(test)]
pub(crate) const fn test_time(since_run_ms: u64) -> bica::Time {
    let since_run = bica::Duration::from_millis(since_run_ms);
    bica::Time { now: bica::Instant::from_millis(since_run_ms), since_run, in_state: since_run }
}

/// Times of a run, some milliseconds after the previous one.
#[cfg(test)]
const fn time(since_run_ms: u64) -> bica::Time {
    bica::Time {
        now: bica::Instant::from_millis(since_run_ms),
        since_run: bica::Duration::from_millis(since_run_ms),
        in_state: bica::Duration::from_millis(since_run_ms),
    }
}
