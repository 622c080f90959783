//! Messages that a program on a computer exchanges with its monitors, and a microcontroller does not.
//!
//! These messages have variants of their own in [`ToRobot`](super::ToRobot) and [`FromRobot`](super::FromRobot), so a
//! microcontroller's program contains no code for them.

use heapless::Vec;
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

use super::{Change, ImageChunk, ScenePart};

/// Largest number of conditions in one [`Conditions`].
pub const MAX_CONDITIONS: usize = 64;
/// Largest number of components in one [`ComponentCosts`].
pub const MAX_COSTS: usize = 32;
/// Number of cycles in which costs are measured for one [`Costs`].
pub const COSTS_CYCLES: u16 = 50;

/// Set of services that a robot's program offers to monitors, one bit for each. Unknown bits belong to a later version.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Offers(pub u32);

impl Offers {
    /// Requests of an operator.
    pub const OPERATE: Self = Self(1);
    /// A simulated world whose time can be stopped: [`FromMonitorExtra::World`].
    pub const PAUSE: Self = Self(1 << 1);
    /// Conditions of transitions.
    pub const CONDITIONS: Self = Self(1 << 2);
    /// Costs of components.
    pub const COSTS: Self = Self(1 << 3);
    /// The true state of a simulated world.
    pub const TRUTH: Self = Self(1 << 4);
    /// Camera images.
    pub const IMAGES: Self = Self(1 << 5);

    /// Returns the union of both sets.
    #[must_use]
    pub const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Returns whether this set contains all services of the other one.
    #[must_use]
    pub const fn contains(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }
}

/// A message of a monitor about a service that only a program on a computer offers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub enum FromMonitorExtra {
    /// Sets how often data of one kind are sent to this monitor.
    Watch {
        /// Kind of the data.
        kind: ExtraKind,
        /// Interval: sent in every n-th cycle, or for every n-th image; 0: never. Costs are sent every [`COSTS_CYCLES`]
        /// cycles for any other value.
        every: u16,
    },
    /// The monitor has received all chunks of an image, and the next one can be sent.
    ImageTaken {
        /// Number of the image.
        number: u32,
    },
    /// Requests a change of a simulated world's time. It is answered as a [`Request`](super::Request).
    World(WorldRequest),
}

/// A request of the operator about the time of a simulated world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct WorldRequest {
    /// Number that the answer repeats, one of the numbers of [`Request`](super::Request)s.
    pub number: u32,
    /// Number of the operator's lease.
    pub lease: u64,
    /// Robot's time after which the request is refused, µs; `u64::MAX`: never.
    pub expires_us: u64,
    /// What is requested.
    pub change: WorldChange,
}

/// A change of a simulated world's time. It stays in force when the lease ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub enum WorldChange {
    /// Pauses after the present cycle. Requests are still applied.
    Pause,
    /// Continues; remaining steps are dropped.
    Resume,
    /// Pauses after a number of cycles.
    Step {
        /// Number of cycles, added to those that remain.
        cycles: u32,
    },
}

/// Kind of data that a monitor can watch, besides states and outputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, Schema)]
pub enum ExtraKind {
    /// Conditions of the transitions of a component.
    Conditions {
        /// Index of the component.
        component: u16,
    },
    /// Costs of all components and of the cycle.
    Costs,
    /// True state of a simulated world.
    Truth,
    /// Camera images.
    Images,
    /// Transitions that components take, each as [`ToMonitorExtra::Taken`].
    Taken,
    /// A stop. It is reported whenever it is reached, for any interval other than 0.
    Stop(Stop),
}

/// A place in a tree at which a simulated world pauses after the cycle in which it is reached. A robot is never paused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, Schema)]
pub struct Stop {
    /// Index of the component.
    pub component: u16,
    /// State or transition that is reached.
    pub at: StopAt,
    /// Whether the world pauses there. It pauses if nobody, or this monitor, owns the lease.
    pub pauses: bool,
}

/// State or transition of a [`Stop`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, Schema)]
pub enum StopAt {
    /// The component is active in this state, and was not after the cycle before.
    State(u16),
    /// The component takes this transition.
    Transition(u16),
}

