//! Steps of a session.

use bica::prelude::*;
use bica_motion::robot::Light;

/// A step. Numbers of steps count from 0; a step at or after the last one ends the session.
#[message]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// Begins a movement, at a share of its usual tempo, 0.2 to 1.
    Move(Movement, f32),
    /// Begins speech, which is a clip of sound.
    Speak(u16),
    /// Begins music, which is a clip of sound.
    Play(u16),
    /// Sets the volume, 0 to 1.
    Volume(f32),
    Light(Lamp, Light),
    /// Begins a few steps: forward and left, m, and a turn to the left, rad.
    Walk([f32; 3]),
    /// Waits, at most so many seconds.
    Wait(Until, f32),
    /// Shows a movement, whose highest posture is held for `hold` s, until the person has repeated it, at most `limit` s.
    /// Goes on at one of three steps: done, not done, nobody there.
    Exercise {
        movement: Movement,
        repetitions: u16,
        hold: f32,
        limit: f32,
        then: [u16; 3],
    },
    /// Goes on at a step.
    GoTo(u16),
    /// Goes back to a step until the steps from there on ran so many times. The index of the counter is the depth of the loop.
    Again {
        from: u16,
        times: u16,
        counter: u8,
    },
    /// Ends what runs.
    Stop(Task),
    /// Makes the arms and the head stiff or soft. The legs stay stiff: the robot stands.
    Stiffness(bool),
}

/// What is waited for.
#[message]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Until {
    Time,
    Ends(Task),
    Signal(Signal),
}

/// What can be pressed or touched: the button in the chest, the bumpers of the feet, the sensors of head and hands.
#[message]
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
#[message]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lamp {
    Eyes,
    Ears,
    Chest,
}

/// What runs beside the steps.
#[message]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    Movement,
    Speech,
    Music,
    Walk,
    All,
}

impl Task {
    /// Whether it is that task, or all.
    pub(crate) fn has(self, task: Self) -> bool {
        self == Self::All || self == task
    }
}

/// One of the seven movements of physiotherapy.
#[message]
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
    /// Movements of an upper arm, at which the check of exercises looks.
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
