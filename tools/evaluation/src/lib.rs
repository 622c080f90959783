//! Evaluation of vision on recorded images, colour calibration, and trials of the body.

#[cfg(feature = "images")]
pub mod calibrate;
#[cfg(feature = "images")]
pub mod camera_calibration;
#[cfg(feature = "images")]
pub mod camera_poses;
#[cfg(feature = "images")]
pub mod detection;
#[cfg(feature = "images")]
pub mod frame_io;
#[cfg(feature = "images")]
pub mod labels;
#[cfg(feature = "images")]
pub mod pictures;
pub mod polar;
pub mod profile;
#[cfg(feature = "images")]
pub mod scoring;
pub mod statistics;
#[cfg(feature = "images")]
mod table;
#[cfg(feature = "mujoco")]
mod trial;
pub mod trial_options;
