//! The forward on a Booster K1 in the simulation league: the components of `bica-player-t1` for another body.
#![no_std]

#[path = "../../src/behaviour/mod.rs"]
pub mod behaviour;
#[path = "../../t1/src/forward.rs"]
mod forward;
#[path = "../../src/info.rs"]
pub mod info;
#[path = "../../t1/src/input/mod.rs"]
pub mod input;
#[path = "../../src/motion/mod.rs"]
pub mod motion;
#[path = "../../src/output/mod.rs"]
pub mod output;
#[path = "../../t1/src/perception/mod.rs"]
pub mod perception;
#[path = "../../src/strategy/mod.rs"]
pub mod strategy;

pub use bica_player_t1::{FIELD, senses};
pub use forward::Forward;

/// Model of the robot that the forward controls.
pub type Model = bica_motion::model::K1;

/// Height of the camera over the ground in a walking robot, m.
const CAMERA_HEIGHT: f32 = 0.86;

/// Values of the parameters that differ from the NAO's, as a tune file.
pub const PARAMETERS: &str = include_str!("../parameters.toml");
