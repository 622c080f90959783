//! Falling, lying and getting up.
//!
//! The simulator has no contact forces on the ground, so postures decide when a robot gets up: after a fall the robot
//! stands again once it has folded its legs and then holds a posture that balances on both soles.

use core::f32::consts::FRAC_PI_2;

use bica_motion::fall::Direction;
use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::Skeleton;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::Pose2;
use bica_motion::side::Side;
use glam::{Affine3A, Quat, Vec2, Vec3, Vec3A};

use super::balance::Balance;
use super::stance::Stance;
use bica_body::transform::level_pose;

/// Time from the loss of balance to the ground, cycles.
const FALLING: u32 = 60;
/// Time from a balanced posture on the ground to standing, cycles.
const RISING: u32 = 50;
/// Minimum time from the ground to standing, cycles.
const GETTING_UP: u32 = 250;

/// State of a robot that is not on its feet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fallen {
    model: &'static SimulatedModel,
    direction: Direction,
    /// Robot frame on the ground with the heading before the fall: where the robot lies and, later, stands up.
    pose: Pose2,
    /// Robot frame when the balance was lost, field frame.
    from: Affine3A,
    /// Cycles since then.
    cycles: u32,
    /// Cycles since the robot sat up, at most [`RISING`].
    sitting: u32,
    /// Whether the knees have been folded on the ground.
    folded: bool,
    /// Cycles in a posture that balances.
    rising: u32,
}

impl Fallen {
    /// Returns the start of a fall in a direction from a pose with a heading.
    pub(crate) fn new(model: &'static SimulatedModel, direction: Direction, from: Affine3A, heading: f32) -> Self {
        let axis = match direction {
            Direction::Front => Vec3A::X,
            Direction::Back => Vec3A::NEG_X,
            Direction::Left => Vec3A::Y,
            Direction::Right => Vec3A::NEG_Y,
        };
        let ground =
            from.translation + Affine3A::from_rotation_z(heading).transform_vector3a(axis * model.lying.fall_length);
        let pose = Pose2 { position: ground.truncate(), heading };
        Self { model, direction, pose, from, cycles: 0, sitting: 0, folded: false, rising: 0 }
    }

    /// Side to which the robot falls or fell.
    pub(crate) const fn direction(&self) -> Direction {
        self.direction
    }

    /// Robot frame on the ground with the heading before the fall.
    pub(crate) const fn pose(&self) -> Pose2 {
        self.pose
    }

    /// Pose of the robot frame in the field frame.
    pub(crate) fn robot(&self, skeleton: &Skeleton) -> Affine3A {
        if self.cycles < FALLING {
            let part = self.cycles as f32 / FALLING as f32;
            return between(&self.from, &self.lying(), part * part);
        }
        if self.rising > 0 {
            let standing = Stance::under(self.pose, skeleton).robot(skeleton);
            return between(&self.resting(), &standing, self.rising as f32 / RISING as f32);
        }
        self.resting()
    }

    /// Advances by one cycle. Returns the stance when the robot is on its feet again.
    ///
    /// The robot sits from the first cycle on in which both hips are bent enough. It stands after the knees were folded and a
    /// balanced posture was then held for 0.5 s, at the earliest 2.5 s after it reached the ground.
    pub(crate) fn step(&mut self, angles: &Joints, skeleton: &Skeleton) -> Option<Stance> {
        self.cycles += 1;
        if self.cycles < FALLING {
            return None;
        }
        let bent = [Joint::LHipPitch, Joint::RHipPitch].iter().all(|&hip| angles[hip] < -self.model.lying.sitting_hip);
        if bent || self.sitting > 0 {
            self.sitting = (self.sitting + 1).min(RISING);
        }
        self.folded |=
            [Joint::LKneePitch, Joint::RKneePitch].iter().all(|&knee| angles[knee] > self.model.lying.folded_knee);
        if !self.folded || !can_stand(self.model, angles, skeleton) {
            self.rising = 0;
            return None;
        }
        if self.cycles >= FALLING + GETTING_UP - RISING {
            self.rising += 1;
        }
        (self.rising >= RISING).then(|| Stance::under(self.pose, skeleton))
    }

    /// Displaces the robot along the ground. Field frame, m.
    pub(crate) fn shift(&mut self, by: Vec2) {
        self.pose.position += by;
    }

    fn resting(&self) -> Affine3A {
        between(&self.lying(), &self.leaning(self.model.lying.sitting_lean), self.sitting as f32 / RISING as f32)
    }

    fn lying(&self) -> Affine3A {
        self.leaning(FRAC_PI_2)
    }

