//! Reference model: the rules in the documentation of `bica-core`, written for clarity and not for speed.
//!
//! A [`Subject`] has the links of a tree, the decisions of its components, and the times of their runs.

use bica_core::Hold;
use bica_core::graph::LinkKind;

/// Event that a probe receives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Event {
    Start(usize),
    Stop(usize),
    Skip(usize),
    Run(usize),
    /// Component, and the states that it leaves and enters.
    Transition(usize, usize, usize),
}

/// Stored data of a component.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Memory {
    pub(crate) active: bool,
    visited: bool,
    /// Index of the current state; `None` without states, or if the component was never active.
    pub(crate) state: Option<usize>,
    pub(crate) hold: Hold,
}

/// Tree in one cycle.
pub(crate) trait Subject {
    /// First difference between the actual events and those of the model.
    type Difference;

    fn memories(&mut self) -> &mut [Memory];
    /// Index of the component at a place of an order in which activators come first.
    fn activator(&self, place: usize) -> usize;
    fn root(&self) -> usize;
    /// Number of links of a component.
    fn links(&self, of: usize) -> usize;
    /// End of a link of a component, if the link has this kind and is in force in the component's state.
    fn child(&self, of: usize, link: usize, kind: LinkKind) -> Option<usize>;
    fn initial(&self, of: usize) -> Option<usize>;
    fn resumes(&self, of: usize) -> bool;
    /// Starts the times of a component that becomes active; `entering` unless it resumes a state.
    fn start(&mut self, of: usize, entering: bool);
    /// Whether an active component runs in this cycle; its next run is then due a period later.
    fn is_due(&mut self, of: usize) -> bool;
    /// Takes an event.
    fn event(&mut self, event: Event) -> Result<(), Self::Difference>;
    /// Runs a component up to its transition, and returns the new state.
    fn decide(&mut self, of: usize, entering: bool) -> Result<Option<usize>, Self::Difference>;
    /// Runs the step of a component, or of its state, which it has just entered if `moved`.
    fn step(&mut self, of: usize, moved: bool) -> Result<(), Self::Difference>;
}

/// Runs one cycle: visits the root, then components that are held active; then those stop that were not visited.
pub(crate) fn cycle<S: Subject>(tree: &mut S) -> Result<(), S::Difference> {
    visit(tree, tree.root())?;
    let count = tree.memories().len();
    for place in 0..count {
        let index = tree.activator(place);
        if tree.memories()[index].hold == Hold::Active {
            visit(tree, index)?;
        }
    }
    for place in 0..count {
        let index = tree.activator(place);
        let memory = &mut tree.memories()[index];
        let is_visited = std::mem::take(&mut memory.visited);
        if std::mem::replace(&mut memory.active, is_visited) && !is_visited {
            tree.event(Event::Stop(index))?;
        }
    }
    Ok(())
}

/// A component is visited at most once, and not if it is held latent. It is due when it becomes active. Components that it
/// requires are visited before its run, those that it modulates after.
fn visit<S: Subject>(tree: &mut S, index: usize) -> Result<(), S::Difference> {
    let memory = &mut tree.memories()[index];
    if memory.visited || memory.hold == Hold::Latent {
        return Ok(());
    }
    memory.visited = true;
    let starts = !memory.active;
    let entering = starts && (memory.state.is_none() || !tree.resumes(index));
    if entering {
        tree.memories()[index].state = tree.initial(index);
    }
    if starts {
        tree.start(index, entering);
        tree.event(Event::Start(index))?;
    }
    let is_due = starts || tree.is_due(index);
    if !is_due {
        tree.event(Event::Skip(index))?;
    }
    visit_children(tree, index, LinkKind::Requirement)?;
    if is_due {
        run(tree, index, entering)?;
    }
    visit_children(tree, index, LinkKind::Modulation)
}

fn visit_children<S: Subject>(tree: &mut S, index: usize, kind: LinkKind) -> Result<(), S::Difference> {
    for link in 0..tree.links(index) {
        if let Some(child) = tree.child(index, link, kind) {
            visit(tree, child)?;
        }
    }
    Ok(())
}

/// At most one transition is taken. The components that the new state requires are visited, and it runs, in the same run.
fn run<S: Subject>(tree: &mut S, index: usize, entering: bool) -> Result<(), S::Difference> {
    tree.event(Event::Run(index))?;
    let next = tree.decide(index, entering)?;
    if let Some(to) = next {
        let from = tree.memories()[index].state.replace(to).expect("a machine");
        tree.event(Event::Transition(index, from, to))?;
        visit_children(tree, index, LinkKind::Requirement)?;
    }
    tree.step(index, next.is_some())
}
