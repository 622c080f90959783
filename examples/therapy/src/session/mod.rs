//! What a session does, step by step, as the robot runs it.

mod plan;
mod player;
mod step;

pub use plan::{DEEPEST, MOST_CLIPS, MOST_STEPS, Plan};
pub use player::Session;
pub use step::{Lamp, Movement, Signal, Step, Tasks, Until};