    /// Returns the robot frame on the ground with the torso leaning toward the side of the fall, rad from upright.
    fn leaning(&self, angle: f32) -> Affine3A {
        let (turn, height) = match self.direction {
            Direction::Front => (Quat::from_rotation_y(angle), self.model.lying.front_height),
            Direction::Back => (Quat::from_rotation_y(-angle), self.model.lying.back_height),
            Direction::Left => (Quat::from_rotation_x(-angle), self.model.lying.side_height),
            Direction::Right => (Quat::from_rotation_x(angle), self.model.lying.side_height),
        };
        level_pose(&self.pose) * Affine3A::from_rotation_translation(turn, Vec3::new(0.0, 0.0, height))
    }
}

/// Returns whether the body would balance on level soles if it were put upright.
fn can_stand(model: &'static SimulatedModel, angles: &Joints, skeleton: &Skeleton) -> bool {
    let soles = Side::BOTH.map(|side| skeleton.sole(side));
    let level = soles.iter().all(|sole| sole.matrix3.z_axis.z > 0.95);
    let even = (soles[0].translation.z - soles[1].translation.z).abs() < 0.01;
    let bent = |knee: Joint| model.lying.rising_knee.contains(angles[knee]);
    let ground = Affine3A::from_translation(Vec3::new(0.0, 0.0, -soles[0].translation.z));
    let soles = soles.map(|sole| ground * sole);
    let balance = Balance::new(model, soles, Side::Left, skeleton.centre_of_mass());
    level && even && bent(Joint::LKneePitch) && bent(Joint::RKneePitch) && balance.offset_outside_support().is_none()
}

/// Interpolates between two poses.
fn between(from: &Affine3A, to: &Affine3A, part: f32) -> Affine3A {
    let rotation = |pose: &Affine3A| Quat::from_mat3a(&pose.matrix3).normalize();
    let position = from.translation.lerp(to.translation, part);
    Affine3A::from_rotation_translation(rotation(from).slerp(rotation(to), part), position.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;

    /// Returns the lowest height of the robot frame above the soles, m, among postures with these knees that balance.
    fn lowest_balanced_squat(knee: f32) -> f32 {
        let grid = |joint: Joint| {
            let range = TEST_MODEL.limits[joint];
            (0..60).map(move |i| range.min + (range.max - range.min) * i as f32 / 59.0)
        };
        let heights = grid(Joint::LHipPitch).flat_map(|hip| {
            grid(Joint::LAnklePitch).filter_map(move |ankle| {
                let mut angles = TEST_MODEL.stand;
                for side in Side::BOTH {
                    let leg = side.leg();
                    (angles[leg[2]], angles[leg[3]], angles[leg[4]]) = (hip, knee, ankle);
                }
                let skeleton = Skeleton::of(TEST_MODEL, &angles);
                let level = skeleton.sole(Side::Left).inverse();
                let soles = Side::BOTH.map(|side| level * skeleton.sole(side));
                let mass = level.transform_point3(skeleton.centre_of_mass());
                let upright = level.matrix3.z_axis.z > 0.0;
                let balance = Balance::new(TEST_MODEL, soles, Side::Left, mass);
                (upright && balance.offset_outside_support().is_none()).then_some(level.translation.z)
            })
        });
        heights.fold(f32::INFINITY, f32::min)
    }

    #[test]
    fn squat_is_reachable_from_the_ground() {
        for (knee, height) in [(TEST_MODEL.lying.folded_knee, 0.145), (1.2, 0.177), (2.1, 0.126)] {
            let lowest = lowest_balanced_squat(knee);
            assert!((lowest - height).abs() < 0.003, "knees at {knee} rad: {lowest} m");
        }
    }

    #[test]
    fn only_robot_that_folded_its_knees_can_rise() {
        for (more, rises) in [(-0.02, false), (0.02, true)] {
            let (mut folded, bend) = (TEST_MODEL.stand, TEST_MODEL.lying.folded_knee + more);
            (folded[Joint::LKneePitch], folded[Joint::RKneePitch]) = (bend, bend);
            let mut fallen = Fallen::new(TEST_MODEL, Direction::Front, Affine3A::IDENTITY, 0.0);
            let postures = core::iter::repeat_n(folded, 100).chain(core::iter::repeat_n(TEST_MODEL.stand, 400));
            let stands =
                postures.filter(|angles| fallen.step(angles, &Skeleton::of(TEST_MODEL, angles)).is_some()).count() > 0;
            assert_eq!(stands, rises, "knees at {bend} rad");
        }
    }
}
