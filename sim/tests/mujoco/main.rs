//! The world with real forces against what is known of robot, ball and field.
#![cfg(feature = "mujoco")]
#![expect(clippy::float_cmp, reason = "what must be exact is compared exactly")]

mod ball;
mod determinism;
mod puppet;
mod sensing;
mod standing;
