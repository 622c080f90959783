//! The messages.
//!
//! Units and frames are those of [`bica_motion::robot`]: radians, newtons, m/s², the torso's frame. Times are the
//! world's, in microseconds since its start.

use bica_field::GoalColour;
use bica_motion::joints::JOINTS;
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

use crate::receiver::Losses;

/// What the host says.
#[expect(clippy::large_enum_variant, reason = "there is no heap to box the sensors in")]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum ToRobot<'a> {
    /// Begins a game: the tree starts anew, and the robot answers with its greeting.
    Hello(Hello),
    /// Asks the robot to describe itself.
    Describe,
    /// A piece of the next image.
    #[serde(borrow)]
    Chunk(Chunk<'a>),
    /// What the robot senses now; after the pieces of the image, if a new one came.
    Sensors(Sensors),
    /// Puts the robot to a test.
    Trial(Trial),
    /// Asks how much of its stack the robot ever used.
    Stack,
}

/// What the robot says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum FromRobot<'a> {
    /// Its first words, and its answer to a hello.
    #[serde(borrow)]
    Greeting(Greeting<'a>),
    /// One fact about its tree.
    #[serde(borrow)]
    Fact(Fact<'a>),
    /// What the joints, lights and cameras are to do.
    Command(Command),
    /// How it is.
    #[serde(borrow)]
    Telemetry(Telemetry<'a>),
    /// How much of its stack it ever used.
    Stack(Stack),
}

/// How the robot's time passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub enum Pace {
    /// By its own clock: the tree is ticked at its rate, whether something new was sensed or not.
    Clock,
    /// By the world's: the tree is ticked once for every [`Sensors`], at the time that it bears.
    Lockstep,
}

/// Begins a game.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Hello {
    /// The host's [`SCHEMA`](crate::SCHEMA); the robot obeys no other.
    pub schema: u64,
    /// How time passes.
    pub pace: Pace,
    /// Colour of the goal to score in.
    pub attack: GoalColour,
}

/// A piece of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Chunk<'a> {
    /// The image's number.
    pub image: u32,
    /// Where the piece begins, bytes. Pieces come in order; 0 begins an image.
    pub at: u32,
    /// The piece.
    pub bytes: &'a [u8],
}

/// The image whose pieces came before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Picture {
    /// Its number.
    pub image: u32,
    /// Whether the bottom camera took it.
    pub bottom: bool,
    /// Width, px.
    pub width: u16,
    /// Height, px.
    pub height: u16,
}

/// What the robot senses.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct Sensors {
    /// When, µs.
    pub time_us: u64,
    /// Joint angles in the order of [`bica_motion::joints::Joint`].
    #[serde(deserialize_with = "crate::each::deserialize")]
    pub angles: [f32; JOINTS],
    /// Temperatures of the joints' motors, °C; NaN: not measured.
    #[serde(deserialize_with = "crate::each::deserialize")]
    pub temperatures: [f32; JOINTS],
    /// Currents of the joints' motors, A; NaN: not measured.
    #[serde(deserialize_with = "crate::each::deserialize")]
    pub currents: [f32; JOINTS],
    /// Angular velocity x, y, z; specific force x, y, z; roll; pitch.
    #[serde(deserialize_with = "crate::each::deserialize")]
    pub inertial: [f32; 8],
    /// Left sole front left, front right, rear left, rear right; then the right sole.
    #[serde(deserialize_with = "crate::each::deserialize")]
    pub feet: [f32; 8],
    /// Chest button, left bumper, right bumper.
    pub buttons: [bool; 3],
    /// The image, if a new one came.
    pub picture: Option<Picture>,
}

/// A test of what the robot does when things go wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub enum Trial {
    /// A component needs that much longer for each run, in ticks of the robot's fine clock; 0 ends the trial.
    Slow {
        /// Its place in the tree's list.
        component: u8,
        /// How much longer.
        ticks: u32,
    },
    /// A component panics when it next runs.
    Panic {
        /// Its place in the tree's list.
        component: u8,
    },
}

/// The robot's first words.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct Greeting<'a> {
    /// The robot's [`SCHEMA`](crate::SCHEMA).
    pub schema: u64,
    /// The tree's name.
    pub name: &'a str,
    /// How often the tree is meant to be ticked, 1/s.
    pub cycle_hz: f32,
    /// How many components it has.
    pub components: u8,
    /// Ticks of the robot's fine clock in a second.
    pub fine_hz: u32,
    /// How often it had to start anew since it was switched on.
    pub restarts: u32,
    /// Why it last had to; empty if it never had.
    pub reason: &'a str,
}

/// One fact about the tree. All numbers are places in lists, as in [`bica_core::graph`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum Fact<'a> {
    /// A component.
    Component {
        /// Its place in the tree's list; components come in that order.
        index: u8,
        /// Its name.
        name: &'a str,
        /// Declared runs per second; none: in every cycle.
        hz: Option<f32>,
        /// Declared time for a run, µs.
        budget_us: Option<f32>,
        /// Whether it is the root.
        root: bool,
    },
    /// A component activates another.
    Link {
        /// Who.
        from: u8,
        /// Whom.
        to: u8,
        /// Written (stepped after), or read (stepped before).
        modulation: bool,
        /// The only state in which it does; none: always.
        state: Option<u8>,
    },
    /// A state of a component.
    State {
        /// Whose.
        component: u8,
        /// Its place in the component's list; states come in that order.
        index: u8,
        /// Its name.
        name: &'a str,
        /// Whether the machine begins here.
        initial: bool,
    },
    /// A way from one state to another.
    Transition {
        /// Whose.
        component: u8,
        /// The state that it leaves.
        from: u8,
        /// The state that it enters.
        to: u8,
        /// Its name.
        name: &'a str,
    },
    /// All is said.
    End {
        /// Facts before this one.
        facts: u16,
    },
}

/// What the robot is to do.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct Command {
    /// The time of the sensors that it follows, µs.
    pub time_us: u64,
    /// Wanted joint angles.
    pub targets: [f32; JOINTS],
    /// How hard each joint holds its target, 0 to 1.
    pub stiffness: [f32; JOINTS],
    /// Chest, left eye, right eye; red, green and blue of each, 0 to 1.
    pub lights: [f32; 9],
    /// Whether images of the bottom camera are wanted.
    pub bottom: bool,
}

/// How much of its stack the robot ever used, by the paint that is gone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Stack {
    /// Bytes that were used at most.
    pub deepest: u32,
    /// Bytes that there are.
    pub room: u32,
}

/// How the robot is, after a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Telemetry<'a> {
    /// The cycle's time, µs.
    pub time_us: u64,
    /// Whether it stands safe, since nothing was heard for too long.
    pub safe: bool,
    /// Cycles that began late, since it was switched on or restarted.
    pub late: u32,
    /// Images of which a piece was missing.
    pub torn: u32,
    /// Packets heard by the robot.
    pub losses: Losses,
    /// Fine ticks from sensing to acting.
    pub chain: u32,
    /// One bit for each component: whether it is active.
    pub active: u64,
    /// One byte for each component: the state that its machine is in, 255 without one.
    pub states: &'a [u8],
    /// Four bytes for each component, the lowest first: fine ticks spent in its own code in this cycle.
    pub costs: &'a [u8],
}

impl Telemetry<'_> {
    /// Fine ticks that each component spent in its own code in this cycle, in the order of the tree's list.
    pub fn cost(&self) -> impl Iterator<Item = u32> + '_ {
        self.costs.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes))
    }
}
