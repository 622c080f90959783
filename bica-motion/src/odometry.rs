//! How far the robot has come, from its own joints.

use glam::{Affine3A, Vec2};
use libm::atan2f;

use crate::joints::Joints;
use crate::kinematics::{ground_from_soles, sole};
use crate::pose::Pose2;
use crate::robot::FootPressure;
use crate::side::Side;

/// Less force than this on both feet together is no ground, N.
const LEAST_FORCE: f32 = 3.0;

/// How the way that the legs tell differs from the way that the body goes: soles slip, and joints give way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calibration {
    /// True way over felt way, forward and left.
    pub way: Vec2,
    /// True turn over the turn that the gyroscope felt.
    pub turn: f32,
}

impl Calibration {
    /// What the legs tell is true, as in the built-in world.
    pub const EXACT: Self = Self { way: Vec2::ONE, turn: 1.0 };
    /// With real forces; found by trials in `MuJoCo`.
    pub const NAO: Self = Self { way: Vec2::ONE, turn: 1.0 };
}

/// The way of the ground frame (see [`ground_from_robot`](crate::kinematics::ground_from_robot)), summed up.
///
/// The foot with more weight on it does not move; so what the other one and the body do relative to it is motion over
/// the ground. That holds in any motion: walking, kicking or standing. It knows nothing of slipping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Odometry {
    calibration: &'static Calibration,
    pose: Pose2,
    soles: Option<[Affine3A; 2]>,
    support: Option<Side>,
}

impl Odometry {
    /// At the origin.
    #[must_use]
    pub const fn new(calibration: &'static Calibration) -> Self {
        Self { calibration, pose: Pose2::ORIGIN, soles: None, support: None }
    }

    /// Corrects by these numbers from now on.
    pub const fn wear(&mut self, calibration: &'static Calibration) {
        self.calibration = calibration;
    }

    /// The ground frame now, seen from the ground frame of the first step.
    #[must_use]
    pub const fn pose(&self) -> Pose2 {
        self.pose
    }

    /// The foot that carries most of the weight; `None` in the air or before the first step.
    #[must_use]
    pub const fn support(&self) -> Option<Side> {
        self.support
    }

    /// One cycle: returns the motion since the last one, the ground frame now seen from the one before.
    ///
    /// `angles` as measured. `turned` is the torso's turn in this cycle by the gyroscope, rad (rate × cycle time); it
    /// replaces the turn by the joints, which slipping falsifies. While no foot feels the ground the motion is zero.
    /// Angles or turns that are no numbers give no motion either.
    pub fn step(&mut self, angles: &Joints, left: &FootPressure, right: &FootPressure, turned: Option<f32>) -> Pose2 {
        let soles = Side::BOTH.map(|side| sole(side, angles));
        let before = self.soles.replace(soles);
        let (left, right) = (left.total(), right.total());
        let carrying = (left + right >= LEAST_FORCE).then_some(if left >= right { Side::Left } else { Side::Right });
        self.support = carrying;
        let (Some(before), Some(side)) = (before, carrying) else { return Pose2::ORIGIN };
        let mut motion = seen(side, &before) * seen(side, &soles).inverse();
        motion.position *= self.calibration.way;
        motion.heading = turned.map_or(motion.heading, |turned| self.calibration.turn * turned);
        if !(motion.position.is_finite() && motion.heading.is_finite()) {
            return Pose2::ORIGIN;
        }
        self.pose = self.pose * motion;
        motion
    }
}

/// The carrying sole in the ground frame.
fn seen(support: Side, soles: &[Affine3A; 2]) -> Pose2 {
    let [left, right] = soles;
    let sole = ground_from_soles(support, left, right) * soles[support.index()];
    let ahead = sole.matrix3.x_axis;
    Pose2::new(sole.translation.x, sole.translation.y, atan2f(ahead.y, ahead.x))
}
