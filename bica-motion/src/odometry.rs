//! How far the robot has come: what it was commanded, what its legs did and what its gyroscope measured, fused.

use glam::{Affine3A, Vec2};
use libm::atan2f;

use crate::joints::Joints;
use crate::kinematics::{ground_from_soles, sole};
use crate::pose::Pose2;
use crate::robot::FootPressure;
use crate::side::Side;

/// Less force than this on both feet together is no ground, N.
const LEAST_FORCE: f32 = 3.0;
/// A foot that carries so much more than the other, as a share of all weight, stands firmly.
const FIRM: f32 = 0.5;
/// From a target to its trace in what joints measure, cycles of 10 ms. Source: 36 ms, B-Human 2023.
const LATE: usize = 4;
/// The most that a robot moves in a cycle, m: three times as fast as the fastest foot (0.6 m/s, HULKs 2025).
const MOST_WAY: f32 = 0.02;
/// The most that it turns in a cycle, rad.
const MOST_TURN: f32 = 0.1;
/// Legs that were commanded to move at least this far in a cycle, m, cannot measure exactly the same as before.
const MOVES: f32 = 1e-4;

/// How the way that the legs tell differs from the way that the body goes: soles slip, and joints give way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calibration {
    /// True way over the way measured by the legs, forward and left.
    pub measured_scale: Vec2,
    /// True way over the way that the legs were commanded to go, forward and left.
    pub commanded_scale: Vec2,
    /// True turn over the turn measured by the gyroscope.
    pub gyro_scale: f32,
}

impl Calibration {
    /// What the legs tell is true, as in the built-in world.
    pub const EXACT: Self = Self { measured_scale: Vec2::ONE, commanded_scale: Vec2::ONE, gyro_scale: 1.0 };
    /// With real forces; found by trials in `MuJoCo`. The body goes farther than its feet are commanded to: what they are commanded is
    /// by that much less ([`Parameters::velocity_scale`](crate::walk::Parameters::velocity_scale)).
    pub const NAO: Self = Self { commanded_scale: Vec2::new(1.14, 1.05), ..Self::EXACT };
}

/// What a robot knows about its motion in one cycle.
#[derive(Clone, Copy, Debug)]
pub struct MotionInput<'a> {
    /// What the joints were commanded in the last cycle, rad; none if the robot does not stand, or its legs need not follow.
    pub commanded: Option<&'a Joints>,
    /// What they measure, rad.
    pub angles: &'a Joints,
    /// Pressure under the soles, left first.
    pub feet: [&'a FootPressure; 2],
    /// The torso's turn by the gyroscope, rad (rate × cycle time); none without a gyroscope.
    pub gyro_turn: Option<f32>,
}

/// The way of the ground frame (see [`ground_from_robot`](crate::kinematics::ground_from_robot)), summed up.
///
/// The foot with more weight on it does not move; so what the other one and the body do relative to it is motion over
/// the ground. That holds in any motion: walking, kicking or standing. Three sources say what they do:
/// - what the joints were *commanded*, some cycles ago, is expected;
/// - what the legs *felt* corrects that by as much as one foot carries more than the other: then it is sure which one
///   stands, and it does not slip. Legs that measure the impossible, or nothing new, correct nothing;
/// - the *gyroscope* says how far the body turned, which slipping falsifies in the legs. It never says exactly nothing: then it
///   is broken, and the legs say it.
///
/// While no foot feels the ground only the commanded motion counts, with the foot to carry that is commanded to be lower.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Odometry {
    calibration: &'static Calibration,
    pose: Pose2,
    soles: Option<[Affine3A; 2]>,
    /// What was commanded before, the newest first.
    commanded: [Option<[Affine3A; 2]>; LATE + 1],
    support: Option<Side>,
}

impl Odometry {
    /// At the origin.
    #[must_use]
    pub const fn new(calibration: &'static Calibration) -> Self {
        Self { calibration, pose: Pose2::ORIGIN, soles: None, commanded: [None; LATE + 1], support: None }
    }

    /// Corrects by these numbers from now on.
    pub const fn set_calibration(&mut self, calibration: &'static Calibration) {
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
    /// What is no number does not count; where no source is left the motion is zero.
    pub fn step(&mut self, moved: &MotionInput<'_>) -> Pose2 {
        let soles = Side::BOTH.map(|side| sole(side, moved.angles));
        let before = self.soles.replace(soles);
        self.commanded.rotate_right(1);
        self.commanded[0] = moved.commanded.map(|commanded| Side::BOTH.map(|side| sole(side, commanded)));
        let (carrying, firm) = carrying(moved.feet.map(FootPressure::total));
        self.support = carrying;
        let commanded = self.commanded[LATE].zip(self.commanded[LATE - 1]).and_then(|(before, now)| {
            let side = carrying.unwrap_or_else(|| lower(&now));
            scaled(motion(side, &before, &now), self.calibration.commanded_scale)
        });
        let feedback = before.zip(carrying).and_then(|(before, side)| {
            let stale = before == soles && commanded.is_some_and(|commanded| commanded.position.length() > MOVES);
            scaled(motion(side, &before, &soles), self.calibration.measured_scale).filter(|_| !stale)
        });
        let mut motion = match (commanded, feedback) {
            (Some(commanded), Some(feedback)) => mix(commanded, feedback, firm),
            (one, other) => one.or(other).unwrap_or(Pose2::ORIGIN),
        };
        // False for what is no number, too.
        if let Some(gyro_turn) = moved.gyro_turn.filter(|gyro_turn| *gyro_turn != 0.0 && gyro_turn.abs() < MOST_TURN) {
            motion.heading = self.calibration.gyro_scale * gyro_turn;
        }
        self.pose = self.pose * motion;
        motion
    }
}

/// The foot that carries more, if any does, and how firmly it stands, 0 to 1.
fn carrying([left, right]: [f32; 2]) -> (Option<Side>, f32) {
    let all = left + right;
    // False for what is no number, too.
    if all >= LEAST_FORCE && all.is_finite() {
        let side = if left >= right { Side::Left } else { Side::Right };
        (Some(side), ((left - right).abs() / (FIRM * all)).min(1.0))
    } else {
        (None, 0.0)
    }
}

/// The foot that is lower under the torso.
fn lower([left, right]: &[Affine3A; 2]) -> Side {
    if left.translation.z <= right.translation.z { Side::Left } else { Side::Right }
}

/// How the ground frame moves while this foot stands.
fn motion(side: Side, before: &[Affine3A; 2], now: &[Affine3A; 2]) -> Pose2 {
    seen(side, before) * seen(side, now).inverse()
}

/// A motion with its way corrected; none if no robot moves like that.
fn scaled(motion: Pose2, way: Vec2) -> Option<Pose2> {
    // False for what is no number, too.
    let possible = motion.position.length() < MOST_WAY && motion.heading.abs() < MOST_TURN;
    possible.then(|| Pose2 { position: motion.position * way, heading: motion.heading })
}

fn mix(from: Pose2, to: Pose2, share: f32) -> Pose2 {
    Pose2 {
        position: from.position.lerp(to.position, share),
        heading: from.heading + share * (to.heading - from.heading),
    }
}

/// The carrying sole in the ground frame.
fn seen(support: Side, soles: &[Affine3A; 2]) -> Pose2 {
    let [left, right] = soles;
    let sole = ground_from_soles(support, left, right) * soles[support.index()];
    let ahead = sole.matrix3.x_axis;
    Pose2::new(sole.translation.x, sole.translation.y, atan2f(ahead.y, ahead.x))
}
