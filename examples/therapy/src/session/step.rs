//! Steps of a session.

use bica::prelude::*;
use bica_motion::robot::Light;

/// A step. Numbers of steps count from 0; a step at or behind the last one ends the session.
#[message]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// Begins a movement; `tempo` is a share of its usual one, 0.2 to 1.
    Move {
        /// The movement.
        movement: Movement,
        /// Share of the usual tempo.
        tempo: f32,
    },
    /// Begins speech, which is a clip of sound.
    Speak(u16),
    /// Begins music, which is a clip of sound.
    Play(u16),
    /// Sets the volume, 0 to 1.
    Volume(f32),
    /// Sets lights.
    Light(Lamp, Light),
    /// Begins a few steps: forward and left, m, and a turn to the left, rad.
    Walk([f32; 3]),
    /// Waits, at most so many seconds.
    Wait(Until, f32),
    /// Shows a movement until the person has repeated it; then goes on at the step for: done, not done, nobody there.
    Exercise {
        /// The movement that is shown.
        movement: Movement,
        /// Number of repetitions.
        repetitions: u16,
        /// Time for which the highest posture is held, s.
        hold: f32,
        /// Most time, s.
        limit: f32,
        /// Steps after it.
        then: [u16; 3],
    },
    /// Goes on at a step.
    GoTo(u16),
    /// Goes back to a step so many times, then goes on. `counter` counts.
    Again {
        /// First step of the loop.
        from: u16,
        /// Number of times that it runs, with the first.
        times: u16,
        /// Index of the counter: the depth of the loop.
        counter: u8,
    },
    /// Ends tasks.
    Stop(Tasks),
    /// Makes the arms and the head stiff or soft. The legs stay stiff: the robot stands.
    Stiffness(bool),
}

/// What is waited for.
#[message]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Until {
    /// The time.
    Time,
    /// The end of tasks.
    Ends(Tasks),
    /// A button or a touch.
    Signal(Signal),
}

/// What can be pressed or touched.
#[message]
#[derive(Clone, Copy, Debug, PartialEq, Eq, ParamEnum)]
pub enum Signal {
    /// The button in the chest.
    Chest,
    /// The bumper of the left foot.
    Left,
    /// The bumper of the right foot.
    Right,
    /// The sensors of the head.
    Head,
    /// The sensors of the left hand.
    LeftHand,
    /// The sensors of the right hand.
    RightHand,
}

impl Signal {
    /// Number of signals.
    pub const COUNT: usize = 6;
}

/// Lights.
#[message]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lamp {
    /// Both eyes.
    Eyes,
    /// Both ears, which are blue: only their brightness is set.
    Ears,
    /// The chest button.
    Chest,
}

/// A set of what runs beside the steps.
#[message]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each is in the set or not")]
pub struct Tasks {
    /// The movement.
    pub movement: bool,
    /// The speech.
    pub speech: bool,
    /// The music.
    pub music: bool,
    /// The walk.
    pub walk: bool,
}

impl Tasks {
    /// No task.
    pub const NONE: Self = Self { movement: false, speech: false, music: false, walk: false };
    /// All tasks.
    pub const ALL: Self = Self { movement: true, speech: true, music: true, walk: true };
}

/// One of the seven movements of physiotherapy.
#[message]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Movement {
    /// One arm up while the other goes down.
    ArmsAlternately,
    /// Both arms up and down.
    ArmsTogether,
    /// Both arms to the sides.
    ArmsOpen,
    /// A hand to the shoulder.
    TouchShoulder,
    /// The palms up and down.
    TurnPalms,
    /// The head up and down.
    Nod,
    /// The head left and right.
    TurnHead,
}

impl Movement {
    /// Every movement with its name in the session language.
    pub const NAMES: [(&'static str, Self); 7] = [
        ("arms_alternately", Self::ArmsAlternately),
        ("arms_together", Self::ArmsTogether),
        ("arms_open", Self::ArmsOpen),
        ("touch_shoulder", Self::TouchShoulder),
        ("turn_palms", Self::TurnPalms),
        ("nod", Self::Nod),
        ("turn_head", Self::TurnHead),
    ];
}
