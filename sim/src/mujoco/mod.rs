//! The dynamic simulator: a humanoid as rigid bodies in MuJoCo. With the feature `mujoco`.
//!
//! It implements the same [`World`](crate::World) as the kinematic simulator, from the same [`Setup`](crate::setup::Setup) and
//! with the same rules, but bodies have mass, soles slip, motors have torque limits, and a robot without balance falls.
//! Dead time of the motors, sensor delay and sensor noise are modelled here; [`Physics`] holds their parameters.
//!
//! ```no_run
//! use bica_motion::model::simulation::NAO;
//! use bica_motion::robot::Command;
//! use bica_sim::{World, setup::Setup, mujoco::{MujocoWorld, Physics}};
//! use glam::Vec2;
//!
//! # fn run() -> Result<(), bica_sim::mujoco::Error> {
//! let physics = Physics { friction: 0.7, dead_time: 0.04, cameras: false, ..Physics::of(NAO) };
//! let mut world = MujocoWorld::new(NAO, &Setup { seed: 7, ..Setup::default() }, &physics)?;
//! let stand = Command::new(NAO.stand, 1.0);
//! for cycle in 0..500 {
//!     if cycle == 200 {
//!         world.add_velocity(Vec2::new(0.0, 0.2));
//!     }
//!     world.act(&stand);
//! }
//! println!("falls: {}", world.referee().falls());
//! # Ok(())
//! # }
//! ```
//!
//! Method: rigid bodies with soft contacts (Todorov, Erez and Tassa 2012), time step 2 ms. The robot is the MJCF file of
//! its model; the field is generated from the same dimensions as in the kinematic simulator.

mod error;
mod model;
mod renderer;
mod robot_camera;
mod spectator;
mod stage;
mod world;

pub use bica_body::mujoco::{Fault, Physics};
pub use error::Error;
pub use stage::{Shown, Stage};
pub use world::MujocoWorld;

use bica_motion::model::simulation::NAO;
use glam::Vec2;

use crate::SpectatorView;
use crate::setup::Setup;

/// Creates the world of a NAO, with a velocity of the ball, m/s, field frame. The function is compiled and optimised
/// with this crate.
///
/// # Errors
/// If the setup has no place for a robot or the ball, or MuJoCo rejects the model.
pub fn nao(setup: &Setup, velocity: Vec2) -> Result<Box<dyn SpectatorView>, Error> {
    let mut world = MujocoWorld::new(NAO, setup, &Physics::of(NAO))?;
    if velocity != Vec2::ZERO {
        world.kick_ball(velocity);
    }
    Ok(Box::new(world))
}
