//! The forward on another body and other senses: Booster's T1 in the simulation league, where a player does not get images, but
//! directions and distances of ball, marks and players.
//!
//! Behaviours, planning, motion and output are the files of `bica-player`: they name what they use by its path in the crate, as
//! `crate::perception::BallDetector` and `crate::Model`. Here these names have other components behind them. The compiler checks that
//! they offer what the behaviours use.
#![no_std]

#[path = "../../src/behaviour/mod.rs"]
pub mod behaviour;
mod forward;
#[path = "../../src/info.rs"]
pub mod info;
pub mod input;
#[path = "../../src/motion/mod.rs"]
pub mod motion;
#[path = "../../src/output/mod.rs"]
pub mod output;
pub mod perception;
pub mod senses;
#[path = "../../src/strategy/mod.rs"]
pub mod strategy;

pub use forward::Forward;

/// Model of the robot that the forward controls.
pub type Model = bica_motion::model::T1;

/// Field on which it plays.
pub use bica_field::SSIM_2026 as FIELD;

/// Height of the camera over the ground in a walking robot, m.
const CAMERA_HEIGHT: f32 = 1.08;

/// Values of the parameters that differ from the NAO's, as a tune file.
pub const PARAMETERS: &str = include_str!("../parameters.toml");
