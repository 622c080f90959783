//! The world with real forces against what is known of robot, ball and field.
#![cfg(feature = "mujoco")]

mod ball;
mod determinism;
mod rising;
mod seeing;
mod sensing;
mod standing;
mod support;
