//! Falling, lying and getting up.

use core::f32::consts::FRAC_PI_2;

use bica_motion::fall::Direction;
use bica_motion::getup::TUCK_KNEE_ANGLE;
use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::Skeleton;
use bica_motion::pose::Pose2;
use bica_motion::side::Side;
use glam::{Affine3A, Quat, Vec3, Vec3A};

use super::balance::Balance;
use super::stance::Stance;
use crate::transform::level_pose;

/// From the loss of balance to the ground, cycles.
const FALLING: u32 = 60;
/// From a stand posture to standing, cycles.
const RISING: u32 = 50;
/// From the ground to standing, at least, cycles.
const GETTING_UP: u32 = 250;
/// Both hips bent further than this bring the torso off the ground, rad: the robot sits, and leans this far.
const SITTING: (f32, f32) = (1.05, 0.8);
/// Knees that stand up on are bent between these, rad: neither still tucked nor still stretched out.
const STANDING: (f32, f32) = (0.3, 1.4);
/// How far the middle between the hips comes from the feet, m.
const FALL_LENGTH: f32 = 0.22;

/// A robot that is not on its feet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Down {
    fall: Direction,
    /// Where it was and, later, stands up: the middle between the hips and the heading.
    place: Pose2,
    /// The robot frame when it lost its balance.
    from: Affine3A,
    /// Cycles since then.
    cycles: u32,
    /// Cycles since it sat.
    sitting: u32,
    tucked: bool,
    /// Cycles in a posture that can stand.
    rising: u32,
}

impl Down {
    /// Begins to fall from a pose in which it had that heading.
    pub(crate) fn new(fall: Direction, from: Affine3A, heading: f32) -> Self {
        let way = match fall {
            Direction::Front => Vec3A::X,
            Direction::Back => Vec3A::NEG_X,
            Direction::Left => Vec3A::Y,
            Direction::Right => Vec3A::NEG_Y,
        };
        let ground = from.translation + Affine3A::from_rotation_z(heading).transform_vector3a(way * FALL_LENGTH);
        let place = Pose2 { position: ground.truncate(), heading };
        Self { fall, place, from, cycles: 0, sitting: 0, tucked: false, rising: 0 }
    }

    /// Where it falls or fell to.
    pub(crate) const fn fall(&self) -> Direction {
        self.fall
    }

    /// Where it lies: the middle between the hips, and where its front faced before.
    pub(crate) const fn place(&self) -> Pose2 {
        self.place
    }

    /// The robot frame's pose in the field frame.
    pub(crate) fn robot(&self, skeleton: &Skeleton) -> Affine3A {
        if self.cycles < FALLING {
            let part = self.cycles as f32 / FALLING as f32;
            return between(&self.from, &self.lying(), part * part);
        }
        if self.rising > 0 {
            let standing = Stance::under(self.place, skeleton).robot(skeleton);
            return between(&self.resting(), &standing, self.rising as f32 / RISING as f32);
        }
        self.resting()
    }

    /// Lets one cycle pass; gives the stance when it is on its feet again.
    ///
    /// It sits from when the hips were bent enough on. To get up, the knees must be tucked once after the fall and then a posture be held that can stand, for half a
    /// second and not before 2.5 s on the ground.
    pub(crate) fn step(&mut self, angles: &Joints, skeleton: &Skeleton) -> Option<Stance> {
        self.cycles += 1;
        if self.cycles < FALLING {
            return None;
        }
        let bent = [Joint::LHipPitch, Joint::RHipPitch].iter().all(|&hip| angles[hip] < -SITTING.0);
        if bent || self.sitting > 0 {
            self.sitting = (self.sitting + 1).min(RISING);
        }
        self.tucked |= [Joint::LKneePitch, Joint::RKneePitch].iter().all(|&knee| angles[knee] > TUCK_KNEE_ANGLE);
        if !self.tucked || !can_stand(angles, skeleton) {
            self.rising = 0;
            return None;
        }
        if self.cycles >= FALLING + GETTING_UP - RISING {
            self.rising += 1;
        }
        (self.rising >= RISING).then(|| Stance::under(self.place, skeleton))
    }

    /// Moves along the ground. Field frame, m.
    pub(crate) fn shift(&mut self, by: glam::Vec2) {
        self.place.position += by;
    }

    fn resting(&self) -> Affine3A {
        between(&self.lying(), &self.leaning(SITTING.1), self.sitting as f32 / RISING as f32)
    }

    fn lying(&self) -> Affine3A {
        self.leaning(FRAC_PI_2)
    }

    /// On the ground, the torso leaning this far to where it fell, rad.
    fn leaning(&self, angle: f32) -> Affine3A {
        let (turn, height) = match self.fall {
            Direction::Front => (Quat::from_rotation_y(angle), 0.08),
            Direction::Back => (Quat::from_rotation_y(-angle), 0.09),
            Direction::Left => (Quat::from_rotation_x(-angle), 0.11),
            Direction::Right => (Quat::from_rotation_x(angle), 0.11),
        };
        level_pose(&self.place) * Affine3A::from_rotation_translation(turn, Vec3::new(0.0, 0.0, height))
    }
}

/// Whether the body would stand on level soles if it were put upright.
fn can_stand(angles: &Joints, skeleton: &Skeleton) -> bool {
    let soles = Side::BOTH.map(|side| skeleton.sole(side));
    let level = soles.iter().all(|sole| sole.matrix3.z_axis.z > 0.95);
    let even = (soles[0].translation.z - soles[1].translation.z).abs() < 0.01;
    let bent = |knee: Joint| (STANDING.0..STANDING.1).contains(&angles[knee]);
    let ground = Affine3A::from_translation(Vec3::new(0.0, 0.0, -soles[0].translation.z));
    let soles = soles.map(|sole| ground * sole);
    let balance = Balance { soles, support: Side::Left, mass: skeleton.centre_of_mass() };
    level && even && bent(Joint::LKneePitch) && bent(Joint::RKneePitch) && balance.lost().is_none()
}

fn between(from: &Affine3A, to: &Affine3A, part: f32) -> Affine3A {
    let turn = |pose: &Affine3A| Quat::from_mat3a(&pose.matrix3).normalize();
    let place = from.translation.lerp(to.translation, part);
    Affine3A::from_rotation_translation(turn(from).slerp(turn(to), part), place.into())
}
