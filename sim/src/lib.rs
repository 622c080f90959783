//! Worlds to run a robot in.
//!
//! A [`World`] gives what a robot gives, [`Sensors`](bica_motion::robot::Sensors), and takes what a robot takes,
//! [`Command`](bica_motion::robot::Command), one control cycle at a time. What is true in it, only its [`Referee`] tells.
//! The built-in world is [`kinematic`]: pure Rust, the same in every run for the same seed, and many times faster than real
//! time. With the feature `mujoco` there is a second one, in which forces are real.
//!
//! ```
//! use bica_motion::{joints::Joints, robot::{CameraId, Command, Lights}};
//! use bica_sim::{World, kinematic::KinematicWorld, setup::Setup};
//!
//! let mut world = KinematicWorld::new(&Setup { seed: 7, ..Setup::default() })?;
//! let mut targets = world.sensors().angles;
//! for _ in 0..100 {
//!     let sensors = world.sensors();
//!     if let Some(image) = sensors.image {
//!         assert_eq!(image.yuyv.len(), 320 * 240 * 2);
//!     }
//!     world.act(&Command { targets, stiffness: Joints::all(1.0), lights: Lights::default(), camera: CameraId::Top });
//! }
//! assert_eq!(world.now().as_millis(), 1000);
//! # Ok::<(), bica_sim::setup::SetupError>(())
//! ```
//!
//! The *field* frame has its origin at the centre mark on the carpet, x toward the goal that the robot attacks, y left,
//! z up. Metres, radians, seconds, kilograms and newtons.

#![cfg_attr(test, expect(clippy::float_cmp, reason = "what must be exact is compared exactly"))]

mod camera;
mod in_loop;
pub mod kinematic;
mod layout;
mod motor_heat;
#[cfg(feature = "mujoco")]
pub mod mujoco;
mod obstacle;
mod random;
pub mod referee;
mod segmentation;
mod sensor_model;
pub mod setup;
mod spectator;
mod transform;
mod verdict;
mod world;

pub use referee::Referee;
pub use segmentation::PixelLabel;
pub use spectator::{Picture, RenderError, SpectatorCamera, SpectatorView};
pub use world::{CYCLE, CYCLE_SECONDS, World};
