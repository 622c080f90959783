//! Session of the robot: its steps and the component that runs them.

mod plan;
mod player;
mod step;

#[cfg(feature = "monitor")]
pub(crate) use plan::begins;
pub(crate) use plan::{DEEPEST, MOST_CLIPS, MOST_STEPS, Plan};
pub(crate) use player::Session;
pub(crate) use step::{Lamp, Movement, Signal, Step, Task, Until};
