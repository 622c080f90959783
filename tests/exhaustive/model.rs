//! Model of a tree of a [`Shape`], written from the rules in the documentation of the crate.

use bica_core::Hold;

use crate::shape::{COMPONENTS, Link, Shape};

/// Event that a probe receives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Event {
    Start(usize),
    Stop(usize),
    Skip(usize),
    Run(usize),
    Transition(usize, usize, usize),
}

/// Stored data of a component in the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Memory {
    pub(crate) active: bool,
    visited: bool,
    /// Index of the current state; `None` if the component was never active.
    pub(crate) state: Option<usize>,
    /// Cycles since the last grid point.
    pub(crate) since: u8,
    pub(crate) hold: Hold,
}

/// Model of a tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Model {
    pub(crate) components: [Memory; COMPONENTS],
}

/// One cycle of a model.
struct Cycle<'a> {
    shape: &'a Shape,
    model: &'a mut Model,
    answers: &'a [u8; COMPONENTS],
    events: &'a mut Vec<Event>,
}

impl Model {
    pub(crate) fn new() -> Self {
        let memory = Memory { active: false, visited: false, state: None, since: 0, hold: Hold::Tree };
        Self { components: [memory; COMPONENTS] }
    }

    /// Runs one cycle, in which each machine that runs enters its next state.
    pub(crate) fn tick(&mut self, shape: &Shape, answers: [u8; COMPONENTS], events: &mut Vec<Event>) {
        events.clear();
        for memory in &mut self.components[..shape.len] {
            memory.since += 1;
        }
        Cycle { shape, model: self, answers: &answers, events }.run();
    }
}

impl Cycle<'_> {
    fn run(&mut self) {
        self.visit(0);
        for index in 0..self.shape.len {
            if self.model.components[index].hold == Hold::Active {
                self.visit(index);
            }
        }
        for index in 0..self.shape.len {
            let memory = &mut self.model.components[index];
            if memory.active && !memory.visited {
                self.events.push(Event::Stop(index));
            }
            memory.active = std::mem::take(&mut memory.visited);
            if !memory.active {
                memory.since = 0;
            }
        }
    }

    fn visit(&mut self, index: usize) {
        let memory = &mut self.model.components[index];
        if memory.visited || memory.hold == Hold::Latent {
            return;
        }
        memory.visited = true;
        let period = self.shape.rates[index].cycles();
        let is_due = if memory.active {
            memory.since >= period
        } else {
            (memory.state, memory.since) = (Some(0), period);
            self.events.push(Event::Start(index));
            true
        };
        if is_due {
            memory.since -= period;
        } else {
            self.events.push(Event::Skip(index));
        }
        self.visit_children(index, Link::Requirement);
        if is_due {
            self.run_component(index);
        }
        self.visit_children(index, Link::Modulation);
    }

    fn run_component(&mut self, index: usize) {
        self.events.push(Event::Run(index));
        let memory = &mut self.model.components[index];
        let (from, to) = (memory.state.unwrap_or_default(), usize::from(self.answers[index]));
        if from != to {
            memory.state = Some(to);
            self.events.push(Event::Transition(index, from, to));
            self.visit_children(index, Link::Requirement);
        }
    }

    fn visit_children(&mut self, index: usize, kind: Link) {
        let state = self.model.components[index].state.unwrap_or_default();
        let row = self.shape.links[index][state];
        for (child, _) in row.iter().enumerate().filter(|(_, link)| **link == kind) {
            self.visit(child);
        }
    }
}
