//! Conversions between poses on the ground and poses in space, and between poses and velocities.

use bica_motion::fall::Direction;
use bica_motion::pose::Pose2;
use glam::{Affine3A, Mat3A, Quat, Vec2, Vec3};
use libm::atan2f;

use crate::CYCLE_SECONDS;

/// Projects a pose in space to the ground: its origin, and the heading of its x axis.
#[must_use]
pub fn ground_pose(pose: &Affine3A) -> Pose2 {
    let ahead = pose.matrix3.x_axis;
    Pose2 { position: pose.translation.truncate(), heading: atan2f(ahead.y, ahead.x) }
}

/// Converts a pose on the ground to a level pose in space at height 0.
#[must_use]
pub fn level_pose(pose: &Pose2) -> Affine3A {
    Affine3A::from_translation(pose.position.extend(0.0)) * Affine3A::from_rotation_z(pose.heading)
}

/// Computes the mean angular velocity between two orientations one control cycle apart, rad/s, in the rotating frame.
#[must_use]
pub fn angular_velocity(from: &Mat3A, to: &Mat3A) -> Vec3 {
    let turn = Quat::from_mat3a(&(from.transpose() * *to)).normalize();
    turn.to_scaled_axis() / CYCLE_SECONDS
}

/// Returns the side of the body to which a horizontal direction in the robot frame points.
#[must_use]
pub fn fall_direction(direction: Vec2) -> Direction {
    match (direction.x.abs() >= direction.y.abs(), direction.x >= 0.0, direction.y >= 0.0) {
        (true, true, _) => Direction::Front,
        (true, false, _) => Direction::Back,
        (false, _, true) => Direction::Left,
        (false, _, false) => Direction::Right,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn level_pose_projects_back_to_itself() {
        let pose = Pose2::new(1.5, -0.5, 2.0);
        let found = ground_pose(&level_pose(&pose));
        assert!(found.position.distance(pose.position) < 1e-6 && (found.heading - pose.heading).abs() < 1e-6);
    }

    #[test]
    fn angular_velocity_is_in_rotating_frame() {
        let from = Affine3A::from_rotation_x(0.4).matrix3;
        let to = from * Affine3A::from_rotation_y(0.02).matrix3;
        assert!((angular_velocity(&from, &to) - Vec3::new(0.0, 2.0, 0.0)).length() < 1e-3);
    }
}
