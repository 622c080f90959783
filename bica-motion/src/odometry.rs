//! Odometry from commanded angles, measured angles and gyroscope.

use glam::{Affine3A, Vec2};
use libm::atan2f;

use crate::joints::Joints;
use crate::kinematics::{ground_from_soles, sole};
use crate::model::{MAX_FEEDBACK_DELAY, RobotModel};
use crate::pose::Pose2;
use crate::robot::FootPressure;
use crate::side::Side;

pub use crate::model::Calibration;

/// Minimum force on both feet together while the robot stands, N.
const MIN_FORCE: f32 = 3.0;
/// Maximum displacement per cycle, m: three times the fastest foot's (0.6 m/s, HULKs 2025).
const MAX_DISPLACEMENT: f32 = 0.02;
/// Maximum turn per cycle, rad.
const MAX_TURN: f32 = 0.1;
/// Commanded displacement per cycle from which unchanged measured angles are considered stale, m.
const STALE_DISPLACEMENT: f32 = 1e-4;

/// Corrections of the odometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OdometryTuning {
    /// Difference of the forces on both feet, relative to their sum, from which the measured angles have full weight; above 0.
    pub full_trust: f32,
    /// Factor on the displacement, for x and y.
    pub distance_scale: Vec2,
    /// Factor on the turn.
    pub turn_scale: f32,
}

impl OdometryTuning {
    /// No corrections.
    pub const DEFAULT: Self = Self { full_trust: 0.5, distance_scale: Vec2::ONE, turn_scale: 1.0 };
}

/// Turn by the legs alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LegsTurn {
    /// Turn of the last cycle, rad.
    pub angle: f32,
    /// Turn rate by which that of the torso may differ, rad/s; see [`Calibration::max_turn_difference`].
    pub max_difference: f32,
}

/// Input of the odometry in one cycle.
#[derive(Clone, Copy, Debug)]
pub struct MotionInput<'a> {
    /// Joint angles commanded in the last cycle, rad; `None` if the robot does not stand or its legs are not stiff enough to
    /// follow.
    pub commanded: Option<&'a Joints>,
    /// Measured joint angles, rad.
    pub angles: &'a Joints,
    /// Pressure under the soles, left first.
    pub feet: [&'a FootPressure; 2],
    /// Turn of the torso since the last cycle by the gyroscope (rate × cycle time), rad; `None` without a gyroscope.
    pub gyro_turn: Option<f32>,
}

/// Pose of the ground frame (see [`ground_from_robot`](crate::kinematics::ground_from_robot)), integrated over time.
///
/// Method: the foot that bears more weight does not move, so the motion of the other foot relative to it is motion over
/// the ground. This holds in walking, kicking and standing. Three sources are fused:
/// - The *commanded* angles, delayed by the joints' feedback delay, predict the motion.
/// - The *measured* angles correct the prediction. Their weight grows with the difference of the forces on both feet: a foot
///   that bears all weight does not slip. Measurements that are impossible or stale have no weight.
/// - The *gyroscope* measures the turn, because slip falsifies the turn of the legs. A turn of exactly zero indicates a
///   broken gyroscope; then the turn of the legs is used.
///
/// While neither foot measures contact, only the commanded angles count; the lower foot is the support foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Odometry {
    calibration: &'static Calibration,
    pose: Pose2,
    soles: Option<[Affine3A; 2]>,
    /// Soles by the commanded angles of the last cycles, the newest first.
    commanded: [Option<[Affine3A; 2]>; MAX_FEEDBACK_DELAY + 1],
    support: Option<Side>,
    legs_turn: f32,
    model: &'static RobotModel,
}

impl Odometry {
    /// Odometry at the origin.
    #[must_use]
    pub const fn new(model: &'static RobotModel, calibration: &'static Calibration) -> Self {
        let commanded = [None; MAX_FEEDBACK_DELAY + 1];
        Self { calibration, pose: Pose2::ORIGIN, soles: None, commanded, support: None, legs_turn: 0.0, model }
    }

    /// Sets the scales to use from now on.
    pub const fn set_calibration(&mut self, calibration: &'static Calibration) {
        self.calibration = calibration;
    }

    /// Current ground frame in the ground frame of the first step.
    #[must_use]
    pub const fn pose(&self) -> Pose2 {
        self.pose
    }

    /// Foot that bears most of the weight; `None` in the air or before the first step.
    #[must_use]
    pub const fn support(&self) -> Option<Side> {
        self.support
    }

