//! The forward of RoboCup 2009: its components and its activation tree.
//!
//! [`Forward`] is the tree. It implements [`Robot`](bica::runner::Robot), so a [`Runner`](bica::runner::Runner) connects it
//! with a world. One cycle by hand is three lines:
//!
//! ```
//! # use bica::prelude::*;
//! # use bica::runner::Robot;
//! # use bica_player::Forward;
//! # fn cycle(robot: &mut Forward, sensors: &bica_motion::robot::Sensors<'_>, now: Instant) {
//! robot.sense(sensors).expect("the image fits");
//! robot.tick(now);
//! let command = robot.act();
//! # }
//! ```
#![no_std]

pub mod behaviour;
mod forward;
pub mod input;
#[cfg(feature = "league")]
pub mod league;
pub mod model;
pub mod motion;
pub mod output;
pub mod perception;
#[cfg(feature = "referee")]
pub mod referee;
pub mod robot;
pub mod roles;
pub mod shapes;
pub mod strategy;
#[cfg(feature = "referee")]
pub mod team;

pub use forward::{Forward, tunable};

/// Model of the robot that a new tree controls; [`set_model`](model::set_model) sets another one.
pub const MODEL: &RobotModel = NAO;

/// Field on which it plays.
pub use bica_field::FIELD;

use bica_motion::model::{NAO, RobotModel};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
