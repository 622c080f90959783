//! What was written, and what it means.

use proc_macro2::Ident;
use syn::{Attribute, ItemImpl, Path, Type};

/// An impl block with `#[component]`, its functions sorted by what they are for.
pub(crate) struct Component {
    /// The impl block without our attributes.
    pub(crate) item: ItemImpl,
    pub(crate) options: Options,
    pub(crate) doc: String,
    pub(crate) step: Option<Function>,
    pub(crate) states: Vec<State>,
    pub(crate) transitions: Vec<Transition>,
    pub(crate) entries: Vec<Hook>,
    pub(crate) exits: Vec<Hook>,
    pub(crate) starts: Vec<Function>,
    pub(crate) stops: Vec<Function>,
    /// An attribute of a function could not be read, so that what seems to be missing may be there.
    pub(crate) gaps: bool,
}

impl Component {
    /// All functions that the tree calls; one with several transitions comes once for each.
    pub(crate) fn functions(&self) -> impl Iterator<Item = &Function> + Clone {
        let states = self.states.iter().map(|state| &state.function);
        let transitions = self.transitions.iter().map(|transition| &transition.function);
        let hooks = self.entries.iter().chain(&self.exits).map(|hook| &hook.function);
        let edges = self.starts.iter().chain(&self.stops);
        self.step.iter().chain(states).chain(transitions).chain(hooks).chain(edges)
    }
}

/// What stands in the parentheses of `#[component(...)]`.
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

/// What a function is given beside `self`.
#[derive(Clone)]
pub(crate) enum Argument {
    /// `&C`
    Read(Type),
    /// `&mut C`
    Write(Type),
    /// `&Time`
    Time,
    /// `&mut Rate<C>`
    Rate(Type),
    /// `&mut Rate<Self>`
    OwnRate,
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
    pub(crate) from: From,
    pub(crate) to: Ident,
    pub(crate) after_ms: Option<u32>,
    pub(crate) attribute: Attribute,
}

/// The states that a transition leaves.
pub(crate) enum From {
    /// All but the one that it enters.
    Any,
    These(Vec<Ident>),
}

/// `#[entry]` or `#[exit]`
pub(crate) struct Hook {
    pub(crate) function: Function,
    pub(crate) states: Vec<Ident>,
}

/// What a component does when it runs, names resolved.
pub(crate) enum Behaviour {
    /// Its step; a component without one only holds what others read and write.
    Step(Option<Function>),
    Machine(Machine),
    /// Mistakes leave it open; only its links are known, more or less.
    Unclear,
}

/// A state machine; states are known by their place in the list.
pub(crate) struct Machine {
    pub(crate) initial: usize,
    pub(crate) states: Vec<Place>,
    /// In the order in which they are tried.
    pub(crate) ways: Vec<Way>,
}

/// A state with what belongs to it.
pub(crate) struct Place {
    pub(crate) body: Function,
    pub(crate) last: bool,
    pub(crate) entries: Vec<Function>,
    pub(crate) exits: Vec<Function>,
}

/// A transition between two states.
pub(crate) struct Way {
    pub(crate) condition: Function,
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) after_ms: Option<u32>,
}

impl Machine {
    /// The transitions that leave a state, in the order in which they are tried.
    pub(crate) fn ways_from(&self, state: usize) -> impl Iterator<Item = &Way> {
        self.ways.iter().filter(move |way| way.from == state)
    }
}
