//! Reference model: an interpreter of a `GRAPH` that follows the rules, written for clarity and not for speed.

use std::vec::IntoIter;

use bica::graph::{Graph, Link, LinkKind, Transition};
use bica::prelude::*;

use super::event::{Event, Read, Times};
use super::test_tree::Hook;
use super::unit::{bit, mix};

/// Ticks of the clock per second.
const SECOND: f64 = 1e6;

/// Period, in ticks of the clock, from which a component never runs.
const NEVER: f64 = 4_611_686_018_427_387_904.0;

/// Number of bits of a fraction of a tick in [`Memory::grid`].
const FRACTION_BITS: u32 = 32;

/// Stored data of a component, and of the test component's own code.
#[derive(Clone, Debug, Default)]
pub(crate) struct Memory {
    pub(crate) active: bool,
    visited: bool,
    pub(crate) state: Option<usize>,
    pub(crate) hz: Option<f32>,
    /// Last grid point at which the component ran, in fractions of a tick.
    grid: i128,
    /// Instant of the last run since the component became active.
    ran: u64,
    /// Instant at which the state was entered; without states, at which the component became active.
    pub(crate) entered: u64,
    /// Whether the component was ever active.
    pub(crate) started: bool,
    pub(crate) hold: Hold,
    pub(crate) flags: u32,
    value: u64,
    received: u64,
}

/// Model of a tree.
pub(crate) struct Model {
    graph: Graph,
    hooks: &'static [Hook],
    pub(crate) components: Vec<Memory>,
    now: u64,
    /// Actual events that the model has not yet expected.
    events: IntoIter<Event>,
}

/// `Err` with the first difference between the tree and the model.
pub(crate) type Comparison = Result<(), String>;

impl Model {
    pub(crate) fn new(graph: Graph, hooks: &'static [Hook]) -> Self {
        let components = graph.nodes.iter().map(|node| Memory { hz: node.hz, ..Memory::default() }).collect();
        Self { graph, hooks, components, now: 0, events: Vec::new().into_iter() }
    }

    /// Rule 4: a rate can be set between 0 and the declared rate.
    pub(crate) fn set_rate(&mut self, index: usize, hz: f32) {
        let declared = self.graph.nodes[index].hz;
        self.components[index].hz = match declared {
            _ if hz.is_nan() => declared,
            _ if hz.is_sign_negative() => Some(0.0),
            Some(most) if most < hz => declared,
            _ => Some(hz),
        };
    }

    /// Runs one cycle and compares the actual events with those that the rules require.
    pub(crate) fn tick(&mut self, now: u64, events: Vec<Event>) -> Comparison {
        (self.now, self.events) = (now, events.into_iter());
        self.expect(&Event::CycleBegin(now))?;
        self.visit(self.graph.root)?;
        let order = self.activators_first();
        for &index in &order {
            if self.components[index].hold == Hold::Active {
                self.visit(index)?;
            }
        }
        for &index in &order {
            if self.components[index].active && !self.components[index].visited {
                self.expect(&Event::Stopped(self.graph.nodes[index].name))?;
                self.expect(&Event::Stop(index))?;
            }
        }
        for memory in &mut self.components {
            memory.active = std::mem::take(&mut memory.visited);
        }
        self.expect(&Event::CycleEnd)?;
        self.events.next().map_or(Ok(()), |event| Err(format!("{event:?}after the expected end")))
    }

    /// Rules 1, 2, 5 and 8.
    fn visit(&mut self, index: usize) -> Comparison {
        if self.components[index].visited || self.components[index].hold == Hold::Latent {
            return Ok(());
        }
        self.components[index].visited = true;
        let newly_active = !self.components[index].active;
        let entering = newly_active && self.start(index)?;
        let due = newly_active || self.is_due(index);
        if !due {
            self.expect(&Event::Skip(index))?;
        }
        self.visit_children(index, LinkKind::Requirement)?;
        if due {
            self.run(index, entering)?;
        }
        self.visit_children(index, LinkKind::Modulation)
    }

