//! What was written, and what it means.

use std::collections::BTreeSet;

use proc_macro2::Ident;
use syn::{Attribute, Path, Type};

use super::block::Block;
use super::resolve::Named;
pub use super::waiting::{End, Guard, Parameter, Timer, TypeText, When};
use crate::params::model::Field;
use crate::text;

/// An impl block with `#[component]`, its functions sorted by their roles.
pub struct Component {
    /// The impl block without our attributes.
    pub block: Block,
    /// Options of the attribute.
    pub options: Options,
    /// Doc comment of the block, or of the step if the block has none.
    pub doc: String,
    /// Function called `step`.
    pub step: Option<Function>,
    /// Functions with `#[state]`, in the order of the text, as are all lists.
    pub states: Vec<State>,
    /// Attributes `#[transition]`.
    pub transitions: Vec<Transition>,
    /// Functions with `#[entry]`.
    pub entries: Vec<Hook>,
    /// Functions with `#[exit]`.
    pub exits: Vec<Hook>,
    /// Functions with `#[before]`.
    pub hooks_before: Vec<Hook>,
    /// Functions with `#[start]`.
    pub starts: Vec<Function>,
    /// Functions with `#[stop]`.
    pub stops: Vec<Function>,
    /// Functions with `#[output]`.
    pub outputs: Vec<Output>,
    /// Functions with `#[modulation]`.
    pub modulations: Vec<Modulation>,
    /// Function with `#[work]`.
    pub work: Option<Work>,
    /// Whether an attribute or a function could not be read. What seems to be missing may then be there.
    pub incomplete: bool,
}

impl Component {
    /// All functions that the tree calls; one with several transitions occurs once for each.
    pub fn functions(&self) -> impl Iterator<Item = &Function> + Clone {
        let states = self.states.iter().map(|state| &state.function);
        let conditions = self.transitions.iter().filter(|transition| !transition.arrow.guard.bare);
        let transitions = conditions.map(|transition| &transition.function);
        let hooks = self.entries.iter().chain(&self.exits).chain(&self.hooks_before).map(|hook| &hook.function);
        let activity = self.starts.iter().chain(&self.stops);
        self.step.iter().chain(states).chain(transitions).chain(hooks).chain(activity)
    }

    /// The parameters that are timers of transitions.
    pub fn timers(&self) -> impl Iterator<Item = &Parameter> {
        self.transitions.iter().filter_map(|transition| match &transition.arrow.guard.timer {
            Some(Timer::Parameter(timer)) => Some(&**timer),
            _ => None,
        })
    }

    /// The type whose impl block this is.
    #[must_use]
    pub fn own(&self) -> &Type {
        &self.block.header.self_ty
    }
}

/// A function with `#[work]`.
pub struct Work {
    /// Name of the function.
    pub name: Ident,
    /// Doc comment.
    pub doc: String,
    /// Declared time of a job, ms.
    pub takes_ms: u32,
    /// Whether it runs in slices.
    pub slices: bool,
    /// Names and types of its arguments; the state if it runs in slices.
    pub inputs: Vec<(Ident, Type)>,
    /// Type of the result.
    pub output: Type,
}

/// A getter with `#[output]`.
pub struct Output {
    /// Name of the function.
    pub name: Ident,
    /// Doc comment.
    pub doc: String,
    /// Unit of the value.
    pub unit: Option<String>,
    /// Frames of a value that can be drawn.
    pub placement: Option<Placement>,
    /// Type of the value.
    pub ty: Type,
}

/// Frames of an output.
pub struct Placement {
    /// The frame in which the value is given.
    pub frame: String,
    /// The frame whose place the value is.
    pub child: Option<String>,
}

/// A method with `#[modulation]`, or the call of an action.
pub struct Modulation {
    /// Name of the function.
    pub name: Ident,
    /// Doc comment.
    pub doc: String,
    /// Whether it is marked as a stop.
    pub stops: bool,
    /// Whether it says that it drives the robot.
    pub drives: bool,
    /// Arguments beside `self`.
    pub arguments: Vec<Field>,
}

/// The options in the parentheses of `#[component(...)]`.
pub struct Options {
    /// Runs per second, Hz.
    pub hz: Option<f32>,
    /// Longest time of one run, µs.
    pub budget_us: Option<f32>,
    /// The word `resume`.
    pub resume: Option<Ident>,
    /// Which of several components counts that write this one in one cycle.
    pub writers: Option<Writers>,
    /// The crate that generated code uses.
    pub krate: Path,
}

/// Which of the components counts that write one in one cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Writers {
    /// `writers = first`
    First,
    /// `writers = last`
    Last,
}

/// A function that the tree calls.
#[derive(Clone)]
pub struct Function {
    /// Name of the function.
    pub name: Ident,
    /// Doc comment.
    pub doc: String,
    /// Arguments beside `self`.
    pub arguments: Vec<Argument>,
    /// `T` of a condition that returns `Option<T>`: what its transitions carry to the states that they enter.
    pub carries: Option<Box<Type>>,
}

impl Function {
    /// The children whose results the function takes.
    pub fn outcomes(&self) -> impl Iterator<Item = &Type> {
        self.arguments.iter().filter_map(|argument| if let Argument::Outcome(of) = argument { Some(of) } else { None })
    }

    /// What the function takes from the transition by which its state was entered.
    #[must_use]
    pub fn found(&self) -> Option<&Found> {
        self.arguments
            .iter()
            .find_map(|argument| if let Argument::Found(found) = argument { Some(&**found) } else { None })
    }
}

/// `Found<T>` or `Option<Found<T>>`
#[derive(Clone)]
pub struct Found {
    /// The argument's type as written.
    pub written: Type,
    /// `T`
    pub of: Type,
    /// Whether it is an `Option`: the state may be entered without a transition.
    pub optional: bool,
}

