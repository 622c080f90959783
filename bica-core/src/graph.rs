//! The static description of a tree: what every tool reads and what the compiler checks.

mod doc;
mod hash;
mod query;

pub use doc::Doc;
pub use hash::hash;
pub use query::{Queries, Query, QueryKind};

use crate::id::ComponentId;
use crate::key::Key;
use crate::modulation::Modulation;
use crate::output::Output;
use crate::params::{Param, ParamGroup};

/// Description of a tree of components: all that is known before it runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Graph {
    /// The tree's name.
    pub name: &'static str,
    /// The tree's doc comment.
    pub doc: &'static str,
    /// Nominal rate of ticks, 1/s.
    pub cycle_hz: f32,
    /// Longest time of one cycle, ms.
    pub budget_ms: Option<f32>,
    /// Whether the parameters of the components can be changed at run time.
    pub tunable: bool,
    /// Version of the package that declares the tree; none if it was not built by Cargo.
    pub version: Option<&'static str>,
    /// Commit of its sources: the variable `GIT_COMMIT` when it was built, as `git describe --always --dirty --abbrev=40` prints it.
    pub commit: Option<&'static str>,
    /// Index of the root in `nodes`.
    pub root: usize,
    /// The components, in the order in which the tree lists them.
    pub nodes: &'static [Node],
    /// Names of the roles, in the order in which the tree lists them; at most [`Roles::CAPACITY`].
    pub roles: &'static [&'static str],
}

impl Graph {
    /// Returns the component with this key; `None` if there is none.
    #[must_use]
    pub fn find(&self, component: impl Key) -> Option<ComponentId> {
        let index = component.find(self.nodes.iter().map(|node| node.name));
        index.filter(|index| *index < self.nodes.len()).map(ComponentId::new)
    }

    /// Returns the names of the roles in a set.
    pub fn role_names(&self, roles: Roles) -> impl Iterator<Item = &'static str> + use<> {
        self.roles.iter().enumerate().filter(move |(role, _)| roles.contains(*role)).map(|(_, name)| *name)
    }

    /// Whether the modulation at an index of a component is a stop.
    #[must_use]
    pub fn is_stop(&self, component: ComponentId, modulation: usize) -> bool {
        let node = self.nodes.get(component.index());
        node.and_then(|node| node.modulations.get(modulation)).is_some_and(|modulation| modulation.stops)
    }
}

/// One component of a tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The name that the tree gives it, or its type as the tree lists it.
    pub name: &'static str,
    /// Its type as the tree lists it, if the tree gives it another name.
    pub kind: Option<&'static str>,
    /// The component's doc comment.
    pub doc: &'static str,
    /// Declared rate, runs per second; `None` is a run in every cycle.
    pub hz: Option<f32>,
    /// Declared longest time of one run, µs.
    pub budget_us: Option<f32>,
    /// Whether a state machine continues in the state in which it became latent.
    pub resume: bool,
    /// Which of several components counts that write this one in one cycle; `None` if it does not say so.
    pub writers: Option<InForce>,
    /// Links to the components that this one activates, in the order of the text. Of each state the requirements are
    /// visited in this order, and so are the modulations.
    pub links: &'static [Link],
    /// The states, empty for a component that is no state machine.
    pub states: &'static [State],
    /// The transitions, in the order in which they are evaluated; one entry for each state that it leaves.
    pub transitions: &'static [Transition],
    /// Components of which it asks the age or the outcome.
    pub queries: Queries,
    /// The parameters, one group for each struct. A [`Setting`](crate::Setting) counts them through all groups.
    pub params: &'static [ParamGroup],
    /// The outputs: what an operator may look at.
    pub outputs: &'static [Output],
    /// The modulations: what an operator may call.
    pub modulations: &'static [Modulation],
    /// The function that runs beside the loop.
    pub work: Option<&'static WorkFunction>,
}

impl Transition {
    /// A transition that waits for its condition only.
    #[must_use]
    pub const fn new(name: &'static str, from: usize, to: usize) -> Self {
        Self { name, doc: Doc::new(""), from, to, after_ms: None, after: None, when: None, times: None, carries: None }
    }
}

impl Node {
    /// A component that declares nothing.
    #[must_use]
    pub const fn new(name: &'static str) -> Self {
        Self {
            name,
            kind: None,
            doc: "",
            hz: None,
            budget_us: None,
            resume: false,
            writers: None,
            links: &[],
            states: &[],
            transitions: &[],
            queries: Queries::new(&[]),
            params: &[],
            outputs: &[],
            modulations: &[],
            work: None,
        }
    }

    /// Whether visits of the component are put off to the end of the cycle.
    pub(crate) const fn is_last(&self) -> bool {
        matches!(self.writers, Some(InForce::Last))
    }