    /// Rules 5 and 6. Returns whether the entry hooks of the initial state follow.
    fn start(&mut self, index: usize) -> Result<bool, String> {
        let node = &self.graph.nodes[index];
        let resumes = node.resume && self.components[index].state.is_some();
        let memory = &mut self.components[index];
        memory.grid = i128::from(self.now) << FRACTION_BITS;
        (memory.ran, memory.started) = (self.now, true);
        if !resumes {
            memory.entered = self.now;
            memory.state = node.states.iter().position(|state| state.initial);
        }
        self.expect(&Event::Start(index))?;
        self.expect(&Event::Started(node.name))?;
        Ok(!resumes)
    }

    /// Rule 3. A component that runs in every cycle does not use the grid.
    ///
    /// Comparisons are in whole ticks; differences of instants are taken modulo 2⁶⁴, as signed numbers.
    fn is_due(&mut self, index: usize) -> bool {
        let cycle = SECOND / f64::from(self.graph.cycle_hz);
        let share = self.graph.nodes[index].hz.map_or(1.0, |hz| hz / self.graph.cycle_hz);
        let (early, late) = if share > 0.5 { (cycle / 2.0, cycle / 2.0) } else { (cycle / 4.0, 0.0) };
        let (early, late) = (early as i128, late as i128);
        let memory = &mut self.components[index];
        let period = match memory.hz {
            None => return true,
            Some(hz) if hz <= 0.0 => return false,
            Some(hz) => SECOND / f64::from(hz),
        };
        if !(1.0..NEVER).contains(&period) {
            return period < 1.0;
        }
        let whole = period as i128;
        let since = i128::from(self.now.wrapping_sub((memory.grid >> FRACTION_BITS) as u64).cast_signed());
        if (-whole..whole - early).contains(&since) {
            return false;
        }
        if (whole - early..2 * whole + late).contains(&since) {
            memory.grid += (period * (1_u64 << FRACTION_BITS) as f64) as i128;
        } else {
            memory.grid = i128::from(self.now) << FRACTION_BITS;
        }
        true
    }

    fn visit_children(&mut self, index: usize, kind: LinkKind) -> Comparison {
        let state = self.components[index].state;
        let is_in_force = |link: &&Link| link.kind == kind && (link.state.is_none() || link.state == state);
        self.graph.nodes[index].links.iter().filter(is_in_force).try_for_each(|link| self.visit(link.to))
    }

    /// Rules 2 and 7.
    fn run(&mut self, index: usize, entering: bool) -> Comparison {
        self.expect(&Event::Run(index))?;
        self.expect(&Event::Begin(index))?;
        if let Some(state) = self.components[index].state {
            if entering {
                self.hooks(index, state, true)?;
            }
            if let Some(transition) = self.transition(index, state)? {
                self.hooks(index, state, false)?;
                self.expect(&Event::End(index))?;
                self.expect(&Event::Transition(index, state, transition.to))?;
                let memory = &mut self.components[index];
                (memory.state, memory.entered) = (Some(transition.to), self.now);
                self.visit_children(index, LinkKind::Requirement)?;
                self.expect(&Event::Begin(index))?;
                self.hooks(index, transition.to, true)?;
            }
        }
        self.body(index)?;
        self.components[index].ran = self.now;
        self.expect(&Event::End(index))
    }

    /// Returns the first transition that is taken.
    fn transition(&mut self, index: usize, state: usize) -> Result<Option<Transition>, String> {
        let transitions = self.graph.nodes[index].transitions.iter().enumerate();
        for (number, &transition) in transitions.filter(|(_, transition)| transition.from == state) {
            let stayed = transition.after_ms.is_none_or(|ms| self.in_state(index) >= u64::from(ms) * 1000);
            if !stayed {
                continue;
            }
            let holds = transition.name.starts_with("timer") || self.evaluate(index, transition.name)?;
            self.expect(&Event::Condition(index, number, holds))?;
            if holds {
                return Ok(Some(transition));
            }
        }
        Ok(None)
    }

