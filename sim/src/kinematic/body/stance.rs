//! Standing on the support foot.
//!
//! Quasi-static: the lower sole is the support foot. It stays flat on the ground where it is, and the pose of the body follows
//! from the joint angles. When the other sole is lower by a hysteresis, it becomes the support foot where it was one cycle
//! before. Its tilt and height at touchdown decay exponentially, so that the pose of the torso is continuous.

use bica_motion::kinematics::Skeleton;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::Pose2;
use bica_motion::side::Side;
use glam::{Affine3A, Mat3A, Quat, Vec3};

use bica_body::transform::{ground_pose, level_pose};

/// Height by which the other sole must be lower to become the support foot, m.
const HYSTERESIS: f32 = 0.001;
/// Factor on tilt and height at touchdown per cycle: a time constant of 30 ms.
const DECAY: f32 = 0.716_5;
/// Cycles over which a slip is distributed.
const SLIP_CYCLES: u32 = 8;

/// Contact state of a standing body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stance {
    support: Side,
    /// Pose of the support sole on the ground, field frame.
    anchor: Pose2,
    /// Remaining tilt of the support sole since touchdown.
    tilt: Quat,
    /// Remaining height of the support sole since touchdown, m.
    height: f32,
    /// The other sole in the previous cycle, field frame.
    other: Affine3A,
    /// Slip per cycle.
    slip: Pose2,
    /// Cycles for which the slip continues.
    slip_cycles: u32,
}

impl Stance {
    /// Returns a stance in which the robot frame projects to `place`.
    pub(crate) fn under(place: Pose2, skeleton: &Skeleton) -> Self {
        let support = Side::Left;
        let mut standing = Self {
            support,
            anchor: Pose2::ORIGIN,
            tilt: Quat::IDENTITY,
            height: 0.0,
            other: Affine3A::IDENTITY,
            slip: Pose2::ORIGIN,
            slip_cycles: 0,
        };
        standing.anchor = place * ground_pose(&standing.robot(skeleton)).inverse();
        standing.other = standing.robot(skeleton) * skeleton.sole(support.other());
        standing
    }

    /// The support foot.
    pub(crate) const fn support(&self) -> Side {
        self.support
    }

    /// Pose of the robot frame in the field frame.
    pub(crate) fn robot(&self, skeleton: &Skeleton) -> Affine3A {
        let residue = Affine3A::from_rotation_translation(self.tilt, Vec3::new(0.0, 0.0, self.height));
        level_pose(&self.anchor) * residue * skeleton.sole(self.support).inverse()
    }

    /// Advances by one cycle with the current joint angles. `draw_slip` supplies the slip at touchdown.
    pub(crate) fn step(
        &mut self,
        model: &'static SimulatedModel,
        skeleton: &Skeleton,
        draw_slip: impl FnOnce() -> Pose2,
    ) {
        let middle = Vec3::new(model.extents.sole_middle, 0.0, 0.0);
        self.tilt = Quat::IDENTITY.slerp(self.tilt, DECAY);
        self.height *= DECAY;
        if self.slip_cycles > 0 {
            self.slip_cycles -= 1;
            self.anchor = self.anchor * self.slip;
        }
        let soles = [self.support, self.support.other()].map(|side| self.robot(skeleton) * skeleton.sole(side));
        let [support, other] = soles.map(|sole| sole.transform_point3(middle).z);
        if other < support - HYSTERESIS {
            self.switch_support(draw_slip());
        }
        self.other = self.robot(skeleton) * skeleton.sole(self.support.other());
    }

    /// Displaces the stance along the ground. Field frame, m.
    pub(crate) fn shift(&mut self, by: glam::Vec2) {
        self.anchor.position += by;
        self.other.translation += glam::Vec3A::from(by.extend(0.0));
    }

