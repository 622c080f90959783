//! Standing on the foot that carries the body.
//!
//! Quasi-static: the lower sole carries. It stays where it is, flat on the ground, and everything else follows from the
//! joint angles. When the other sole comes to lie lower, by a little hysteresis, it carries from then on, from where it
//! is then; what it is tilted against the ground and off it fades away quickly, so that the torso never jumps.

use bica_motion::kinematics::Skeleton;
use bica_motion::pose::Pose2;
use bica_motion::side::Side;
use glam::{Affine3A, Mat3A, Quat, Vec3};
use libm::atan2f;

/// How much lower the other sole must be to carry, m.
const HYSTERESIS: f32 = 0.001;
/// Share of tilt and lift that is left after a cycle: a time constant of 30 ms.
const FADE: f32 = 0.716_5;
/// Cycles over which a slip is spread.
const SLIP_CYCLES: u32 = 8;
/// The middle of a sole, x in its own frame, m.
const SOLE_MIDDLE: Vec3 = Vec3::new(0.0227, 0.0, 0.0);

/// How the body stands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stance {
    support: Side,
    /// Where the carrying sole is on the ground.
    anchor: Pose2,
    /// What is left of its tilt when it came down.
    tilt: Quat,
    /// What is left of its height when it came down, m.
    lift: f32,
    /// The rest of a slip, per cycle.
    slip: Pose2,
    slip_cycles: u32,
}

impl Stance {
    /// Stands so that the robot frame's origin and heading are over `place`.
    pub(crate) fn under(place: Pose2, skeleton: &Skeleton) -> Self {
        let support = Side::Left;
        let standing = Self {
            support,
            anchor: Pose2::ORIGIN,
            tilt: Quat::IDENTITY,
            lift: 0.0,
            slip: Pose2::ORIGIN,
            slip_cycles: 0,
        };
        let robot = flat(&standing.robot(skeleton));
        Self { anchor: place * robot.inverse(), ..standing }
    }

    /// The foot that carries.
    pub(crate) const fn support(&self) -> Side {
        self.support
    }

    /// The robot frame's pose in the field frame.
    pub(crate) fn robot(&self, skeleton: &Skeleton) -> Affine3A {
        let residue = Affine3A::from_rotation_translation(self.tilt, Vec3::new(0.0, 0.0, self.lift));
        raised(&self.anchor) * residue * skeleton.sole(self.support).inverse()
    }

    /// Stands for one cycle with the body as it is now. A step begins with a slip as `draw_slip` says.
    pub(crate) fn step(&mut self, skeleton: &Skeleton, draw_slip: impl FnOnce() -> Pose2) {
        self.tilt = Quat::IDENTITY.slerp(self.tilt, FADE);
        self.lift *= FADE;
        if self.slip_cycles > 0 {
            self.slip_cycles -= 1;
            self.anchor = self.anchor * self.slip;
        }
        let robot = self.robot(skeleton);
        let [carrying, other] = [self.support, self.support.other()].map(|side| robot * skeleton.sole(side));
        let height = |sole: &Affine3A| sole.transform_point3(SOLE_MIDDLE).z;
        if height(&other) < height(&carrying) - HYSTERESIS {
            self.step_onto(&other, draw_slip());
        }
    }

    /// Moves without a step, as when pushed. Field frame, m.
    pub(crate) fn shift(&mut self, by: glam::Vec2) {
        self.anchor.position += by;
    }

    fn step_onto(&mut self, sole: &Affine3A, slip: Pose2) {
        self.support = self.support.other();
        self.anchor = flat(sole);
        let level = Mat3A::from_rotation_z(-self.anchor.heading) * sole.matrix3;
        self.tilt = Quat::from_mat3a(&level).normalize();
        self.lift = sole.translation.z;
        let share = 1.0 / SLIP_CYCLES as f32;
        self.slip = Pose2 { position: share * slip.position, heading: share * slip.heading };
        self.slip_cycles = SLIP_CYCLES;
    }
}

/// A pose seen from above: where its origin and its x axis are.
pub(crate) fn flat(pose: &Affine3A) -> Pose2 {
    let ahead = pose.matrix3.x_axis;
    Pose2 { position: pose.translation.truncate(), heading: atan2f(ahead.y, ahead.x) }
}

/// A pose on the ground as one in space.
pub(crate) fn raised(pose: &Pose2) -> Affine3A {
    Affine3A::from_translation(pose.position.extend(0.0)) * Affine3A::from_rotation_z(pose.heading)
}
