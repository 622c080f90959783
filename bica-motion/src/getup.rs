//! Getting up.
//!
//! A get-up is a list of key postures ([`RobotModel::get_up`]), linearly interpolated and slowed down where a joint would
//! exceed its maximum speed. From the front, the arms push the NAO's hips up and back over the spread feet until it sits.
//! From the back, it swings its legs and sits up. From sitting, both ways are the same: it kneels on one leg,
//! pushes with the opposite hand, pulls the other leg in and rises. Before it stands it passes a *tuck* with both knees bent
//! beyond [`TUCK_KNEE_ANGLE`]. The last posture is [`RobotModel::stand`], held for [`HOLD`] seconds.
//!
//! After two failed attempts the robot turns over before the next one, because an obstacle may block it.

use crate::easing::mix;
use crate::fall::Direction;
use crate::joints::{Joint, Joints};
use crate::keyframes::Keyframe;
use crate::model::{GetUpFrame, RobotModel};
use crate::robot::Inertial;

/// Minimum angle of both knees in the tuck, rad.
pub const TUCK_KNEE_ANGLE: f32 = 1.8;
/// Duration of the stand at the end of the motion, s.
pub const HOLD: f32 = 0.8;
/// Duration of the motion from the last key posture to the stand, s.
const STRETCH: f32 = 0.8;
/// Stiffness on the way to the first key posture, which moves only limbs; then 1.
const FIRST_STIFFNESS: f32 = 0.65;
/// Stiffness of the stand at the end.
const STAND_STIFFNESS: f32 = 0.8;
/// Vertical component of the torso's axis (unit vector) above which the torso has risen.
const RISEN_UPRIGHTNESS: f32 = 0.9;
/// Vertical component of the torso's axis (unit vector) below which a risen robot has fallen again.
const FALLEN_UPRIGHTNESS: f32 = 0.4;
/// Pitch of the torso above which the robot lies on its face, rad.
const FACE_DOWN_PITCH: f32 = 1.0;

/// Sequence of key postures.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Sequence {
    UpFromFront,
    UpFromBack,
    UpFromSide,
    TurnFromFront,
    TurnFromBack,
}

/// A get-up in progress.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GetUp {
    sequence: Sequence,
    mirrored: bool,
    from: Joints,
    /// Index of the posture that is being approached.
    index: usize,
    /// Time since the posture before, s.
    time: f32,
    /// Duration of the motion from the posture before, s.
    seconds: f32,
    risen: bool,
    failed: bool,
    model: &'static RobotModel,
}

impl GetUp {
    /// No get-up: done at once.
    #[must_use]
    pub const fn none(model: &'static RobotModel) -> Self {
        Self {
            sequence: Sequence::UpFromBack,
            mirrored: false,
            from: Joints([0.0; 25]),
            index: usize::MAX,
            time: 0.0,
            seconds: 0.0,
            risen: false,
            failed: true,
            model,
        }
    }

    /// A get-up of a robot that lies on side `lying` with its joints at `from` (measured angles, rad), after a number of
    /// `failures`.
    ///
    /// From a side a robot without a way of its own uses that from the back: its leg motion rolls the body onto the back. If the
    /// body rolls onto its face instead, the get-up stops at once. Every second attempt from front or back is mirrored. Every third
    /// attempt only turns the robot over, away from a possible obstacle.
    #[must_use]
    pub fn new(model: &'static RobotModel, lying: Direction, failures: u8, from: Joints) -> Self {
        let sequence = match (lying, failures % 3 == 2) {
            (Direction::Front, false) => Sequence::UpFromFront,
            (Direction::Front, true) => Sequence::TurnFromFront,
            (Direction::Left | Direction::Right, false) if !model.get_up.sit_up_from_side.is_empty() => {
                Sequence::UpFromSide
            }
            (_, false) => Sequence::UpFromBack,
            (_, true) => Sequence::TurnFromBack,
        };
        let mirrored = if sequence == Sequence::UpFromSide { lying == Direction::Left } else { failures % 2 == 1 };
        let mut movement = Self { sequence, mirrored, from, index: 0, failed: false, ..Self::none(model) };
        movement.seconds = movement.needed();
        movement
    }

