//! A component: an impl block with `#[component]`.

use bica_syntax::component::model;
use serde::{Deserialize, Serialize, Serializer};

use super::{Docs, Function, Name, Span};

/// A component.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Component {
    /// Unique key in the file: `Eye<4>`, or `module::Eye<4>` in a module of the file. The second component with the same key has
    /// `Eye<4>#2`.
    pub key: String,
    /// Path of the modules in the file that contain it, `one::two`; empty at the top level.
    pub module: String,
    /// Its type as written.
    pub name: Name,
    /// The impl block with its attributes.
    pub span: Span,
    /// Text between the braces of the block; `None` if a brace is missing.
    pub block: Option<Span>,
    /// The attribute `#[component]`.
    pub options: Options,
    /// Doc comment of the block, or of the step if the block has none.
    pub docs: Docs,
    /// The function `step`.
    pub step: Option<Function>,
    /// Functions with `#[state]`. All lists are in the order of the text.
    pub states: Vec<State>,
    /// Functions with `#[transition]`.
    pub transitions: Vec<Transition>,
    /// Functions with `#[entry]`, `#[exit]`, `#[before]`, `#[start]` or `#[stop]`.
    pub hooks: Vec<Hook>,
    /// Functions with `#[output]`.
    #[serde(rename = "info")]
    pub outputs: Vec<Output>,
    /// Functions with `#[modulation]`.
    pub modulations: Vec<Modulation>,
    /// Functions with `#[work]`; more than one is a mistake.
    pub work: Vec<Work>,
    /// The other functions.
    pub others: Vec<Function>,
    /// Names of constants and types of the block.
    pub names: Vec<Name>,
}

impl Component {
    /// Returns all functions, in no particular order.
    pub fn functions(&self) -> impl Iterator<Item = &Function> {
        let states = self.states.iter().map(|state| &state.function);
        let transitions = self.transitions.iter().map(|transition| &transition.function);
        let hooks = self.hooks.iter().map(|hook| &hook.function);
        let outputs = self.outputs.iter().map(|output| &output.function);
        let modulations = self.modulations.iter().map(|modulation| &modulation.function);
        let all = self.step.iter().chain(states).chain(transitions).chain(hooks);
        all.chain(outputs).chain(modulations).chain(self.work.iter().map(|work| &work.function)).chain(&self.others)
    }

    /// Returns the function with that name.
    #[must_use]
    pub fn function(&self, name: &str) -> Option<&Function> {
        self.functions().find(|function| function.name.text == name)
    }

    /// Returns the state with that name.
    #[must_use]
    pub fn state(&self, name: &str) -> Option<&State> {
        self.states.iter().find(|state| state.function.name.text == name)
    }

    /// Returns the transition with that name.
    #[must_use]
    pub fn transition(&self, name: &str) -> Option<&Transition> {
        self.transitions.iter().find(|transition| transition.function.name.text == name)
    }

    /// Returns the type of the found value that a state takes from the transitions that enter it.
    #[must_use]
    pub fn takes(&self, state: &str) -> Option<&str> {
        let hooks = self.hooks.iter().filter(|hook| hook.role == HookRole::Entry);
        hooks.filter(|hook| hook.states.iter().any(|one| one.text == state)).find_map(|hook| hook.function.takes())
    }

    /// Returns whether it is a state machine.
    #[must_use]
    pub const fn is_machine(&self) -> bool {
        !self.states.is_empty()
    }
}

/// `#[component(...)]`
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Options {
    /// The attribute.
    pub span: Span,
    /// Text between its parentheses; `None` without parentheses.
    pub list: Option<Span>,
    /// The options, in the order of the text.
    pub settings: Vec<Setting>,
}

impl Options {
    /// Returns the option with that key.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<&Setting> {
        self.settings.iter().find(|setting| setting.key.text == key)
    }
}

/// An option.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Setting {
    /// Whole option, without the comma.
    pub span: Span,
    /// The word before `=`.
    pub key: Name,
    /// Text after `=`.
    pub value: Option<Name>,
}

/// A state.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct State {
    /// Its function.
    pub function: Function,
    /// The attribute `#[state]`.
    pub attribute: Span,
    /// Whether the machine starts in it.
    pub initial: bool,
    /// Whether no transition leaves it.
    pub last: bool,
    /// Result with which the machine ends in it: `done` or `failed`.
    pub end: Option<&'static str>,
    /// Transitions that stand on it, in the order of the text: they leave it, and no function decides.
    pub arrows: Vec<Arrow>,
}