    /// Compares the evaluation of a transition, and returns its result.
    fn evaluate(&mut self, index: usize, name: &'static str) -> Result<bool, String> {
        match self.next()? {
            Event::Evaluated { by, transition, reads } if by == self.graph.nodes[index].name && transition == name => {
                self.read(&reads)?;
                Ok(self.components[index].flags & bit(name) != 0)
            }
            other => Err(format!("{other:?} instead of the evaluation of {name}")),
        }
    }

    fn hooks(&mut self, index: usize, state: usize, entry: bool) -> Comparison {
        let node = &self.graph.nodes[index];
        let (name, state) = (node.name, node.states[state].name);
        for expected in self.hooks.iter().filter(|hook| hook.of == name && hook.state == state && hook.entry == entry) {
            match self.next()? {
                Event::Hook { of, hook, reads, writes } if of == name && hook == expected.name => {
                    self.read(&reads)?;
                    self.write(index, &writes);
                }
                other => return Err(format!("{other:?} instead of {expected:?}")),
            }
        }
        Ok(())
    }

    /// Compares a step, or the body of the current state.
    fn body(&mut self, index: usize) -> Comparison {
        let node = &self.graph.nodes[index];
        let current = self.components[index].state.map_or("", |state| node.states[state].name);
        loop {
            match self.next()? {
                Event::RateSet { of, hz } => self.set_rate(self.named(of), f32::from_bits(hz)),
                Event::Body { of, state, time, reads, writes } if of == node.name && state == current => {
                    self.times(index, time)?;
                    self.read(&reads)?;
                    let memory = &mut self.components[index];
                    memory.value = mix(memory.value, std::mem::take(&mut memory.received) + 1);
                    self.write(index, &writes);
                    return Ok(());
                }
                other => return Err(format!("{other:?} instead of the body of {} in {current:?}", node.name)),
            }
        }
    }

    /// Time in the state. After the clock was set back to before the entry, the time counts from there.
    fn in_state(&mut self, index: usize) -> u64 {
        let memory = &mut self.components[index];
        memory.entered = memory.entered.min(self.now);
        self.now - memory.entered
    }

    fn times(&mut self, index: usize, time: Times) -> Comparison {
        let expected = (self.now, self.now.saturating_sub(self.components[index].ran), self.in_state(index));
        if time == expected { Ok(()) } else { Err(format!("time is {time:?} instead of {expected:?}")) }
    }

    /// Checks that the values read are those of the last runs.
    fn read(&self, reads: &[Read]) -> Comparison {
        let wrong = reads.iter().find(|(name, value)| self.components[self.named(name)].value != *value);
        wrong.map_or(Ok(()), |read| Err(format!("{read:?} is read instead of the value of the last run")))
    }

    fn write(&mut self, index: usize, writes: &[&'static str]) {
        let value = self.components[index].value;
        for name in writes {
            let to = self.named(name);
            self.components[to].received = mix(self.components[to].received, value);
        }
    }

    pub(crate) fn named(&self, name: &str) -> usize {
        self.graph.nodes.iter().position(|node| node.name == name).expect("a component of the tree")
    }

    fn next(&mut self) -> Result<Event, String> {
        self.events.next().ok_or_else(|| "no further event".into())
    }

    fn expect(&mut self, expected: &Event) -> Comparison {
        let event = self.next()?;
        if event == *expected { Ok(()) } else { Err(format!("{event:?} instead of {expected:?}")) }
    }

    /// All components, each after those that can activate it; otherwise in the order of the list.
    fn activators_first(&self) -> Vec<usize> {
        let mut order: Vec<usize> = Vec::new();
        while order.len() < self.components.len() {
            let waits = |index: usize| {
                let activates = |&from: &usize| self.graph.nodes[from].links.iter().any(|link| link.to == index);
                (0..self.components.len()).filter(activates).any(|from| !order.contains(&from))
            };
            let next = (0..self.components.len()).find(|index| !order.contains(index) && !waits(*index));
            order.push(next.expect("no activation cycle"));
        }
        order
    }
}
