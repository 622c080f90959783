//! The forward of RoboCup 2009: its components and its tree.
//!
//! [`Forward`] is the robot's mind. A cycle is three lines:
//!
//! ```
//! # use bica::prelude::*;
//! # use bica_player::{Forward, act, sense};
//! # fn cycle(robot: &mut Forward, sensors: &bica_motion::robot::Sensors<'_>, now: Instant) {
//! sense(robot, sensors).expect("the image fits");
//! robot.tick(now);
//! let command = act(robot);
//! # }
//! ```
#![no_std]

pub mod behaviour;
mod forward;
pub mod input;
pub mod motion;
pub mod output;
pub mod perception;
pub mod strategy;

pub use forward::{Forward, act, sense};
