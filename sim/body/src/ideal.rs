//! Body that follows its targets exactly, without forces: for worlds that need no other package.

use bica_motion::joints::{JOINTS, Joints};
use bica_motion::kinematics::sole;
use bica_motion::model::RobotModel;
use bica_motion::pose::Pose2;
use bica_motion::robot::{Buttons, FootPressure, Inertial, Sensors};
use bica_motion::side::Side;
use glam::Vec3;

use crate::CYCLE_SECONDS;
use crate::transform::ground_pose;

/// Temperature of a motor without a load, °C.
const COOL: f32 = 38.0;
/// Height above the other sole from which a foot bears no weight, m. Without this limit the odometry would not detect steps.
const SWING: f32 = 0.002;
/// Gravity, m/s².
const GRAVITY: f32 = 9.81;

/// A humanoid whose joints move to their targets at most at their top speed. It always stands unless it is pushed over.
#[derive(Clone, Debug)]
pub struct IdealBody {
    model: &'static RobotModel,
    angles: Joints,
    /// Pose of the robot frame on the ground, world frame.
    robot: Pose2,
    fallen: bool,
    shakes: bool,
}

impl IdealBody {
    /// Creates a robot at the origin in a posture, rad.
    #[must_use]
    pub const fn new(model: &'static RobotModel, angles: Joints) -> Self {
        Self { model, angles, robot: Pose2::ORIGIN, fallen: false, shakes: false }
    }

    /// Pose of the robot on the ground, world frame: the foot that bears its weight does not slip.
    #[must_use]
    pub const fn ground_pose(&self) -> Pose2 {
        self.robot
    }

    /// Joint angles, rad.
    #[must_use]
    pub const fn angles(&self) -> &Joints {
        &self.angles
    }

    /// Pushes the robot over onto its face, or sets it upright.
    pub const fn push_over(&mut self, over: bool) {
        self.fallen = over;
    }

    /// Measurements of this cycle. The weight is on the lower foot, or on both.
    #[must_use]
    pub fn sensors(&self) -> Sensors<'static> {
        let [left, right] = Side::BOTH.map(|side| sole(self.model, side, &self.angles).translation.z);
        // A real sensor has noise: equal values in all cycles are those of a broken one.
        let noise = if self.shakes { 0.001 } else { 0.0 };
        Sensors {
            angles: self.angles,
            temperatures: Joints([COOL; JOINTS]),
            currents: Joints([0.0; JOINTS]),
            inertial: Inertial {
                pitch: if self.fallen { 1.5 } else { 0.0 },
                acceleration: Vec3::new(noise, 0.0, GRAVITY),
                ..Inertial::default()
            },
            left_foot: self.foot(left - right),
            right_foot: self.foot(right - left),
            buttons: Buttons::default(),
            image: None,
        }
    }

    /// Moves the joints for a cycle.
    pub fn act(&mut self, targets: &Joints) {
        let [left, right] = Side::BOTH.map(|side| sole(self.model, side, &self.angles));
        let (support, before) =
            if left.translation.z < right.translation.z { (Side::Left, left) } else { (Side::Right, right) };
        self.angles = self.angles.moved_toward(self.model, targets, CYCLE_SECONDS);
        let now = sole(self.model, support, &self.angles);
        self.robot = self.robot * ground_pose(&before) * ground_pose(&now).inverse();
        self.shakes = !self.shakes;
    }

    /// Forces under the four sensors of a foot, N, by its height above the other one, m.
    fn foot(&self, higher: f32) -> FootPressure {
        let share = if higher > SWING {
            0.0
        } else if higher < -SWING {
            1.0
        } else {
            0.5
        };
        let load = 0.25 * share * self.model.masses.total() * GRAVITY;
        FootPressure { front_left: load, front_right: load, rear_left: load, rear_right: load }
    }
}

#[cfg(test)]
mod tests {
    use bica_motion::joints::Joint;

    use super::*;
    use crate::TEST_MODEL;

    #[test]
    fn joints_move_at_most_at_their_top_speed() {
        let mut body = IdealBody::new(TEST_MODEL, TEST_MODEL.stand);
        let mut targets = TEST_MODEL.stand;
        targets[Joint::HeadYaw] += 1.0;
        body.act(&targets);
        let moved = body.angles()[Joint::HeadYaw] - TEST_MODEL.stand[Joint::HeadYaw];
        assert!(moved > 0.0 && moved < 0.2, "{moved}");
        (0..100).for_each(|_| body.act(&targets));
        assert_eq!(body.angles(), &targets);
    }

    #[test]
    fn a_raised_foot_bears_no_weight() {
        let mut posture = TEST_MODEL.stand;
        posture[Joint::LKneePitch] += 0.2;
        let sensors = IdealBody::new(TEST_MODEL, posture).sensors();
        assert!(sensors.left_foot.front_left.abs() < 1e-6, "{:?}", sensors.left_foot);
        let weight = 4.0 * sensors.right_foot.front_left;
        assert!((weight - 9.81 * TEST_MODEL.masses.total()).abs() < 0.01, "{weight} N");
    }
}
