//! Evaluation of vision on recorded images, colour calibration, and trials of the body.

pub mod calibrate;
pub mod camera_poses;
pub mod detection;
pub mod frame_io;
pub mod labels;
pub mod pictures;
pub mod profile;
pub mod scoring;
pub mod statistics;
mod table;
#[cfg(feature = "mujoco")]
mod trial;
pub mod trial_options;