/// An argument beside `self`.
#[derive(Clone)]
pub enum Argument {
    /// `&C`, or `&impl Role`: `C` or `impl Role`, as in all links
    Read(Type),
    /// `&mut C`
    Write(Type),
    /// `&Time`, by any path
    Time(Type),
    /// `&mut Rate<C>`
    Rate(Type),
    /// `&Age<C>`: `C` or `impl Role`
    Age(Type),
    /// `&Outcome<C>`, in a transition
    Outcome(Type),
    /// `&mut Rate<Self>`
    OwnRate,
    /// `&mut Work<Self>`, as written without `&mut`
    Work(Type),
    /// `&Tuned<P>`: the struct `P`
    Tuned(Type),
    /// `Found<T>`, in an entry hook
    Found(Box<Found>),
}

/// `#[state]`
pub struct State {
    /// Function of the state.
    pub function: Function,
    /// The word `initial`.
    pub initial: Option<Ident>,
    /// Whether no transition leaves it: one of the words `last`, `done` and `failed` is there.
    pub last: bool,
    /// The result with which the machine ends in it.
    pub end: Option<End>,
}

/// `#[transition]`
pub struct Transition {
    /// Function that decides; that of the state if none does ([`Guard::bare`]).
    pub function: Function,
    /// The content of the attribute.
    pub arrow: Arrow,
    /// The attribute as written.
    pub attribute: Attribute,
}

/// The content of `#[transition(a | b -> c, after_ms = N)]`.
pub struct Arrow {
    /// States that it leaves.
    pub from: Sources,
    /// State that it enters.
    pub to: Ident,
    /// What it waits for beside its condition.
    pub guard: Guard,
}

/// The states that a transition leaves, by names of a type that may know their places in the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sources<N = Ident> {
    /// All but the one that it enters.
    Any,
    /// The named ones.
    These(Vec<N>),
}

/// `#[entry]`, `#[exit]` or `#[before]`
pub struct Hook {
    /// Function of the hook.
    pub function: Function,
    /// States that it belongs to.
    pub states: Vec<Ident>,
    /// The attribute as written.
    pub attribute: Attribute,
}

/// What a component does when it runs, with all names resolved.
pub enum Behaviour {
    /// Its step; a component without one holds what others read and write.
    Step(Option<Function>),
    /// A state machine.
    Machine(Machine),
}

/// A state machine; a state is identified by its index. Its functions are of a type that may know their places in the text.
pub struct Machine<F = Function> {
    /// The state in which it starts.
    pub initial: usize,
    /// States in the order of the text.
    pub states: Vec<MachineState<F>>,
    /// In the order in which they are tried.
    pub edges: Vec<Edge<F>>,
}

/// A state with its hooks.
pub struct MachineState<F = Function> {
    /// Function of the state.
    pub body: F,
    /// Whether no transition leaves it.
    pub last: bool,
    /// The result with which the machine ends in it.
    pub end: Option<End>,
    /// Functions that run when it is entered.
    pub entries: Vec<F>,
    /// Functions that run when it is left.
    pub exits: Vec<F>,
    /// Function that runs before the transitions that leave it are tried.
    pub before: Option<F>,
}

/// A transition from one state to one other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edge<F = Function> {
    /// Function that decides; that of the state if none does ([`Guard::bare`]).
    pub condition: F,
    /// State that it leaves.
    pub from: usize,
    /// State that it enters.
    pub to: usize,
    /// What it waits for beside its condition.
    pub guard: Guard,
    /// Whether the attribute names all states by `*`.
    pub any: bool,
}

impl Machine {
    /// The children for whose results the transitions ask, each text once.
    pub fn asked(&self) -> impl Iterator<Item = &Type> {
        distinct(self.edges.iter())
    }

    /// The children for whose results the transitions ask that leave a state, each text once.
    pub fn asked_in(&self, state: usize) -> impl Iterator<Item = &Type> {
        distinct(self.edges_from(state))
    }
}

impl<F> Machine<F> {
    /// The transitions that leave a state, in the order in which they are tried.
    pub fn edges_from(&self, state: usize) -> impl Iterator<Item = &Edge<F>> {
        self.edges.iter().filter(move |edge| edge.from == state)
    }
}

/// The children for whose results some transitions ask.
fn distinct<'a>(edges: impl Iterator<Item = &'a Edge>) -> impl Iterator<Item = &'a Type> {
    let mut seen = BTreeSet::new();
    let asked = edges.flat_map(|edge| {
        let function = (!edge.guard.bare).then_some(&edge.condition);
        edge.guard.when.iter().map(|when| &when.child.0).chain(function.into_iter().flat_map(Function::outcomes))
    });
    asked.filter(move |one| seen.insert(text::written(one)))
}

impl<F: Named> Edge<F> {
    /// Returns the name in descriptions and drawings: that of its condition, or what it waits for if it has none.
    #[must_use]
    pub fn name(&self) -> String {
        match &self.guard {
            Guard { bare: false, .. } => self.condition.text(),
            Guard { when: Some(when), .. } => when.to_string(),
            Guard { .. } => "timer".to_owned(),
        }
    }
}

impl<F> MachineState<F> {
    /// Functions of the state and of its hooks.
    pub fn functions(&self) -> impl Iterator<Item = &F> {
        [&self.body].into_iter().chain(&self.entries).chain(&self.exits).chain(&self.before)
    }
}

impl MachineState {
    /// What the state takes from the transition by which it is entered.
    #[must_use]
    pub fn found(&self) -> Option<&Found> {
        self.entries.iter().find_map(Function::found)
    }
}
