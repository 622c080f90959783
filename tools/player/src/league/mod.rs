//! Games in the league's server, `RCSSServerMJ`, which is neither a simulator of this workspace nor shows images.

mod game;
mod play;
mod start;
mod world;

pub(crate) use play::run;
