//! Games in the league's server, `RCSSServerMJ`, which is neither a simulator of this workspace nor shows images.

mod client;
mod entry;
#[cfg(feature = "mujoco")]
mod film;
mod opponent;
mod play;
mod robot;
mod start;
mod world;

pub(crate) use play::{replay, run};
