//! What a session does, step by step, as the robot runs it.

mod step;

pub use step::{Button, Lamp, Movement, Signal, Step, Task, Tasks, Until};
