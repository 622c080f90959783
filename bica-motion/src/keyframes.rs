//! Motions through a list of key postures.

use crate::easing::{mix, smooth};
use crate::joints::Joints;

/// A key posture, and how to reach it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Keyframe {
    /// Duration of the motion to the posture, s, positive.
    pub seconds: f32,
    /// Joint angles at the end, rad.
    pub posture: Joints,
    /// Stiffness of all joints during the motion, 0 to 1.
    pub stiffness: f32,
}

/// Duration of a list of keyframes, s.
#[must_use]
pub fn duration(frames: &[Keyframe]) -> f32 {
    frames.iter().map(|frame| frame.seconds).sum()
}

/// Playback of keyframes. Between two postures all joints move from rest to rest in the same time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    frames: &'static [Keyframe],
    from: Joints,
    index: usize,
    time: f32,
}

impl Motion {
    /// An empty motion, which is done at once.
    #[must_use]
    pub const fn none() -> Self {
        Self { frames: &[], from: Joints([0.0; 25]), index: 0, time: 0.0 }
    }

    /// A motion through `frames` that begins with the joints at `from` (commanded or measured angles, rad).
    #[must_use]
    pub const fn new(frames: &'static [Keyframe], from: Joints) -> Self {
        Self { frames, from, index: 0, time: 0.0 }
    }

    /// Whether the last posture is reached.
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.index >= self.frames.len()
    }

    /// Index of the keyframe that is being approached; the number of keyframes when done.
    #[must_use]
    pub const fn index(&self) -> usize {
        self.index
    }

    /// Advances by `dt` seconds; returns target angles (rad) and stiffness of all joints. When done, the last posture;
    /// `None` only if there are no keyframes.
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
