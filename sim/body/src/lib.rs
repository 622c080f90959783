//! Body of a simulated humanoid, without its surroundings.
//!
//! - [`ideal`]: a body that follows its targets exactly.
//! - [`sensor_model`]: resolution, range and noise of the body's sensors.
//! - [`motor_heat`]: temperatures of the motors.
//! - `mujoco` (feature): rigid bodies, motors with dead time, contacts and falls.
//! - [`random`], [`transform`]: seeded random streams, and poses on the ground and in space.
//!
//! The robot is a type parameter, a [model](bica_motion::model) as data. Frames: the *world* frame is fixed to the floor, z up; the
//! *robot* frame has its origin midway between the hip joints, x forward, y left. Units are metres, radians, seconds, newtons.

#![cfg_attr(
    all(test, feature = "mujoco"),
    expect(clippy::float_cmp, reason = "values that must be exact are compared exactly")
)]

use core::time::Duration;

use bica_motion::fall::Direction;

pub mod ideal;
pub mod motor_heat;
#[cfg(feature = "mujoco")]
pub mod mujoco;
pub mod random;
pub mod sensor_model;
pub mod transform;

/// Period of the control cycle.
pub const CYCLE: Duration = Duration::from_millis(10);

/// Period of the control cycle, s.
pub const CYCLE_SECONDS: f32 = 0.01;

/// Posture of the robot: standing or fallen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Posture {
    /// On its feet.
    Upright,
    /// Falling or lying on the ground; the side to which it fell.
    Down(Direction),
}

/// Robot of the unit tests.
#[cfg(test)]
use bica_motion::model::simulation::NAO as TEST_MODEL;
