//! What a session does, step by step, as the robot runs it.

mod plan;
mod player;
mod step;

#[cfg(feature = "monitor")]
pub(crate) use plan::begins;
pub(crate) use plan::{DEEPEST, MOST_CLIPS, MOST_STEPS, Plan};
pub(crate) use player::Session;
pub(crate) use step::{Lamp, Movement, Signal, Step, Task, Until};
