//! Tests of the dynamic simulator against known properties of robot, ball and field.

#[cfg(feature = "mujoco")]
mod ball;
#[cfg(feature = "mujoco")]
mod rising;
#[cfg(feature = "mujoco")]
mod seeing;
#[cfg(feature = "mujoco")]
mod sensing;
#[cfg(feature = "mujoco")]
mod sharing;
#[cfg(feature = "mujoco")]
mod soundness;
#[cfg(feature = "mujoco")]
mod standing;
#[cfg(feature = "mujoco")]
mod support;

/// Placeholder for the tests of this target in a build without the simulator, so that a report counts them as skipped.
#[cfg(not(feature = "mujoco"))]
#[test]
#[ignore = "needs the feature `mujoco`; `cargo xtask mujoco` installs its library"]
fn the_dynamic_simulator() {}
