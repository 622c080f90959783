//! The static description of a tree: what every tool reads and what the compiler checks.

/// A tree of components, all that is known before it runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Graph {
    /// The tree's name.
    pub name: &'static str,
    /// The tree's doc comment.
    pub doc: &'static str,
    /// How often the tree is meant to be ticked, 1/s.
    pub cycle_hz: f32,
    /// How long one cycle may take, ms.
    pub budget_ms: Option<f32>,
    /// Index of the root in `nodes`.
    pub root: usize,
    /// The components, in the order in which the tree lists them.
    pub nodes: &'static [Node],
}

/// One component of a tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The component's type as the tree lists it.
    pub name: &'static str,
    /// The component's doc comment.
    pub doc: &'static str,
    /// Declared rate, runs per second; `None` runs in every cycle.
    pub hz: Option<f32>,
    /// Declared time for one run, µs.
    pub budget_us: Option<f32>,
    /// Whether a state machine goes on in the state that it was in when it became latent.
    pub resume: bool,
    /// The components that this one activates.
    pub links: &'static [Link],
    /// The states, empty for a component that is no state machine.
    pub states: &'static [State],
    /// The transitions, in the order in which they are tried; one entry for each state that it leaves.
    pub transitions: &'static [Transition],
}

/// A component activates another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Link {
    /// Index of the activated component in [`Graph::nodes`].
    pub to: usize,
    /// Read or written.
    pub kind: LinkKind,
    /// Index of the only state in which the link holds; `None` holds always.
    pub state: Option<usize>,
}

/// What a component does with a child.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkKind {
    /// Read: stepped before.
    Requirement,
    /// Written: stepped after.
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
    /// Whether the state is meant to have no way out.
    pub last: bool,
}

/// A way from one state to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Transition {
    /// The function's name.
    pub name: &'static str,
    /// The function's doc comment.
    pub doc: &'static str,
    /// Index of the state that it leaves.
    pub from: usize,
    /// Index of the state that it enters.
    pub to: usize,
    /// The least time in `from`, ms.
    pub after_ms: Option<u32>,
}
