//! What was written, and what it means.

use proc_macro2::Ident;
use syn::{Attribute, Path, Type};

use super::block::Block;
use crate::language::params::model::Field;

/// An impl block with `#[component]`, its functions sorted by their roles.
pub(crate) struct Component {
    /// The impl block without our attributes.
    pub(crate) block: Block,
    pub(crate) options: Options,
    pub(crate) doc: String,
    pub(crate) step: Option<Function>,
    pub(crate) states: Vec<State>,
    pub(crate) transitions: Vec<Transition>,
    pub(crate) entries: Vec<Hook>,
    pub(crate) exits: Vec<Hook>,
    pub(crate) starts: Vec<Function>,
    pub(crate) stops: Vec<Function>,
    pub(crate) infos: Vec<Info>,
    pub(crate) modulations: Vec<Modulation>,
    /// Whether an attribute or a function could not be read. What seems to be missing may then be there.
    pub(crate) incomplete: bool,
}

impl Component {
    /// All functions that the tree calls; one with several transitions occurs once for each.
    pub(crate) fn functions(&self) -> impl Iterator<Item = &Function> + Clone {
        let states = self.states.iter().map(|state| &state.function);
        let transitions = self.transitions.iter().map(|transition| &transition.function);
        let hooks = self.entries.iter().chain(&self.exits).map(|hook| &hook.function);
        let activity = self.starts.iter().chain(&self.stops);
        self.step.iter().chain(states).chain(transitions).chain(hooks).chain(activity)
    }

    /// The type whose impl block this is.
    pub(crate) fn own(&self) -> &Type {
        &self.block.header.self_ty
    }
}

/// A getter with `#[info]`.
pub(crate) struct Info {
    pub(crate) name: Ident,
    pub(crate) doc: String,
    pub(crate) unit: Option<String>,
    pub(crate) ty: Type,
}

/// A method with `#[modulation]`.
pub(crate) struct Modulation {
    pub(crate) name: Ident,
    pub(crate) doc: String,
    pub(crate) arguments: Vec<Field>,
}

/// The options in the parentheses of `#[component(...)]`.
pub(crate) struct Options {
    pub(crate) hz: Option<f32>,
    pub(crate) budget_us: Option<f32>,
    pub(crate) resume: Option<Ident>,
    /// The crate that generated code uses.
    pub(crate) krate: Path,
}

/// A function that the tree calls.
#[derive(Clone)]
pub(crate) struct Function {
    pub(crate) name: Ident,
    pub(crate) doc: String,
    pub(crate) arguments: Vec<Argument>,
}

/// An argument beside `self`.
#[derive(Clone)]
pub(crate) enum Argument {
    /// `&C`
    Read(Type),
    /// `&mut C`
    Write(Type),
    /// `&Time`, by any path
    Time(Type),
    /// `&mut Rate<C>`
    Rate(Type),
    /// `&mut Rate<Self>`
    OwnRate,
    /// `&Tuned<P>`: the struct `P`
    Tuned(Type),
}

/// `#[state]`
pub(crate) struct State {
    pub(crate) function: Function,
    /// The word `initial`.
    pub(crate) initial: Option<Ident>,
    pub(crate) last: bool,
}

/// `#[transition]`
pub(crate) struct Transition {
    pub(crate) function: Function,
    pub(crate) from: Sources,
    pub(crate) to: Ident,
    pub(crate) after_ms: Option<u32>,
    pub(crate) attribute: Attribute,
}

/// The states that a transition leaves.
pub(crate) enum Sources {
    /// All but the one that it enters.
    Any,
    These(Vec<Ident>),
}

/// `#[entry]` or `#[exit]`
pub(crate) struct Hook {
    pub(crate) function: Function,
    pub(crate) states: Vec<Ident>,
    pub(crate) attribute: Attribute,
}

/// What a component does when it runs, with all names resolved.
pub(crate) enum Behaviour {
    /// Its step; a component without one holds what others read and write.
    Step(Option<Function>),
    Machine(Machine),
}

/// A state machine; a state is identified by its index.
pub(crate) struct Machine {
    pub(crate) initial: usize,
    pub(crate) states: Vec<MachineState>,
    /// In the order in which they are tried.
    pub(crate) edges: Vec<Edge>,
}

/// A state with its hooks.
pub(crate) struct MachineState {
    pub(crate) body: Function,
    pub(crate) last: bool,
    pub(crate) entries: Vec<Function>,
    pub(crate) exits: Vec<Function>,
}

/// A transition from one state to one other.
pub(crate) struct Edge {
    pub(crate) condition: Function,
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) after_ms: Option<u32>,
}

impl Machine {
    /// The transitions that leave a state, in the order in which they are tried.
    pub(crate) fn edges_from(&self, state: usize) -> impl Iterator<Item = &Edge> {
        self.edges.iter().filter(move |edge| edge.from == state)
    }
}
