//! The forward on other bodies and other senses: Booster's T1 and K1 in the simulation league, where a player does not get images, but
//! directions and distances of ball, marks and players.
//!
//! Behaviours, planning, motion and output are the files of `bica-player`: they name what they use by its path in the crate, as
//! `crate::perception::BallDetector` and `crate::MODEL`. Here these names have other components behind them. The compiler checks that
//! they offer what the behaviours use.
#![no_std]

#[path = "../../src/behaviour/mod.rs"]
pub mod behaviour;
mod forward;
#[path = "../../src/info.rs"]
pub mod info;
pub mod input;
#[path = "../../src/model.rs"]
pub mod model;
#[path = "../../src/motion/mod.rs"]
pub mod motion;
#[path = "../../src/output/mod.rs"]
pub mod output;
pub mod perception;
#[path = "../../src/roles/mod.rs"]
pub mod roles;
pub mod senses;
#[path = "../../src/strategy/mod.rs"]
pub mod strategy;

pub use forward::Forward;

/// Model of the robot that a new tree controls; [`set_model`](model::set_model) sets another one.
pub const MODEL: &bica_motion::model::RobotModel = bica_motion::model::T1;

/// Field on which it plays.
pub use bica_field::SSIM_2026 as FIELD;

/// Values of the parameters of a T1 that differ from the NAO's, as a tune file.
pub const T1_PARAMETERS: &str = include_str!("../t1.toml");

/// Those of a K1.
pub const K1_PARAMETERS: &str = include_str!("../k1.toml");
