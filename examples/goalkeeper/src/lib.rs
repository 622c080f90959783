//! A goalkeeper in the built-in world.
//!
//! - [`Goalkeeper`]: the state machine, drawn with VICODE step by step in `docs/goalkeeper.md`.
//! - [`Keeper`]: the activation tree, with the sensors and the command of the robot.
//! - [`skills`]: the components that this package adds to the forward's.
//! - [`shots`]: balls kicked at the goal, one or a hundred.
//! - [`cli`]: the program.

pub mod cli;
mod goalkeeper;
mod series;
pub mod shots;
pub mod skills;
mod tree;

pub use goalkeeper::Goalkeeper;
pub use tree::Keeper;
