//! A humanoid as rigid bodies in MuJoCo, from the MJCF file of its model. With the feature `mujoco`.
//!
//! Method: rigid bodies with soft contacts (Todorov, Erez and Tassa 2012), time step 2 ms. Dead time of the motors, sensor delay
//! and sensor noise are modelled here; [`Physics`] holds their parameters.

mod contacts;
mod error;
mod fall_monitor;
mod humanoid;
mod model;
mod motors;
mod physics;
mod sensor_model;
mod soundness;
mod state;
#[cfg(test)]
mod tests;

pub use contacts::Contacts;
pub use error::Error;
pub use humanoid::Humanoid;
pub use model::{FLOOR, FreeJoint, Model, body_name, find};
pub use physics::{Fault, Physics};
pub use state::{Data, pose, write};
