//! The built-in simulator: one humanoid, moved by the kinematics of its joints, on the field of 2009.
//!
//! Method: quasi-static. The lower foot carries the robot and stays where it is; the pose of the body follows from the
//! joint angles. Only the ball has a velocity. The simulator has no inertia and no contact forces, but it has the usual
//! causes of failure on a real robot: dead time and speed limits of the motors, slipping feet, falls, sensor noise, and
//! images of a full hall with motion blur, vignetting and varying exposure.

mod ball;
mod ball_motion;
mod body;
mod collision;
mod convex_hull;
mod foot_contact;
mod render;
mod world;

pub(crate) use self::render::PosedRobot;
pub use self::world::KinematicWorld;

use bica_motion::model::simulation::NAO;
use glam::Vec2;

use crate::setup::{Setup, SetupError};
use crate::{SpectatorView, World};

/// Creates the world of a NAO, with a velocity of the ball, m/s, field frame. The function is not generic, so it is
/// compiled and optimised with this crate, and not again with each program.
///
/// # Errors
/// If the setup has no place for a robot or the ball, or the velocity is not finite.
pub fn nao(setup: &Setup, velocity: Vec2) -> Result<Box<dyn SpectatorView>, SetupError> {
    let mut world = KinematicWorld::new(NAO, setup)?;
    if velocity != Vec2::ZERO {
        world.set_ball(world.referee().ball(), velocity)?;
    }
    Ok(Box::new(world))
}
