//! Message with the targets of a player's motors.

use std::fmt::Write;

use bica_motion::joints::Joints;

use super::body::{Body, VELOCITY_GAINS, effector};

/// Returns the message that moves all joints to their targets, rad, with a stiffness from 0 to 1. A target that is not finite
/// turns its motor off.
pub(crate) fn motors(body: &Body, targets: &Joints, stiffness: &Joints) -> String {
    let allowed = targets.clamp_to_limits(body.model);
    let mut message = String::with_capacity(64 * body.model.joints.len());
    for &joint in body.model.joints {
        let share = if targets[joint].is_finite() { stiffness[joint].clamp(0.0, 1.0) } else { 0.0 };
        let target = if share > 0.0 { allowed[joint].to_degrees() } else { 0.0 };
        let (position, velocity) = (share * body.model.mujoco.gains[joint], share * VELOCITY_GAINS[joint]);
        let name = effector(joint);
        // Writing to a string cannot fail.
        _ = write!(message, "({name} {target:.4} 0 {position:.3} {velocity:.3} 0)");
    }
    message
}

#[cfg(test)]
mod tests {
    use bica_motion::joints::Joint;

    use super::super::body::{K1, T1};
    use super::*;

    #[test]
    fn targets_are_in_degrees_within_the_limits() {
        let (mut targets, mut stiffness) = (Joints::all(0.5), Joints::all(0.5));
        (targets[Joint::LAnklePitch], targets[Joint::HeadPitch]) = (3.0, f32::NAN);
        stiffness[Joint::HeadYaw] = 7.0;
        let message = motors(T1, &targets, &stiffness);
        assert!(message.starts_with("(he1 28.6479 0 20.000 1.000 0)(he2 0.0000 0 0.000 0.000 0)"), "{message}");
        assert!(message.contains("(lle5 20.0535 0 275.000 1.000 0)"), "{message}");
        assert_eq!(message.matches('(').count(), 23);
        assert!(!motors(K1, &targets, &stiffness).contains("te1"), "a K1 has no waist");
    }
}
