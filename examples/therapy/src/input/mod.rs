//! Components for the inputs of the robot.

mod guard;
mod patient_pose;
mod signals;

pub use signals::Pressed;

pub(crate) use guard::{Guard, Trouble};
pub(crate) use patient_pose::PatientPose;
pub(crate) use signals::Signals;
