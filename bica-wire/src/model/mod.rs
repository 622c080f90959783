//! The one model of a robot: in the process, over the link, in a recording's header, in JSON and in the page of a monitor.
//!
//! [`Description::of`] makes it from the graph of a tree of this program, a [`Builder`] from the items that another robot sends.
//! Its form in JSON is documented in `docs/json.md`. Lists refer to each other by index. People and files use names, which
//! [`Description::component`] and similar functions look up.

mod builder;
mod find;
mod invalid;
mod param;
mod plain;
mod request;
mod robot;

use std::borrow::ToOwned;
use std::format;
use std::string::String;
use std::vec::Vec;

pub use bica_core::Axis;
pub use bica_core::graph::{End, LinkKind, Query, QueryKind};
use bica_core::visual;
pub use builder::Builder;
pub use invalid::Invalid;
pub use param::{Kind, Param, Variant, Variants};
pub use plain::Plain;
use postcard_schema::schema::owned::OwnedNamedType;
pub use request::{NamedRequest, NamedSetting};
pub use robot::Messages;
use serde::{Deserialize, Serialize};

/// Description of a robot: its tree, its messages, and the actions of its world.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Description {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Hash of the tree without doc comments, in hexadecimal digits.
    pub hash: String,
    /// Nominal rate of ticks, Hz.
    pub cycle_hz: f32,
    /// Longest time of one cycle, ms.
    pub budget_ms: Option<f32>,
    /// Whether parameters can be changed at run time.
    pub tunable: bool,
    /// Index of the root in [`components`](Self::components).
    pub root: usize,
    /// The components.
    pub components: Vec<Component>,
    /// Actions of an operator in the simulated world; empty without one.
    #[serde(default)]
    pub actions: Vec<Modulation>,
    /// Schemas of the robot's messages; none while they are unknown, and for a microcontroller.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub messages: Option<Messages>,
}

/// A component.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Component {
    /// Name.
    pub name: String,
    /// Type as in the source text, if the name is another one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub kind: Option<String>,
    /// Doc comment.
    pub doc: String,
    /// Declared rate, Hz; none: every cycle.
    pub hz: Option<f32>,
    /// Declared time budget of a run, µs.
    pub budget_us: Option<f32>,
    /// Whether its state machine continues in the state in which it became latent.
    pub resume: bool,
    /// Activation links from this component.
    pub links: Vec<Link>,
    /// Ages and outcomes of other components for which it asks.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub queries: Vec<Query>,
    /// Components that write this one in one cycle, in the order in which they run; empty if never more than one does.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub writers: Vec<Writer>,
    /// States.
    pub states: Vec<State>,
    /// Transitions.
    pub transitions: Vec<Transition>,
    /// Parameters.
    pub params: Vec<Param>,
    /// Outputs.
    #[serde(rename = "info")]
    pub outputs: Vec<Output>,
    /// Modulations.
    pub modulations: Vec<Modulation>,
    /// Function that runs beside the loop.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub work: Option<Work>,
}

impl Description {
    /// Says who writes a component in one cycle, if several do: `written by Avoid, then Follow; in force: Avoid`.
    #[must_use]
    pub fn written(&self, component: &Component) -> Option<String> {
        let name = |writer: &Writer| self.components.get(writer.by).map_or("?", |one| &*one.name);
        let names: Vec<_> = component.writers.iter().map(name).collect();
        let in_force = component.writers.iter().find(|writer| writer.in_force).map(name)?;
        Some(format!("written by {}; in force: {in_force}", names.join(", then ")))
    }
}

impl Component {
    /// Returns the type as in the source text.
    #[must_use]
    pub fn type_name(&self) -> &str {
        self.kind.as_deref().unwrap_or(&self.name)
    }
}

/// One of several components that write another one in one cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Writer {
    /// Index of the component.
    pub by: usize,
    /// Whether its values are in force.
    pub in_force: bool,
}

/// A function that runs beside the loop.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Work {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Declared time of a job, ms.
    pub takes_ms: u32,
    /// Whether it runs in slices.
    pub slices: bool,
    /// Type of the result, as in the source text.
    pub result: String,
}

/// An activation link.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Link {
    /// Index of the activated component.
    pub to: usize,
    /// Requirement or modulation.
    pub kind: LinkKind,
    /// Index of the only state with this link.
    pub state: Option<usize>,
    /// Roles that the source names instead of the component.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub roles: Vec<String>,
}

/// A state.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct State {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Whether it is the initial state.
    pub initial: bool,
    /// Whether it is marked to have no transition out of it.
    pub last: bool,
    /// Result with which the machine ends in it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end: Option<End>,
    /// Function that runs before the transitions that leave it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub before: Option<String>,
}

/// A result for which a transition waits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct When {
    /// Index of the child.
    pub child: usize,
    /// The result.
    pub end: End,
}

/// A transition.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Transition {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Index of the source state.
    pub from: usize,
    /// Index of the target state.
    pub to: usize,
    /// Shortest time in the source state, ms; of a timer that is a parameter its default.
    pub after_ms: Option<u32>,
    /// Index of the component's parameter that is the shortest time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub after: Option<usize>,
    /// The result of a child without which it does not hold.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub when: Option<When>,
    /// How often it is taken in a row.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub times: Option<u8>,
    /// Type of what it carries to the target state, as in the source text.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub carries: Option<String>,
}

/// An output.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Output {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Unit.
    pub unit: Option<String>,
    /// Type of the value, as in the source text.
    #[serde(rename = "type")]
    pub type_name: String,
    /// Visual type and frames; `None` for an output that is not drawn.
    #[serde(flatten, default, skip_serializing_if = "Option::is_none")]
    pub placement: Option<Placement>,
    /// Schema of the value; none while it is unknown.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub schema: Option<OwnedNamedType>,
}

/// Visual type and frames of an output.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Placement {
    /// Name of a type of [`bica_core::visual`].
    pub shape: String,
    /// The frame in which the value is given.
    pub frame: String,
    /// The frame whose place the value gives.
    pub child: Option<String>,
}

impl From<visual::Placement<'_>> for Placement {
    fn from(one: visual::Placement<'_>) -> Self {
        Self { shape: one.shape.to_owned(), frame: one.frame.to_owned(), child: one.child.map(str::to_owned) }
    }
}

/// A modulation, or an action of a world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Modulation {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Whether it stops the robot: then everybody may call it, without the lease.
    #[serde(default, skip_serializing_if = "core::ops::Not::not")]
    pub stops: bool,
    /// Whether tools drive the robot by it, with its arguments `forward` and `turn`, and perhaps `left`, or `pan` and perhaps `tilt`.
    #[serde(default, skip_serializing_if = "core::ops::Not::not")]
    pub drives: bool,
    /// Arguments.
    pub arguments: Vec<Param>,
    /// Item of the world's true state that an action moves to the place of its arguments.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moves: Option<String>,
}

/// Place from which a tool may take the value of an argument.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Place {
    /// Name of the frame.
    pub frame: String,
    /// The coordinate.
    pub axis: Axis,
}

impl From<bica_core::Place<'_>> for Place {
    fn from(bica_core::Place { frame, axis }: bica_core::Place<'_>) -> Self {
        Self { frame: frame.to_owned(), axis }
    }
}
