//! Input components: written before a tick, read by perception, motion and behaviour.

mod camera_input;
mod game_state;
#[path = "../../../src/input/health_monitor.rs"]
mod health_monitor;
#[path = "../../../src/input/robot_profile.rs"]
mod robot_profile;
#[path = "../../../src/input/robot_state.rs"]
mod robot_state;

pub use camera_input::CameraInput;
pub use game_state::GameState;
pub use health_monitor::{FaultReaction, HealthMonitor};
pub use robot_profile::{BodyProfile, ProfileChoice, RobotProfile};
pub use robot_state::{FootContact, RobotState};
