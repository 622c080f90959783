//! Fixed movements: lists of postures, played smoothly.

use crate::easing::{mix, smooth};
use crate::joints::Joints;

/// A posture to reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Keyframe {
    /// How long the way there takes, s, more than 0.
    pub seconds: f32,
    /// Angles, rad.
    pub posture: Joints,
    /// Stiffness of all joints on the way, 0 to 1.
    pub stiffness: f32,
}

/// How long a list of keyframes lasts, s.
#[must_use]
pub fn duration(frames: &[Keyframe]) -> f32 {
    frames.iter().map(|frame| frame.seconds).sum()
}

/// A movement under way. From each posture to the next the joints go from rest to rest, all in the same time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    frames: &'static [Keyframe],
    from: Joints,
    index: usize,
    time: f32,
}

impl Motion {
    /// No movement: done at once.
    #[must_use]
    pub const fn none() -> Self {
        Self { frames: &[], from: Joints([0.0; 25]), index: 0, time: 0.0 }
    }

    /// A movement through `frames` that begins with the joints at `from` (targets or measured angles, rad).
    #[must_use]
    pub const fn new(frames: &'static [Keyframe], from: Joints) -> Self {
        Self { frames, from, index: 0, time: 0.0 }
    }

    /// Whether the last posture is reached.
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.index >= self.frames.len()
    }

    /// The keyframe that it is on the way to, counted from 0; the number of frames when done.
    #[must_use]
    pub const fn index(&self) -> usize {
        self.index
    }

    /// `dt` seconds later: the targets and the stiffness of all joints. When done, the last posture, again and again;
    /// `None` only if there are no frames at all.
    pub fn step(&mut self, dt: f32) -> Option<(Joints, f32)> {
        if dt > 0.0 {
            self.time += dt;
        }
        while let Some(frame) = self.frames.get(self.index).filter(|frame| self.time >= frame.seconds) {
            self.time -= frame.seconds;
            self.from = frame.posture;
            self.index += 1;
        }
        let Some(frame) = self.frames.get(self.index) else {
            return self.frames.last().map(|last| (last.posture, last.stiffness));
        };
        let share = smooth(self.time / frame.seconds);
        let mut targets = self.from;
        for (target, goal) in targets.0.iter_mut().zip(frame.posture.0) {
            *target = mix(*target, goal, share);
        }
        Some((targets, frame.stiffness))
    }
}
