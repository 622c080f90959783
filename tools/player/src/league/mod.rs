//! Games in the league's server, `RCSSServerMJ`. It is not a simulator of this workspace, and renders no images.

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
