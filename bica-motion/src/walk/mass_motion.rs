//! Motion of the centre of mass over the soles, from the measured joint angles.
//!
//! A torso on compliant legs also turns by the reaction to the swing leg. Its tilt and rates alone then say little about a fall, whereas
//! the velocity of the centre of mass changes only by forces from outside.

use glam::{Mat3, Vec2, Vec3};

use crate::kinematics::Skeleton;
use crate::model::RobotModel;
use crate::side::Side;
use crate::walk::Feedback;

/// Maximum distance of the DCM from a sole, m: beyond, no step helps.
const MAX_DCM: f32 = 1.0;

/// Centre of mass over a sole that does not move.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Motion {
    /// Position from the sole in the robot frame, m.
    from_sole: Vec3,
    /// Horizontal position from the sole, m: ahead of it and to its left.
    position: Vec2,
    /// Horizontal velocity, low-pass filtered, m/s.
    velocity: Vec2,
}

/// Motion of the centre of mass over each sole, left first; `None` if it is not measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MassMotion([Option<Motion>; 2]);

impl MassMotion {
    pub(super) const fn new() -> Self {
        Self([None; 2])
    }

    /// Processes the measurements of one cycle of `dt` s; `smoothing` is the weight of the old velocity.
    pub(super) fn update(&mut self, model: &'static RobotModel, feedback: &Feedback, smoothing: f32, dt: f32) {
        let skeleton = feedback.joints.as_ref().map(|angles| Skeleton::of(model, angles));
        let level = Mat3::from_rotation_y(feedback.pitch) * Mat3::from_rotation_x(feedback.roll);
        self.0 = Side::BOTH.map(|side| {
            let skeleton = skeleton.as_ref()?;
            let sole = skeleton.sole(side);
            let from_sole = skeleton.centre_of_mass() - Vec3::from(sole.translation);
            let ahead = (level * Vec3::from(sole.matrix3.x_axis)).truncate().normalize_or_zero();
            let seen = |vector: Vec3| {
                let level = (level * vector).truncate();
                Vec2::new(ahead.dot(level), ahead.perp_dot(level))
            };
            let before =
                self.0[side.index()].unwrap_or(Motion { from_sole, position: Vec2::ZERO, velocity: Vec2::ZERO });
            let moved = (from_sole - before.from_sole) / dt + feedback.gyro.cross(from_sole);
            let motion =
                Motion { from_sole, position: seen(from_sole), velocity: seen(moved).lerp(before.velocity, smoothing) };
            (motion.position + motion.velocity).is_finite().then_some(motion)
        });
    }

    /// DCM from a sole, m, ahead of it and to its left, for a pendulum of this frequency, 1/s.
    pub(super) fn dcm(&self, sole: Side, frequency: f32) -> Option<Vec2> {
        let motion = self.0[sole.index()]?;
        Some((motion.position + motion.velocity / frequency).clamp(Vec2::splat(-MAX_DCM), Vec2::splat(MAX_DCM)))
    }
}
