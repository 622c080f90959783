//! Steps of a session.

use bica::prelude::*;
use bica_motion::robot::Light;

/// A step. Steps are numbered from 0; a step at or after the last one ends the session.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// Begins a movement at a fraction of its usual tempo, 0.2 to 1.
    Move(Movement, f32),
    /// Begins to speak a clip of sound.
    Speak(u16),
    /// Begins to play a clip of sound as music.
    Play(u16),
    /// Sets the volume, 0 to 1.
    Volume(f32),
    Light(Lamp, Light),
    /// Begins a short walk: forward and left, m, and a turn to the left, rad.
    Walk([f32; 3]),
    /// Waits for an event, at most this time, s.
    Wait(Until, f32),
    /// Shows a movement until the person has repeated it, at most for `limit` s; its highest posture is held for `hold`
    /// s. Continues at one of three steps: done, not done, nobody there.
    Exercise {
        movement: Movement,
        repetitions: u16,
        hold: f32,
        limit: f32,
        then: [u16; 3],
    },
    /// Jumps to a step.
    GoTo(u16),
    /// Jumps back until the loop body has run `times` times. The nesting depth selects the counter.
    Again {
        from: u16,
        times: u16,
        counter: u8,
    },
    /// Ends a task.
    Stop(Task),
    /// Makes the arms and the head stiff or limp. The legs stay stiff: the robot stands.
    Stiffness(bool),
}

/// Event that ends a wait.
#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Until {
    Time,
    Ends(Task),
    Signal(Signal),
}

/// What can be pressed or touched: the button in the chest, the bumpers of the feet, the sensors of head and hands.
#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq, ParamEnum)]
pub enum Signal {
    Chest,
    Left,
    Right,
    Head,
    LeftHand,
    RightHand,
}

/// A light. Of the ears, which are blue, only the brightness is set.
#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lamp {
    Eyes,
    Ears,
    Chest,
}

/// Activity that runs in parallel to the steps.
#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    Movement,
    Speech,
    Music,
    Walk,
    All,
}

impl Task {
    /// Returns whether this task includes the other one.
    pub(crate) fn has(self, task: Self) -> bool {
        self == Self::All || self == task
    }
}

/// One of the seven movements of physiotherapy.
#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Movement {
    ArmsAlternately,
    ArmsTogether,
    ArmsOpen,
    TouchShoulder,
    TurnPalms,
    Nod,
    TurnHead,
}

impl Movement {
    /// Movements of an upper arm, which the check of exercises can judge.
    pub(crate) const JUDGED: &[(&str, Self)] = Self::NAMES.split_at(4).0;
    /// Every movement with its name in the session language.
    pub(crate) const NAMES: [(&'static str, Self); 7] = [
        ("arms_alternately", Self::ArmsAlternately),
        ("arms_together", Self::ArmsTogether),
        ("arms_open", Self::ArmsOpen),
        ("touch_shoulder", Self::TouchShoulder),
        ("turn_palms", Self::TurnPalms),
        ("nod", Self::Nod),
        ("turn_head", Self::TurnHead),
    ];
}
