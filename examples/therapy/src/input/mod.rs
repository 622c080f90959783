//! What the robot receives.

mod guard;
mod patient_pose;
mod signals;

pub use guard::{Guard, Guarding, Trouble};
pub use patient_pose::PatientPose;
pub use signals::{Pressed, Signals};