/// A message to a monitor with data that only a program on a computer offers.
#[expect(clippy::large_enum_variant, reason = "one at a time is encoded, and there may be no heap")]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum ToMonitorExtra<'a> {
    /// Conditions of consecutive transitions of a component.
    Conditions(Conditions),
    /// The beginning of costs.
    Costs(Costs),
    /// A part of costs.
    ComponentCosts(ComponentCosts),
    /// A part of the scenery or the true state.
    #[serde(borrow)]
    Scene(ScenePart<'a>),
    /// The beginning of an image.
    #[serde(borrow)]
    Image(ImageHead<'a>),
    /// A part of the image whose beginning was sent last.
    #[serde(borrow)]
    ImageChunk(ImageChunk<'a>),
    /// Pause state of the world: sent when a monitor attaches, when it changes, and when the requested steps are done.
    World(WorldState),
    /// A component has taken a transition.
    Taken(Taken),
    /// A stop was reached.
    Reached(Reached),
    /// Result of the run, for people, such as `the world ended after 12.00 s`: sent when the run ends, and to each monitor that
    /// attaches after that.
    Result(&'a str),
    /// A part of the schema of the robot's sensor values or command, sent with the description: a `NamedType` of postcard-schema in
    /// postcard's format.
    MessageSchema {
        /// Whether it is the schema of the command; otherwise it is that of the sensor values.
        command: bool,
        /// Whether this is the last part.
        last: bool,
        /// The part.
        bytes: &'a [u8],
    },
    /// A request was applied.
    Requested(Requested),
    /// An event in the world.
    #[serde(borrow)]
    Happened(Happened<'a>),
}

/// A request was applied, to the tree or to the simulated world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct Requested {
    /// Instant of the first cycle that runs with the change, µs.
    pub time_us: u64,
    /// The request.
    pub change: Change,
}

/// An event in the world, such as a goal or a fall.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Happened<'a> {
    /// Time in the robot's time, µs.
    pub time_us: u64,
    /// Kind, such as `goal` or `kick`.
    pub kind: &'a str,
    /// Details, as text; empty without any.
    pub detail: &'a str,
}

/// A component has taken a transition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Taken {
    /// Instant of the cycle, µs.
    pub time_us: u64,
    /// Index of the component.
    pub component: u16,
    /// Index of the transition.
    pub transition: u16,
}

/// A stop was reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Reached {
    /// Instant of the cycle, µs.
    pub time_us: u64,
    /// The stop.
    pub stop: Stop,
    /// Whether the world is paused there.
    pub paused: bool,
}

/// Conditions of consecutive transitions of a component, as they were evaluated last.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Conditions {
    /// Number of the cycle.
    pub cycle: u64,
    /// Instant of the tick, µs.
    pub time_us: u64,
    /// Index of the component.
    pub component: u16,
    /// Index of the first transition.
    pub first: u16,
    /// Latest value of each condition; `None` if it was not evaluated since the state was entered. The condition of the
    /// transition that entered the state is true since that instant.
    pub values: Vec<Option<ConditionState>, MAX_CONDITIONS>,
}

/// The condition of a transition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct ConditionState {
    /// Whether it held at its last evaluation.
    pub holds: bool,
    /// Instant since which it has had this value, µs.
    pub since_us: u64,
}

/// Costs of the cycles since the previous `Costs`. The [`ComponentCosts`] after it have the same cycle number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, Schema)]
pub struct Costs {
    /// Number of the last cycle.
    pub cycle: u64,
    /// Instant of the last cycle, µs.
    pub time_us: u64,
    /// Time from the last cycle before these to the last of these, µs.
    pub window_us: u64,
    /// Mean time from sensor values to the end of the tick, µs.
    pub mean_us: f32,
    /// Maximum of this time, µs.
    pub max_us: f32,
    /// Instant of the cycle that took longest, µs.
    pub worst_us: u64,
}

/// Costs of consecutive components.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct ComponentCosts {
    /// Number of the last cycle.
    pub cycle: u64,
    /// Index of the first component.
    pub first: u16,
    /// The costs.
    pub costs: Vec<ComponentCost, MAX_COSTS>,
}

/// Costs of a component: time in its own code, on the computer that runs it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, Schema)]
pub struct ComponentCost {
    /// Number of runs.
    pub runs: u32,
    /// Mean time of a run, µs.
    pub mean_us: f32,
    /// Longest time of a run, µs.
    pub max_us: f32,
    /// Number of runs that took longer than the declared budget.
    pub overruns: u32,
    /// Instant of the last run over the budget, µs; 0 without one.
    pub overrun_us: u64,
}

/// The beginning of an image in YUYV, 2 bytes for each pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct ImageHead<'a> {
    /// Number of the image since the start, from 0; also the number in its chunks.
    pub number: u32,
    /// Instant of the cycle that received the image, µs.
    pub time_us: u64,
    /// Name of its camera.
    pub camera: &'a str,
    /// Width, px.
    pub width: u16,
    /// Height, px.
    pub height: u16,
}

/// Whether a simulated world is paused.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct WorldState {
    /// Whether it is paused.
    pub paused: bool,
    /// Number of cycles that still run although it is paused.
    pub steps: u32,
    /// Number of the next cycle.
    pub cycle: u64,
}
