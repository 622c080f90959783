//! Simulators of a humanoid on a soccer field of 2009.
//!
//! A [`World`] has the interface of a real robot: it supplies [`Sensors`](bica_motion::robot::Sensors) and executes a
//! [`Command`](bica_motion::robot::Command), one control cycle at a time. Ground truth is available only from its
//! [`Referee`]. The robot is a type parameter, a [model](bica_motion::model) as data. There are two simulators:
//!
//! | | [`kinematic`] | `mujoco` |
//! |---|---|---|
//! | robot | joint angles and foot contact, no forces | rigid bodies, friction, torque limits |
//! | dependencies | none | feature `mujoco` and MuJoCo's library |
//! | speed | many times real time | slower |
//!
//! Equal seeds and commands give equal results, bit for bit. Both share everything else: [`setup`], start positions, field
//! objects, camera model, sensor noise, motor temperatures, rules and [`referee`].
//!
//! Conventions: the *field* frame has its origin at the centre mark on the carpet, x toward the attacked goal, y left, z up.
//! The *robot* frame has its origin midway between the hip joints, x forward, y left, z up. Units are metres, radians,
//! seconds, kilograms and newtons.

#![cfg_attr(test, expect(clippy::float_cmp, reason = "values that must be exact are compared exactly"))]

mod actions;
mod camera;
pub mod faults;
mod field;
mod in_loop;
pub mod kinematic;
mod layout;
mod limb_motions;
pub mod match_field;
#[cfg(feature = "mujoco")]
pub mod mujoco;
mod obstacle;
mod placement;
mod random;
pub mod referee;
mod scene;
mod segmentation;
pub mod setup;
mod shared_image;
pub mod shot;
mod spectator;
mod world;

pub use referee::Referee;
pub use scene::{show_field, show_truth};
pub use segmentation::PixelLabel;
pub use shared_image::SharedImage;
pub use spectator::{Picture, RenderError, SpectatorCamera, SpectatorView};
pub use world::{CYCLE, CYCLE_SECONDS, World};

/// Robot of the unit tests.
#[cfg(test)]
use bica_motion::model::simulation::NAO as TEST_MODEL;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
