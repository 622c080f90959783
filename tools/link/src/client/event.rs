//! Events that a client receives.

use bica::runner::OwnedRequest;
use bica_wire::message::{
    self, ComponentCost, ComponentState, ConditionState, CycleInfo, LeaseState, LogLine, LogSource, Reached,
    RefusalCode, Taken, Value, WorldState,
};

use bica_wire::model::Description;

use super::scene::{Shown, Truth};
use crate::error::Error;
use crate::image::Image;

/// Event that a client receives.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "the fields are explained at their variants")]
pub enum Event {
    /// State of the tree after a cycle.
    Snapshot(Snapshot),
    /// The value of an output of a component after a cycle in postcard's format, see [`decode_output`](crate::decode_output); none if
    /// it is too large for a packet.
    Output { cycle: u64, component: usize, output: usize, value: Option<Vec<u8>> },
    /// Parameters of a component changed; the new values are in the description.
    Params { component: usize },
    /// The lease.
    Lease(LeaseState),
    /// Answer to a request.
    Answer(Answered),
    /// Line of the robot's log.
    Log(LogLine<String>),
    /// Conditions of the transitions of a component in the tick at a time in µs; none for one that was not evaluated in the present
    /// state.
    Conditions { time_us: u64, component: usize, conditions: Vec<Option<ConditionState>> },
    /// Costs of the components and of the cycle.
    Costs(Costs),
    /// True state of a simulated world.
    Truth(Truth),
    /// Scenery: the objects that do not move in the robot's world.
    Scenery(Vec<Shown>),
    /// A camera image. The robot sends the next one after this event was taken.
    Image(Image),
    /// Pause state of a simulated world.
    World(WorldState),
    /// A component has taken a transition.
    Taken(Taken),
    /// A stop was reached.
    Reached(Reached),
    /// A request was applied at an instant, µs. A microcontroller sends a line of the log instead.
    Requested { time_us: u64, request: OwnedRequest },
    /// An event in the robot's world at a time, µs: its kind, such as `goal`, and details.
    Happened { time_us: u64, kind: String, detail: String },
    /// Result of the run, for people.
    Result(String),
}

impl Event {
    /// Returns the line of the log for the event, with the names of the tree; none for an event that is not logged.
    #[must_use]
    pub fn line(&self, tree: &Description) -> Option<LogLine<String>> {
        let (time_us, source, text) = match self {
            Self::Log(line) => return Some(line.clone()),
            Self::Requested { time_us, request } => {
                (*time_us, LogSource::Operator, tree.named(request.borrow()).to_string())
            }
            Self::Happened { time_us, kind, detail } => (*time_us, LogSource::World, happened(kind, detail)),
            _ => return None,
        };
        Some(LogLine { time_us, level: 2, source, text })
    }
}

/// Returns an event of a world as text: its kind and its details.
#[must_use]
pub fn happened(kind: &str, detail: &str) -> String {
    if detail.is_empty() { kind.to_owned() } else { format!("{kind}, {detail}") }
}

/// Costs of the components and of the cycle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Costs {
    /// Costs of the cycles.
    pub cycles: message::Costs,
    /// Costs of each component.
    pub components: Vec<ComponentCost>,
}

/// State of a tree after a cycle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Snapshot {
    /// The cycle.
    pub info: CycleInfo,
    /// State of each component, in the order of the tree's list.
    pub states: Vec<ComponentState>,
}

/// Answer to a request.
#[derive(Clone, Debug, PartialEq)]
pub struct Answered {
    /// Number of the request.
    pub number: u32,
    /// Number of the first cycle that ran with the change, or of the next cycle if it was refused.
    pub cycle: u64,
    /// Number of the cycle that was next when the request arrived.
    pub arrived: u64,
    /// Effective values of the parameters in the order of the batch, or the rate.
    pub values: Vec<Value>,
    /// Refusal of the request, if it was refused: reason, index of the setting or argument, text.
    pub refused: Option<(RefusalCode, usize, String)>,
}

impl Answered {
    /// Returns a refusal as an error.
    pub(super) fn result(self) -> Result<Self, Error> {
        match self.refused {
            None => Ok(self),
            Some((code, entry, text)) => Err(Error::Refused { code, entry, text }),
        }
    }
}
