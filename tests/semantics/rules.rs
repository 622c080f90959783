//! Reference model: the rules in the documentation of `bica-core`, written for clarity rather than speed.

use bica::Hold;
use bica::graph::{End, InForce, LinkKind};

use super::graph::{Comparison, Model};

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
#[expect(clippy::struct_excessive_bools, reason = "each is a fact of its own, as in the text of the semantics")]
pub(crate) struct Memory {
    pub(crate) active: bool,
    visited: bool,
    /// Index of the current state; `None` without states, or if the component was never active.
    pub(crate) state: Option<usize>,
    pub(crate) hold: Hold,
    /// The next visit starts the machine in its initial state, as its activator entered a state that waits for its result.
    anew: bool,
    /// A component with `writers = last` is to be visited at the end of the cycle.
    put_off: bool,
    /// A tick unwound while it was active.
    pub(crate) interrupted: bool,
}

impl Memory {
    /// Ends its visit in a cycle that unwinds.
    pub(crate) fn end_visit(&mut self) {
        (self.visited, self.put_off) = (false, false);
    }
}

impl Model {
    /// Runs one cycle: stops what was active when the last tick unwound; visits the root, then all components that are held active, then
    /// those that were put off; then stops the components that were not visited.
    pub(crate) fn cycle(&mut self) -> Comparison {
        for index in self.activators_first.clone() {
            let memory = &mut self.memories[index];
            if std::mem::take(&mut memory.interrupted) {
                (memory.active, memory.state, memory.anew) = (false, None, false);
                self.discard(index)?;
            }
        }
        self.visit(self.graph.root)?;
        for index in self.activators_first.clone() {
            if self.memories[index].hold == Hold::Active {
                self.visit(index)?;
            }
        }
        for index in self.activators_first.clone() {
            if std::mem::take(&mut self.memories[index].put_off) {
                self.visit_now(index)?;
            }
        }
        self.going = None;
        for index in self.activators_first.clone() {
            let memory = &mut self.memories[index];
            let is_visited = std::mem::take(&mut memory.visited);
            if std::mem::replace(&mut memory.active, is_visited) && !is_visited {
                self.event(Event::Stop(index))?;
            }
        }
        Ok(())
    }

    /// Visits a component, or puts its visit off to the end of the cycle.
    fn visit(&mut self, index: usize) -> Comparison {
        if self.graph.nodes[index].writers == Some(InForce::Last) {
            self.memories[index].put_off = true;
            return Ok(());
        }
        self.visit_now(index)
    }

    /// Visits a component: at most once in a cycle, and not if it is held latent. A component that becomes active is
    /// due. The components that it requires are visited before its run, those that it modulates after it.
    fn visit_now(&mut self, index: usize) -> Comparison {
        let memory = &mut self.memories[index];
        if memory.visited || memory.hold == Hold::Latent {
            return Ok(());
        }
        memory.visited = true;
        let node = &self.graph.nodes[index];
        let (was_active, anew) = (memory.active, std::mem::take(&mut memory.anew));
        let starts = !was_active || anew;
        let entering = starts && (memory.state.is_none() || !node.resume || anew);
        if entering {
            memory.state = node.states.iter().position(|state| state.initial);
        }
        if starts && was_active {
            self.event(Event::Stop(index))?;
        }
        if starts {
            self.start(index, entering);
            self.event(Event::Start(index))?;
        }
        if entering {
            self.ask(index);
        }
        let is_due = starts || self.is_due(index);
        let goes = self.going.take_if(|(machine, _)| *machine == index);
        if let Some((_, to)) = goes.filter(|_| !starts) {
            return self.go(index, to);
        }
        if !is_due {
            self.event(Event::Skip(index))?;
        }
        self.visit_children(index, LinkKind::Requirement)?;
        if is_due {
            self.run(index, entering)?;
        }
        self.visit_children(index, LinkKind::Modulation)
    }

    /// The children for whose results the entered state waits begin anew.
    fn ask(&mut self, index: usize) {
        let Some(state) = self.memories[index].state else { return };
        for transition in self.graph.nodes[index].transitions.iter().filter(|one| one.from == state) {
            let waits_for = transition.when.map(|when| usize::from(when.child));
            let children: Vec<_> = waits_for.into_iter().chain(self.outcomes(index, transition.name)).collect();
            for child in children {
                let child = &mut self.memories[child];
                child.anew |= child.state.is_some();
            }
        }
    }

    /// Whether a child is active and in a state with this result.
    pub(super) fn has_ended(&self, child: usize, end: End) -> bool {
        let (memory, states) = (&self.memories[child], self.graph.nodes[child].states);
        let is_active = memory.active || memory.visited;
        is_active && !memory.anew && memory.state.is_some_and(|state| states[state].end == Some(end))
    }

    /// Visits the ends of the links of a kind that are in force in the component's state.
    fn visit_children(&mut self, index: usize, kind: LinkKind) -> Comparison {
        for link in self.graph.nodes[index].links {
            if link.kind == kind && (link.state.is_none() || link.state == self.memories[index].state) {
                self.visit(link.to)?;
            }
        }
        Ok(())
    }

    /// Makes a machine go to a state in the next cycle; returns whether it can.
    pub(crate) fn goes(&mut self, index: usize, to: usize) -> bool {
        let (memory, node) = (&self.memories[index], &self.graph.nodes[index]);
        let can_be_entered = node.takes(to).is_none() || node.states[to].initial;
        let is_alone = self.going.is_none_or(|(machine, _)| machine == index);
        let goes = memory.active && memory.hold != Hold::Latent && can_be_entered && is_alone;
        if goes {
            self.going = Some((index, to));
        }
        goes
    }

    /// Runs a machine that goes to a state by request, whether it is due or not: it tries no transition, and nothing is visited for the
    /// state that it leaves.
    fn go(&mut self, index: usize, to: usize) -> Comparison {
        self.event(Event::Run(index))?;
        self.leave(index)?;
        self.enter(index, to)?;
        self.step(index, true)?;
        self.visit_children(index, LinkKind::Modulation)
    }

    /// Enters a state, and visits what it requires.
    fn enter(&mut self, index: usize, to: usize) -> Comparison {
        let from = self.memories[index].state.replace(to).expect("a machine");
        self.event(Event::Transition(index, from, to))?;
        self.ask(index);
        self.visit_children(index, LinkKind::Requirement)
    }

    /// Runs a component; takes at most one transition. In the same run, the components that the new state requires are
    /// visited, and the new state runs.
    fn run(&mut self, index: usize, entering: bool) -> Comparison {
        self.event(Event::Run(index))?;
        let next = self.decide(index, entering)?;
        if let Some(to) = next {
            self.enter(index, to)?;
        }
        self.step(index, next.is_some())
    }
}