    /// Returns the component's type as the tree lists it.
    #[must_use]
    pub fn type_name(&self) -> &'static str {
        self.kind.unwrap_or(self.name)
    }

    /// Returns the type of what a state takes from the transitions that enter it, as in the source text; `None` if it takes nothing.
    #[must_use]
    pub fn takes(&self, state: usize) -> Option<&'static str> {
        self.transitions.iter().filter(|transition| transition.to == state).find_map(|transition| transition.carries)
    }

    /// Returns the parameter with this key, and its index counted through all groups.
    #[must_use]
    pub fn find_param(&self, parameter: impl Key) -> Option<(usize, &'static Param)> {
        let params = || self.params.iter().flat_map(|group| group.params);
        let index = parameter.find(params().map(|param| param.name))?;
        params().nth(index).map(|param| (index, param))
    }

    /// Returns the output with this key, and its index in [`outputs`](Self::outputs).
    #[must_use]
    pub fn find_output(&self, output: impl Key) -> Option<(usize, &'static Output)> {
        let index = output.find(self.outputs.iter().map(|output| output.name))?;
        self.outputs.get(index).map(|output| (index, output))
    }

    /// Returns the modulation with this key, and its index in [`modulations`](Self::modulations).
    #[must_use]
    pub fn find_modulation(&self, modulation: impl Key) -> Option<(usize, &'static Modulation)> {
        let index = modulation.find(self.modulations.iter().map(|modulation| modulation.name))?;
        self.modulations.get(index).map(|modulation| (index, modulation))
    }

    /// Returns the parameter that is the timer of a transition.
    #[must_use]
    pub fn timer(&self, transition: &Transition) -> Option<&'static Param> {
        self.params.iter().flat_map(|group| group.params).nth(transition.after?.into())
    }

    /// Number of parameters in all groups.
    #[must_use]
    pub const fn param_count(&self) -> usize {
        let (mut count, mut group) = (0, 0);
        while group < self.params.len() {
            count += self.params[group].params.len();
            group += 1;
        }
        count
    }
}

/// A function of a component that runs beside the loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WorkFunction {
    /// The function's name.
    pub name: &'static str,
    /// The function's doc comment.
    pub doc: &'static str,
    /// Declared time of a job, ms.
    pub takes_ms: u32,
    /// Whether it runs in slices.
    pub slices: bool,
    /// The type of its result, as in the source text.
    pub result: &'static str,
}

/// A link from a component to one that it activates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Link {
    /// Index of the activated component in [`Graph::nodes`].
    pub to: usize,
    /// Read or written.
    pub kind: LinkKind,
    /// Index of the only state in which the link holds; `None` holds always.
    pub state: Option<usize>,
    /// The roles by which the component asks for the activated one.
    pub roles: Roles,
}

/// A set of roles, by their indices in [`Graph::roles`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Roles(u16);

impl Roles {
    /// No role: the component is linked by its name alone.
    pub const NONE: Self = Self(0);
    /// Largest number of roles of a tree.
    pub const CAPACITY: usize = u16::BITS as usize;

    /// Whether the role of that index is in the set.
    #[must_use]
    pub const fn contains(self, role: usize) -> bool {
        role < Self::CAPACITY && self.0 & 1 << role != 0
    }

    /// The roles of both sets.
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The set with one more role.
    ///
    /// # Panics
    /// If the index is not below [`CAPACITY`](Self::CAPACITY).
    #[must_use]
    pub const fn with(self, role: usize) -> Self {
        assert!(role < Self::CAPACITY, "a tree has at most 16 roles");
        Self(self.0 | 1 << role)
    }
}

/// Which of the components counts that write a child in one cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "wire",
    derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema),
    serde(rename_all = "snake_case")
)]
pub enum InForce {
    /// The first: the child is visited after it, with what was written until then.
    First,
    /// The last: the child is visited at the end of the cycle.
    Last,
}

/// How a component uses a child.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "wire", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum LinkKind {
    /// The child is read: it is visited before the component runs.
    Requirement,
    /// The child is written: it is visited after the component ran.
    Modulation,
}

/// A state of a component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct State {
    /// The function's name.
    pub name: &'static str,
    /// The function's doc comment.
    pub doc: &'static str,
    /// Whether the machine starts here.
    pub initial: bool,
    /// Whether the state is marked to have no transition out of it.
    pub last: bool,
    /// Result with which the machine ends in the state; `None` if it has none, as also in a state that is only marked as last.
    pub end: Option<End>,
    /// Name of the function that runs before the transitions out of it are evaluated; `None` if there is none.
    pub before: Option<&'static str>,
}

/// Result with which a state machine ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "wire",
    derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema),
    serde(rename_all = "snake_case")
)]
pub enum End {
    /// It has done its work: `#[state(done)]`.
    Done,
    /// It could not: `#[state(failed)]`.
    Failed,
}

impl End {
    /// The word in the source: `"done"` or `"failed"`.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Failed => "failed",
        }
    }
}

/// The result of a child for which a transition waits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct When {
    /// Index of the child in [`Graph::nodes`], of which there are at most 255.
    pub child: u8,
    /// The result.
    pub end: End,
}

/// A transition from one state to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Transition {
    /// The function's name. A transition on a state has none: it is called by what it waits for, `done(Reach)` or `timer`.
    pub name: &'static str,
    /// The function's doc comment.
    pub doc: Doc,
    /// Index of the state that it leaves.
    pub from: usize,
    /// Index of the state that it enters.
    pub to: usize,
    /// Shortest time in `from` before the transition is evaluated, ms; of a timer that is a parameter its default.
    pub after_ms: Option<u32>,
    /// Index of the parameter that is the shortest time, counted through the component's groups.
    pub after: Option<u16>,
    /// The result of a child without which it does not hold.
    pub when: Option<When>,
    /// How often it is taken in a row; then it is evaluated no more.
    pub times: Option<u8>,
    /// Type of what it carries to the entry hook of `to`, as in the source text; `None` if its condition is a `bool`.
    pub carries: Option<&'static str>,
}
