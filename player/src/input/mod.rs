//! Input components: written before a tick, read by perception, motion and behaviour.

mod camera_input;
mod colour_limits;
mod colours;
mod game_state;
mod health_monitor;
mod robot_profile;
mod robot_state;

pub use camera_input::{CameraInput, FrameTooLarge, IMAGE_BYTES};
pub use colour_limits::{BlueLimits, GreenLimits, OrangeLimits, WhiteLimits, YellowLimits};
pub use colours::Colours;
pub use game_state::GameState;
pub use health_monitor::{FaultReaction, HealthMonitor};
pub use robot_profile::{BodyProfile, ProfileChoice, RobotProfile};
pub use robot_state::{FootContact, RobotState};
