//! Input components of the league: written before a tick.

mod camera_input;
mod game_state;

pub use camera_input::CameraInput;
pub use game_state::GameState;