    /// Makes the other foot the support foot, at its pose of one cycle ago. At that time it still had its distance to
    /// the old support foot.
    fn switch_support(&mut self, slip: Pose2) {
        self.support = self.support.other();
        self.anchor = ground_pose(&self.other);
        let level = Mat3A::from_rotation_z(-self.anchor.heading) * self.other.matrix3;
        self.tilt = Quat::from_mat3a(&level).normalize();
        self.height = self.other.translation.z;
        let share = 1.0 / SLIP_CYCLES as f32;
        self.slip = Pose2 { position: share * slip.position, heading: share * slip.heading };
        self.slip_cycles = SLIP_CYCLES;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;
    use bica_motion::feet::{Foot, level_legs};

    /// Returns the body with level feet: x from the hips and lift, m, left first.
    fn body(feet: [(f32, f32); 2]) -> Skeleton {
        let foot = |(x, lift), y| Foot { pose: Pose2::new(x, y, 0.0), lift };
        let mut angles = TEST_MODEL.stand;
        let legs = level_legs(TEST_MODEL, &[foot(feet[0], 0.05), foot(feet[1], -0.05)], 0.215, 0.0);
        for (side, leg) in Side::BOTH.into_iter().zip(legs) {
            leg.write(TEST_MODEL, side, &mut angles);
        }
        Skeleton::of(TEST_MODEL, &angles)
    }

    /// Takes steps of 4 cm with alternating feet, 20 cycles each; returns robot frame and support sole of each cycle.
    fn walk(stance: &mut Stance, steps: usize) -> Vec<(Side, Affine3A, Affine3A)> {
        let mut poses = Vec::new();
        for step in 0..steps {
            for cycle in 0..20 {
                let part = cycle as f32 / 19.0;
                let lift = 0.02 * (1.0 - (2.0 * part - 1.0) * (2.0 * part - 1.0));
                let (swinging, carrying) = ((0.04 * part - 0.02, lift), (0.02 - 0.04 * part, 0.0));
                let feet = if step % 2 == 0 { [carrying, swinging] } else { [swinging, carrying] };
                let skeleton = body(feet);
                stance.step(TEST_MODEL, &skeleton, || Pose2::ORIGIN);
                let robot = stance.robot(&skeleton);
                poses.push((stance.support(), robot, robot * skeleton.sole(stance.support())));
            }
        }
        poses
    }

    #[test]
    fn support_foot_stays_and_torso_moves_by_step() {
        let skeleton = body([(0.02, 0.0), (-0.02, 0.0)]);
        let mut stance = Stance::under(Pose2::new(0.5, -0.3, 0.0), &skeleton);
        let seen = walk(&mut stance, 10);
        for pair in seen.windows(2) {
            let [(before, _, from), (after, _, to)] = pair else { continue };
            if before == after {
                assert!(ground_pose(from).position.distance(ground_pose(to).position) < 1e-5);
            }
        }
        let last = ground_pose(&seen[seen.len() - 1].1);
        assert!(last.position.distance(glam::Vec2::new(0.9, -0.3)) < 2e-3, "{last:?}");
        assert!(last.heading.abs() < 1e-3);
        assert!(
            seen.iter().any(|(side, ..)| *side == Side::Left) && seen.iter().any(|(side, ..)| *side == Side::Right)
        );
    }

    #[test]
    fn weight_shift_does_not_move_robot() {
        let mut stance = Stance::under(Pose2::ORIGIN, &Skeleton::of(TEST_MODEL, &TEST_MODEL.stand));
        for cycle in 0..1_000 {
            let skeleton = body([(0.001 * (cycle % 7) as f32, 0.0004 * (cycle % 3) as f32), (0.0, 0.0)]);
            stance.step(TEST_MODEL, &skeleton, || Pose2::new(1.0, 1.0, 1.0));
        }
        assert_eq!(stance.support(), Side::Left);
        let robot = ground_pose(&stance.robot(&Skeleton::of(TEST_MODEL, &TEST_MODEL.stand)));
        assert!(robot.position.length() < 1e-5 && robot.heading.abs() < 1e-5, "{robot:?}");
    }

    #[test]
    fn slip_is_distributed_over_cycles_and_complete() {
        let mut stance = Stance::under(Pose2::ORIGIN, &Skeleton::of(TEST_MODEL, &TEST_MODEL.stand));
        let right = body([(0.0, 0.01), (0.0, 0.0)]);
        let before = ground_pose(&stance.robot(&right));
        for cycle in 0..20 {
            let was = ground_pose(&stance.robot(&right));
            stance.step(TEST_MODEL, &right, || Pose2::new(0.008, 0.0, 0.0));
            let step = ground_pose(&stance.robot(&right)).position.distance(was.position);
            assert!(step < 0.002, "cycle {cycle}: {step}");
        }
        let after = ground_pose(&stance.robot(&right));
        assert!(((after.position - before.position).x - 0.008).abs() < 1e-4, "{before:?} {after:?}");
    }
}