impl State {
    /// Returns the word that marks it as an end: `last`, `done` or `failed`.
    #[must_use]
    pub fn end_word(&self) -> Option<&'static str> {
        self.end.or(self.last.then_some("last"))
    }
}

/// A condition with its transitions.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Transition {
    /// Its function.
    pub function: Function,
    /// Transitions of the condition, one for each attribute, in the order of the text.
    pub arrows: Vec<Arrow>,
}

/// `#[transition(from -> to)]`
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Arrow {
    /// The attribute.
    pub span: Span,
    /// Text between its parentheses.
    pub list: Span,
    /// States that it leaves.
    #[serde(serialize_with = "sources")]
    pub from: Sources,
    /// The states before the arrow, as written.
    pub from_span: Span,
    /// State that it enters.
    pub to: Name,
    /// Minimum time in the state that is left, ms, and the span of this option with the comma before it.
    pub after_ms: Option<(u32, Span)>,
    /// The parameter that is the least time, `Approach::patience`, and its place.
    pub after: Option<(String, Span)>,
    /// The result of a child without which it does not hold, `done(Reach)`, and its place.
    pub when: Option<(String, Span)>,
    /// How often it is taken in a row, and its place.
    pub times: Option<(u8, Span)>,
}

impl Arrow {
    /// Returns the name of a transition on a state: what it waits for.
    #[must_use]
    pub fn bare_name(&self) -> &str {
        self.when.as_ref().map_or("timer", |(when, _)| when)
    }

    /// Returns what it waits for, as it is written behind the arrow.
    #[must_use]
    pub fn waits(&self) -> String {
        let after_ms = self.after_ms.map(|(ms, _)| format!(", after_ms = {ms}"));
        let after = self.after.as_ref().map(|(after, _)| format!(", after = {after}"));
        let when = self.when.as_ref().map(|(when, _)| format!(", when = {when}"));
        let times = self.times.map(|(times, _)| format!(", times = {times}"));
        [after_ms, after, when, times].into_iter().flatten().collect()
    }

    /// Returns the place of a key with its value: `after_ms`, `after`, `when` or `times`.
    #[must_use]
    pub fn place(&self, key: &str) -> Option<Span> {
        match key {
            "after_ms" => self.after_ms.map(|(_, span)| span),
            "after" => self.after.as_ref().map(|(_, span)| *span),
            "when" => self.when.as_ref().map(|(_, span)| *span),
            _ => self.times.map(|(_, span)| span),
        }
    }
}

/// The states that a transition leaves.
pub type Sources = model::Sources<Name>;

/// Serialises the states as `"any"` or `{"these": [...]}`.
fn sources<S: Serializer>(sources: &Sources, serializer: S) -> Result<S::Ok, S::Error> {
    match sources {
        Sources::Any => serializer.serialize_unit_variant("Sources", 0, "any"),
        Sources::These(names) => serializer.serialize_newtype_variant("Sources", 1, "these", names),
    }
}

/// A function that runs when a state is entered or left, before its transitions are tried, or when the component becomes active or
/// latent.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Hook {
    /// Its function.
    pub function: Function,
    /// Event that calls it.
    pub role: HookRole,
    /// The attribute.
    pub attribute: Span,
    /// The states of `#[entry]`, `#[exit]` and `#[before]`.
    pub states: Vec<Name>,
    /// Text between the parentheses of the attribute.
    pub list: Option<Span>,
}

/// Event that calls a hook.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum HookRole {
    /// A state is entered.
    Entry,
    /// A state is left.
    Exit,
    /// The transitions that leave a state are about to be tried.
    Before,
    /// The component becomes active.
    Start,
    /// The component becomes latent.
    Stop,
}

impl HookRole {
    /// Returns whether its attribute names states.
    #[must_use]
    pub const fn is_of_states(self) -> bool {
        matches!(self, Self::Entry | Self::Exit | Self::Before)
    }

    /// Returns the name of the attribute.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Entry => "entry",
            Self::Exit => "exit",
            Self::Before => "before",
            Self::Start => "start",
            Self::Stop => "stop",
        }
    }
}

/// An output: a getter with `#[output]`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Output {
    /// Its function.
    pub function: Function,
    /// The attribute.
    pub attribute: Span,
    /// Unit of the value.
    pub unit: Option<String>,
    /// Type of the value as written.
    pub ty: Option<Name>,
}

/// A function that runs beside the loop.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Work {
    /// Its function.
    pub function: Function,
    /// The attribute.
    pub attribute: Span,
}

/// A method for the operator.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Modulation {
    /// Its function.
    pub function: Function,
    /// The attribute.
    pub attribute: Span,
}