    /// Whether the motion has ended: after its last posture, or because the robot fell again.
    #[must_use]
    pub fn is_done(&self) -> bool {
        let rise = match self.sequence {
            Sequence::TurnFromFront | Sequence::TurnFromBack => 0,
            _ => self.model.get_up.rise.len() + 2,
        };
        self.failed || self.index >= self.first_frames().len() + rise
    }

    /// Index of the key posture that is being approached, counted from the beginning of the motion; `None` if there is no get-up.
    #[must_use]
    pub fn index(&self) -> Option<usize> {
        (self.index != usize::MAX).then_some(self.index)
    }

    /// Advances by `dt` seconds; returns target angles (rad) and stiffness of all joints. When done, the last posture.
    pub fn step(&mut self, inertial: &Inertial, dt: f32) -> (Joints, f32) {
        self.check_progress(inertial);
        if dt > 0.0 {
            self.time += dt;
        }
        while !self.is_done() && self.time >= self.seconds {
            self.time -= self.seconds;
            self.from = self.goal().1;
            self.index += 1;
            self.seconds = self.needed();
        }
        if self.is_done() {
            return (self.from, STAND_STIFFNESS);
        }
        let ((_, goal), share) = (self.goal(), self.time / self.seconds);
        let mut targets = self.from;
        for (target, goal) in targets.0.iter_mut().zip(goal.0) {
            *target = mix(*target, goal, share);
        }
        (targets, self.stiffness())
    }

    /// Stops the motion if the robot has risen and lies again, does not sit at the start of the rise, or lies on its face
    /// on the way from the back or a side.
    fn check_progress(&mut self, inertial: &Inertial) {
        let [(_, pitch), (_, roll)] = [inertial.pitch, inertial.roll].map(libm::sincosf);
        let uprightness = pitch * roll;
        self.risen |= uprightness > RISEN_UPRIGHTNESS || self.index > self.first_frames().len();
        let turning = self.first_frames().len().saturating_sub(self.model.get_up.sit_up_from_back.len());
        let on_face = matches!(self.sequence, Sequence::UpFromBack | Sequence::UpFromSide)
            && self.index >= self.model.get_up.rolled_onto_back + turning
            && inertial.pitch > FACE_DOWN_PITCH;
        self.failed |= self.risen && uprightness < FALLEN_UPRIGHTNESS || on_face;
    }

    /// Key postures before the rise.
    const fn first_frames(&self) -> &'static [GetUpFrame] {
        match self.sequence {
            Sequence::UpFromFront => self.model.get_up.sit_up_from_front,
            Sequence::UpFromBack => self.model.get_up.sit_up_from_back,
            Sequence::UpFromSide => self.model.get_up.sit_up_from_side,
            Sequence::TurnFromFront => self.model.get_up.turn_from_front,
            Sequence::TurnFromBack => self.model.get_up.turn_from_back,
        }
    }

    /// The posture that is being approached, and the nominal duration of the motion to it, s.
    fn goal(&self) -> (f32, Joints) {
        let rise = self.index.wrapping_sub(self.first_frames().len());
        let Some(frame) = self.first_frames().get(self.index).or_else(|| self.model.get_up.rise.get(rise)) else {
            return (if rise == self.model.get_up.rise.len() { STRETCH } else { HOLD }, self.model.stand);
        };
        (frame.seconds(), frame.posture(self.model, self.mirrored))
    }

    /// Duration of the motion to the next posture, s: nominal, or as long as the slowest joint needs.
    fn needed(&self) -> f32 {
        let (seconds, goal) = self.goal();
        let turn = |joint: Joint| (goal[joint] - self.from[joint]).abs() / self.model.max_speeds[joint];
        Joint::ALL.into_iter().map(turn).fold(seconds, f32::max)
    }

    const fn stiffness(&self) -> f32 {
        match self.index {
            0 => FIRST_STIFFNESS,
            index if index > self.first_frames().len() + self.model.get_up.rise.len() => STAND_STIFFNESS,
            _ => 1.0,
        }
    }
}

/// Posture to take during a fall, see [`RobotModel::fall_postures`]. The stiffness of
/// [`Stiffness::Fall`](crate::stiffness::Stiffness::Fall) applies.
#[must_use]
pub const fn protection(model: &RobotModel, falling: Direction) -> Keyframe {
    match falling {
        Direction::Front => model.fall_postures.front,
        Direction::Back | Direction::Left | Direction::Right => model.fall_postures.other,
    }
}
