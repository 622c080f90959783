//! What the robot receives.

mod patient_pose;

pub use patient_pose::PatientPose;
