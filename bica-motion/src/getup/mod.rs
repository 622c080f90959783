//! Getting up.
//!
//! Lists of postures, played at even speed from one to the next, but never faster than the joints turn. From the front the
//! arms push the hips up and back over the spread feet until the robot sits; from the back it throws the legs and sits up.
//! From there the way up is the same: it kneels up on one leg, pushing with the other side's hand, pulls the other leg in,
//! and rises. Before it stands it passes a *tuck* (both knees bent beyond [`TUCK_KNEE_ANGLE`]), by which a world without
//! forces may know a get-up, then [`STAND`], held for [`HOLD`] seconds. The postures began as those of real robots; where
//! they differ now they were searched for in a world with forces. Whom something blocks twice turns over before the next try.

mod frame;
mod postures;

use frame::Frame;
use postures::{RISE, SIT_UP_FROM_BACK, SIT_UP_FROM_FRONT, TURN_FROM_BACK, TURN_FROM_FRONT};

use crate::easing::mix;
use crate::fall::Direction;
use crate::joints::{Joint, Joints};
use crate::keyframes::Keyframe;
use crate::robot::Inertial;
use crate::speed::max_speed;
use crate::stand::{STAND, symmetric};

/// In the tuck both knees are bent further than this, rad.
pub const TUCK_KNEE_ANGLE: f32 = 1.8;
/// How long the stand at the end is held as part of the movement, s.
pub const HOLD: f32 = 0.8;
/// From the last posture to the stand, s.
const STRETCH: f32 = 0.8;
/// How hard the joints are held on the way to the first posture, where only limbs move; then fully.
const SOFT: f32 = 0.65;
/// How hard they are held at last.
const HELD: f32 = 0.8;
/// The torso's axis has risen if it rises more than this, as the sine of the angle to the ground.
const RISEN: f32 = 0.9;
/// And lies again, or does not even sit where it should, if it rises less than this.
const LYING: f32 = 0.5;
/// Who leans forward by more than this lies on its face, rad.
const ON_ITS_FACE: f32 = 1.0;
/// On the way from the back nobody may lie so from this posture on: by then the legs have rolled over who lay on a side.
const ROLLED: usize = 2;

/// What is played.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    UpFromFront,
    UpFromBack,
    TurnFromFront,
    TurnFromBack,
}

/// A get-up under way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GetUp {
    way: Way,
    mirrored: bool,
    from: Joints,
    /// Of the posture that it is on the way to.
    index: usize,
    /// Since the posture before, s.
    time: f32,
    /// From the posture before, s.
    seconds: f32,
    risen: bool,
    fell: bool,
}

impl GetUp {
    /// None: done at once.
    #[must_use]
    pub const fn none() -> Self {
        let (way, from) = (Way::UpFromBack, Joints([0.0; 25]));
        Self { way, mirrored: false, from, index: usize::MAX, time: 0.0, seconds: 0.0, risen: false, fell: true }
    }

    /// From where the robot lies, with the joints at `from` (measured angles, rad), after so many `failures`.
    ///
    /// From a side it is the way from the back: the legs roll the body over; whom they roll on its face stops at once.
    /// After a failure it is tried with left and right swapped; after the next it only turns over, away from what may block
    /// it, to be tried from there. It has turned when it has been limp for half a second then.
    #[must_use]
    pub fn new(lying: Direction, failures: u8, from: Joints) -> Self {
        let way = match (lying, failures % 3 == 2) {
            (Direction::Front, false) => Way::UpFromFront,
            (Direction::Front, true) => Way::TurnFromFront,
            (_, false) => Way::UpFromBack,
            (_, true) => Way::TurnFromBack,
        };
        let mirrored = failures % 2 == 1;
        let mut movement = Self { way, mirrored, from, index: 0, fell: false, ..Self::none() };
        movement.seconds = movement.needed();
        movement
    }

    /// Whether it is over: it stands or should, or has turned over, or fell again on the way.
    #[must_use]
    pub fn is_done(&self) -> bool {
        let rise = match self.way {
            Way::UpFromFront | Way::UpFromBack => RISE.len() + 2,
            Way::TurnFromFront | Way::TurnFromBack => 0,
        };
        self.fell || self.index >= self.begin().len() + rise
    }

    /// `dt` seconds later, with what the inertial unit feels: the targets and the stiffness of all joints. When done, the
    /// last posture, again and again.
    pub fn step(&mut self, inertial: &Inertial, dt: f32) -> (Joints, f32) {
        self.feel(inertial);
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
            return (self.from, HELD);
        }
        let ((_, goal), share) = (self.goal(), self.time / self.seconds);
        let mut targets = self.from;
        for (target, goal) in targets.0.iter_mut().zip(goal.0) {
            *target = mix(*target, goal, share);
        }
        (targets, self.stiffness())
    }

    /// Who had risen and lies again need not go on; nor need who does not sit when it is to rise from there, nor who came to
    /// lie on the wrong side.
    fn feel(&mut self, inertial: &Inertial) {
        let rise = libm::cosf(inertial.pitch) * libm::cosf(inertial.roll);
        self.risen |= rise > RISEN || self.index > self.begin().len();
        let on_face = self.way == Way::UpFromBack && self.index >= ROLLED && inertial.pitch > ON_ITS_FACE;
        self.fell |= self.risen && rise < LYING || on_face;
    }

    const fn begin(&self) -> &'static [Frame] {
        match self.way {
            Way::UpFromFront => &SIT_UP_FROM_FRONT,
            Way::UpFromBack => &SIT_UP_FROM_BACK,
            Way::TurnFromFront => &TURN_FROM_FRONT,
            Way::TurnFromBack => &TURN_FROM_BACK,
        }
    }

    /// The posture that it is on the way to, and the time meant for that, s.
    fn goal(&self) -> (f32, Joints) {
        let rise = self.index.wrapping_sub(self.begin().len());
        let Some(frame) = self.begin().get(self.index).or_else(|| RISE.get(rise)) else {
            return (if rise == RISE.len() { STRETCH } else { HOLD }, STAND);
        };
        let posture = frame.posture();
        (frame.seconds(), if self.mirrored { posture.mirrored() } else { posture })
    }

    /// How long the way to the next posture takes, s: as meant, or as long as the slowest joint needs.
    fn needed(&self) -> f32 {
        let (seconds, goal) = self.goal();
        let turn = |joint: Joint| (goal[joint] - self.from[joint]).abs() / max_speed(joint);
        Joint::ALL.into_iter().map(turn).fold(seconds, f32::max)
    }

    const fn stiffness(&self) -> f32 {
        match self.index {
            0 => SOFT,
            index if index > self.begin().len() + RISE.len() => HELD,
            _ => 1.0,
        }
    }
}

/// The posture in which to fall, for arms and legs: drawn in, the head away from the ground; with little stiffness
/// ([`Stiffness::Fall`](crate::stand::Stiffness::Fall)). Angles after HULKs 2025 (knees 110°, head −33° and +25°).
#[must_use]
pub const fn protection(falling: Direction) -> Keyframe {
    let head = match falling {
        Direction::Front => -33.0,
        Direction::Back | Direction::Left | Direction::Right => 25.0,
    };
    let posture = symmetric(head, [90.0, 20.0, 0.0, -45.0, 0.0], [0.0, 0.0, -50.0, 110.0, -60.0, 0.0]);
    Keyframe { seconds: 0.4, posture, stiffness: 0.3 }
}