    /// Turn of the last cycle by the support leg alone; the gyroscope has no part in it.
    #[must_use]
    pub const fn legs_turn(&self) -> LegsTurn {
        LegsTurn { angle: self.legs_turn, max_difference: self.calibration.max_turn_difference }
    }

    /// Processes one cycle; returns the current ground frame in the ground frame of the last cycle.
    ///
    /// NaN and infinite inputs are ignored. Without any valid source the motion is zero.
    pub fn step(&mut self, input: &MotionInput<'_>) -> Pose2 {
        self.step_tuned(input, &OdometryTuning::DEFAULT)
    }

    /// Processes one cycle as [`step`](Self::step) does, with corrections of the caller.
    pub fn step_tuned(&mut self, input: &MotionInput<'_>, tuning: &OdometryTuning) -> Pose2 {
        let soles = Side::BOTH.map(|side| sole(self.model, side, input.angles));
        let before = self.soles.replace(soles);
        self.commanded.rotate_right(1);
        self.commanded[0] = input.commanded.map(|angles| Side::BOTH.map(|side| sole(self.model, side, angles)));
        let (support, trust) = support(input.feet.map(FootPressure::total), tuning.full_trust);
        self.support = support;
        let delay = self.model.feedback_delay.cycles();
        let delayed = self.commanded[delay].zip(self.commanded[delay - 1]);
        let commanded = delayed.and_then(|(before, now)| {
            let side = support.unwrap_or_else(|| lower(&now));
            scaled(motion(side, &before, &now), self.calibration.commanded_scale)
        });
        let measured = before.zip(support).and_then(|(before, side)| {
            let stale = before == soles && commanded.is_some_and(|it| it.position.length() > STALE_DISPLACEMENT);
            scaled(motion(side, &before, &soles), self.calibration.measured_scale).filter(|_| !stale)
        });
        let mut motion = match (commanded, measured) {
            (Some(commanded), Some(measured)) => mix(commanded, measured, trust),
            (one, other) => one.or(other).unwrap_or(Pose2::ORIGIN),
        };
        self.legs_turn = motion.heading;
        // The comparison is false for NaN.
        if let Some(turn) = input.gyro_turn.filter(|turn| *turn != 0.0 && turn.abs() < MAX_TURN) {
            motion.heading = self.calibration.gyro_scale * turn;
        }
        motion.position *= tuning.distance_scale;
        motion.heading *= tuning.turn_scale;
        self.pose = self.pose * motion;
        motion
    }
}

/// The foot that bears more weight, if any, and the weight of its measured motion, 0 to 1.
fn support([left, right]: [f32; 2], full_trust: f32) -> (Option<Side>, f32) {
    let all = left + right;
    // The comparison is false for NaN.
    if all >= MIN_FORCE && all.is_finite() {
        let side = if left >= right { Side::Left } else { Side::Right };
        (Some(side), ((left - right).abs() / (full_trust * all)).min(1.0))
    } else {
        (None, 0.0)
    }
}

/// The foot that is lower in the robot frame.
fn lower([left, right]: &[Affine3A; 2]) -> Side {
    if left.translation.z <= right.translation.z { Side::Left } else { Side::Right }
}

/// Motion of the ground frame while one foot does not move.
fn motion(support: Side, before: &[Affine3A; 2], now: &[Affine3A; 2]) -> Pose2 {
    support_in_ground(support, before) * support_in_ground(support, now).inverse()
}

/// A motion with its displacement scaled; `None` if it is too fast for a robot.
fn scaled(motion: Pose2, scale: Vec2) -> Option<Pose2> {
    // The comparisons are false for NaN.
    let possible = motion.position.length() < MAX_DISPLACEMENT && motion.heading.abs() < MAX_TURN;
    possible.then(|| Pose2 { position: motion.position * scale, heading: motion.heading })
}

fn mix(from: Pose2, to: Pose2, share: f32) -> Pose2 {
    Pose2 {
        position: from.position.lerp(to.position, share),
        heading: from.heading + share * (to.heading - from.heading),
    }
}

/// The support sole in the ground frame.
fn support_in_ground(support: Side, soles: &[Affine3A; 2]) -> Pose2 {
    let [left, right] = soles;
    let sole = ground_from_soles(support, left, right) * soles[support.index()];
    let ahead = sole.matrix3.x_axis;
    Pose2::new(sole.translation.x, sole.translation.y, atan2f(ahead.y, ahead.x))
}
