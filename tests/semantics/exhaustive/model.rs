//! Tree of a [`Shape`] as the rules see it.

use std::convert::Infallible;

use bica_core::graph::LinkKind;

use super::shape::{COMPONENTS, Link, Shape};
use crate::semantics::rules::{self, Event, Memory, Subject};

/// Stored data of a tree in the model.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Model {
    pub(crate) components: [Memory; COMPONENTS],
    /// Cycles since the last grid point of each component.
    pub(crate) since: [u8; COMPONENTS],
}

impl Model {
    /// Runs one cycle, in which each machine that runs enters its next state.
    pub(crate) fn tick(&mut self, shape: &Shape, answers: [u8; COMPONENTS], events: &mut Vec<Event>) {
        events.clear();
        self.since[..shape.len].iter_mut().for_each(|since| *since += 1);
        let Ok(()) = rules::cycle(&mut Cycle { shape, model: self, answers: &answers, events });
        for (memory, since) in self.components.iter().zip(&mut self.since) {
            *since *= u8::from(memory.active);
        }
    }
}

/// One cycle of a model.
struct Cycle<'a> {
    shape: &'a Shape,
    model: &'a mut Model,
    answers: &'a [u8; COMPONENTS],
    events: &'a mut Vec<Event>,
}

impl Subject for Cycle<'_> {
    type Difference = Infallible;

    fn memories(&mut self) -> &mut [Memory] {
        &mut self.model.components[..self.shape.len]
    }

    fn activator(&self, place: usize) -> usize {
        place
    }

    fn root(&self) -> usize {
        0
    }

    fn links(&self, _: usize) -> usize {
        COMPONENTS
    }

    fn child(&self, of: usize, link: usize, kind: LinkKind) -> Option<usize> {
        let kind = if kind == LinkKind::Requirement { Link::Requirement } else { Link::Modulation };
        let state = self.model.components[of].state.unwrap_or_default();
        (self.shape.links[of][state][link] == kind).then_some(link)
    }

    fn initial(&self, _: usize) -> Option<usize> {
        Some(0)
    }

    fn resumes(&self, _: usize) -> bool {
        false
    }

    fn start(&mut self, of: usize, _: bool) {
        self.model.since[of] = 0;
    }

    fn is_due(&mut self, of: usize) -> bool {
        let left = self.model.since[of].checked_sub(self.shape.rates[of].cycles());
        left.inspect(|&left| self.model.since[of] = left).is_some()
    }

    fn event(&mut self, event: Event) -> Result<(), Infallible> {
        self.events.push(event);
        Ok(())
    }

    fn decide(&mut self, of: usize, _: bool) -> Result<Option<usize>, Infallible> {
        let answer = Some(usize::from(self.answers[of]));
        Ok(answer.filter(|_| self.model.components[of].state != answer))
    }

    fn step(&mut self, _: usize, _: bool) -> Result<(), Infallible> {
        Ok(())
    }
}
