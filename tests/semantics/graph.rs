//! Model of a tree for the rules: its `GRAPH`, and the recorded events, which must be those that the rules require.

use std::vec::IntoIter;

use bica::End;
use bica::graph::{Graph, LinkKind, Transition};

use super::event::{Event, Read, Times};
use super::jobs::Job;
use super::rules::{self, Memory};
use super::test_tree::Hook;
use super::unit::{Carried, HOOK, bit, mix};

/// Ticks of the clock per second.
const SECOND: f64 = 1e6;

/// Period from which a component never runs, ticks of the clock.
const NEVER: f64 = 4_611_686_018_427_387_904.0;

/// Difference if the tree made fewer calls than the rules require.
pub(super) const NO_EVENT: &str = "no further event";

/// Number of bits for fractions of a tick in [`Times`].
const FRACTION_BITS: u32 = 32;

/// Times of a component, and data of the test component's own code.
#[derive(Clone, Debug, Default)]
pub(crate) struct Data {
    pub(crate) hz: Option<f32>,
    /// Last grid point at which the component ran, in fractions of a tick.
    grid: i128,
    /// Instant of the last run since the component became active.
    ran: u64,
    /// Instant at which the state was entered; without states, at which the component became active.
    pub(crate) entered: u64,
    /// Whether the component was ever active.
    pub(crate) started: bool,
    pub(crate) flags: u32,
    pub(super) value: u64,
    pub(super) received: u64,
    /// Value that the transition of this run found.
    pub(super) found: Option<Carried>,
    /// Number of transitions with `times` in a row.
    taken: u8,
    pub(super) job: Job,
}

/// Model of a tree.
pub(crate) struct Model {
    pub(super) graph: Graph,
    hooks: &'static [Hook],
    /// Outcomes that functions of transitions take: component, function and child.
    outcomes: &'static [[&'static str; 3]],
    pub(crate) memories: Vec<Memory>,
    pub(crate) components: Vec<Data>,
    pub(super) activators_first: Vec<usize>,
    /// Machine that goes to a state in the next cycle, and that state.
    pub(super) going: Option<(usize, usize)>,
    pub(super) now: u64,
    /// Whether jobs have ended in this cycle, and visits begun.
    pub(super) visits: bool,
    /// Recorded events that have not been compared with the model yet.
    events: IntoIter<Event>,
}

/// Result of a comparison; `Err` describes the first difference between the tree and the model.
pub(crate) type Comparison = Result<(), String>;

impl Model {
    pub(crate) fn new(graph: Graph, hooks: &'static [Hook], outcomes: &'static [[&'static str; 3]]) -> Self {
        Self {
            graph,
            hooks,
            outcomes,
            memories: vec![Memory::default(); graph.nodes.len()],
            components: graph.nodes.iter().map(|node| Data { hz: node.hz, ..Data::default() }).collect(),
            activators_first: activators_first(&graph),
            going: None,
            now: 0,
            visits: false,
            events: Vec::new().into_iter(),
        }
    }

    /// Sets a rate, which is limited to the range from 0 to the declared rate.
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
        self.visits = false;
        self.expect(&Event::CycleBegin(now))?;
        self.end_jobs()?;
        self.visits = true;
        self.cycle()?;
        self.begin_jobs()?;
        self.expect(&Event::CycleEnd)?;
        self.events.next().map_or(Ok(()), |event| Err(format!("{event:?} after the expected end")))
    }

    /// Compares the call of the function before the transitions; returns the first transition that is taken.
    fn transition(&mut self, index: usize, state: usize) -> Result<Option<Transition>, String> {
        if let Some(before) = self.graph.nodes[index].states[state].before {
            self.hook(index, before, None)?;
        }
        let transitions = self.graph.nodes[index].transitions.iter().enumerate();
        for (number, &transition) in transitions.filter(|(_, transition)| transition.from == state) {
            let stayed = transition.after_ms.is_none_or(|ms| self.in_state(index) >= u64::from(ms) * 1000);
            let taken = self.components[index].taken;
            if !stayed || transition.times.is_some_and(|times| taken >= times) {
                continue;
            }
            let is_bare = transition.name.starts_with("timer") || transition.name.ends_with(')');
            let has_result = transition.when.is_none_or(|when| self.has_ended(when.child.into(), when.end));
            let holds = has_result && (is_bare || self.evaluate(index, transition.name)?);
            self.expect(&Event::Condition(index, number, holds))?;
            if holds {
                let value = self.components[index].value;
                self.components[index].found = transition.carries.map(|_| (transition.name, value));
                self.count(index, transition);
                return Ok(Some(transition));
            }
        }
        Ok(None)
    }

    /// Counts the transitions with `times` that follow each other. The way back from the state that one enters does not end the row.
    fn count(&mut self, index: usize, taken: Transition) {
        let mut counted = self.graph.nodes[index].transitions.iter().filter(|one| one.times.is_some());
        let is_way_back = counted.any(|one| one.to == taken.from && one.from == taken.to);
        let count = &mut self.components[index].taken;
        *count = if taken.times.is_some() {
            *count + 1
        } else if is_way_back {
            *count
        } else {
            0
        };
    }

    /// The children whose outcomes the function of a transition takes.
    pub(super) fn outcomes(&self, index: usize, function: &'static str) -> impl Iterator<Item = usize> + use<'_> {
        let own = self.outcomes.iter().filter(move |one| one[..2] == [self.graph.nodes[index].name, function]);
        own.map(|one| self.named(one[2]))
    }

    /// Compares the outcomes that the function of a transition takes, and its evaluation; returns its result.
    fn evaluate(&mut self, index: usize, name: &'static str) -> Result<bool, String> {
        for child in self.outcomes(index, name).collect::<Vec<_>>() {
            let ended = [End::Done, End::Failed].into_iter().find(|end| self.has_ended(child, *end));
            self.expect(&Event::Ended { of: self.graph.nodes[child].name, end: ended })?;
        }
        match self.next()? {
            Event::Evaluated { by, transition, reads } if by == self.graph.nodes[index].name && transition == name => {
                self.read(&reads)?;
                Ok(self.components[index].flags & bit(name) != 0)
            }
            other => Err(format!("{other:?} instead of the evaluation of {name}")),
        }
    }

    /// Compares the hooks of a state. The first entry hook takes the value that the transition found.
    fn hooks(&mut self, index: usize, state: usize, entry: bool) -> Comparison {
        let node = &self.graph.nodes[index];
        let (name, state) = (node.name, node.states[state].name);
        let mut found = if entry { self.components[index].found.take() } else { None };
        for expected in self.hooks.iter().filter(|hook| hook.of == name && hook.state == state && hook.entry == entry) {
            self.hook(index, expected.name, found.take())?;
        }
        Ok(())
    }

    /// Compares the call of a hook, and the value that it takes.
    fn hook(&mut self, index: usize, name: &'static str, taken: Option<Carried>) -> Comparison {
        match self.next()? {
            Event::Hook { of, hook, found, reads, writes }
                if of == self.graph.nodes[index].name && hook == name && found == taken =>
            {
                self.read(&reads)?;
                self.components[index].value = mix(self.components[index].value, HOOK);
                self.write(index, &writes)
            }
            other => Err(format!("{other:?} instead of hook {name} with {taken:?}")),
        }
    }

    /// Compares a step, or the body of the current state.
    fn body(&mut self, index: usize) -> Comparison {
        let node = &self.graph.nodes[index];
        let current = self.memories[index].state.map_or("", |state| node.states[state].name);
        loop {
            match self.next()? {
                Event::RateSet { of, hz } => self.set_rate(self.named(of), f32::from_bits(hz)),
                Event::Aged { of, since_run } => self.aged(self.named(of), since_run)?,
                Event::Worked { of, result, is_idle } if of == node.name => self.worked(index, (result, is_idle))?,
                Event::Body { of, state, time, reads, writes } if of == node.name && state == current => {
                    self.times(index, time)?;
                    self.read(&reads)?;
                    let memory = &mut self.components[index];
                    memory.value = mix(memory.value, std::mem::take(&mut memory.received) + 1);
                    return self.write(index, &writes);
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

    /// Checks the age of a component that was ever active.
    fn aged(&self, index: usize, since_run: Option<u64>) -> Comparison {
        let data = &self.components[index];
        let expected = data.started.then(|| self.now.saturating_sub(data.ran));
        if since_run == expected { Ok(()) } else { Err(format!("age is {since_run:?} instead of {expected:?}")) }
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

    /// Writes values, for which the state needs modulations.
    fn write(&mut self, index: usize, writes: &[&'static str]) -> Comparison {
        let (value, state, links) =
            (self.components[index].value, self.memories[index].state, self.graph.nodes[index].links);
        for name in writes {
            let to = self.named(name);
            let mut own = links.iter().filter(|link| link.to == to && (link.state.is_none() || link.state == state));
            if own.all(|link| link.kind != LinkKind::Modulation) {
                return Err(format!("{name} is written without a modulation"));
            }
            self.components[to].received = mix(self.components[to].received, value);
        }
        Ok(())
    }

    pub(crate) fn named(&self, name: &str) -> usize {
        self.graph.nodes.iter().position(|node| node.name == name).expect("a component of the tree")
    }

    fn next(&mut self) -> Result<Event, String> {
        self.events.next().ok_or_else(|| NO_EVENT.into())
    }

    pub(super) fn expect(&mut self, expected: &Event) -> Comparison {
        let event = self.next()?;
        if event == *expected { Ok(()) } else { Err(format!("{event:?} instead of {expected:?}")) }
    }
}

impl Model {
    /// Sets the times of a component that becomes active; `entering` is false if it resumes a state.
    pub(super) fn start(&mut self, of: usize, entering: bool) {
        let data = &mut self.components[of];
        data.grid = i128::from(self.now) << FRACTION_BITS;
        (data.ran, data.started) = (self.now, true);
        if entering {
            (data.entered, data.taken) = (self.now, 0);
        }
    }

    /// Returns whether an active component runs in this cycle; its next run is then due one period later.
    ///
    /// A component that runs in every cycle does not use the grid.
    ///
    /// Comparisons are in whole ticks; differences of instants are taken modulo 2⁶⁴, as signed numbers.
    pub(super) fn is_due(&mut self, of: usize) -> bool {
        let cycle = SECOND / f64::from(self.graph.cycle_hz);
        let share = self.graph.nodes[of].hz.map_or(1.0, |hz| hz / self.graph.cycle_hz);
        let (early, late) = if share > 0.5 { (cycle / 2.0, cycle / 2.0) } else { (cycle / 4.0, 0.0) };
        let (early, late) = (early as i128, late as i128);
        let data = &mut self.components[of];
        let period = match data.hz {
            None => return true,
            Some(hz) if hz <= 0.0 => return false,
            Some(hz) => SECOND / f64::from(hz),
        };
        if !(1.0..NEVER).contains(&period) {
            return period < 1.0;
        }
        let whole = period as i128;
        let since = i128::from(self.now.wrapping_sub((data.grid >> FRACTION_BITS) as u64).cast_signed());
        if (-whole..whole - early).contains(&since) {
            return false;
        }
        if (whole - early..2 * whole + late).contains(&since) {
            data.grid += (period * (1_u64 << FRACTION_BITS) as f64) as i128;
        } else {
            data.grid = i128::from(self.now) << FRACTION_BITS;
        }
        true
    }

    /// Compares an event.
    pub(super) fn event(&mut self, event: rules::Event) -> Comparison {
        let name = |index: usize| self.graph.nodes[index].name;
        match event {
            rules::Event::Start(index) => {
                let started = Event::Started(name(index));
                self.expect(&Event::Framework(event))?;
                self.expect(&started)
            }
            rules::Event::Stop(index) => {
                self.components[index].job = Job::None;
                let stopped = Event::Stopped(name(index));
                self.expect(&stopped)?;
                self.expect(&Event::Framework(event))
            }
            rules::Event::Transition(index, ..) => {
                self.components[index].entered = self.now;
                self.expect(&Event::Framework(event))
            }
            _ => self.expect(&Event::Framework(event)),
        }
    }

    /// Runs a component up to its transition; returns the new state.
    pub(super) fn decide(&mut self, of: usize, entering: bool) -> Result<Option<usize>, String> {
        self.expect(&Event::Begin(of))?;
        let Some(state) = self.memories[of].state else { return Ok(None) };
        if entering {
            self.hooks(of, state, true)?;
        }
        let Some(transition) = self.transition(of, state)? else { return Ok(None) };
        self.hooks(of, state, false)?;
        self.expect(&Event::End(of))?;
        Ok(Some(transition.to))
    }

    /// Leaves the state of a machine that goes to another one by request.
    pub(super) fn leave(&mut self, of: usize) -> Comparison {
        self.expect(&Event::Begin(of))?;
        self.hooks(of, self.memories[of].state.unwrap_or_default(), false)?;
        self.components[of].taken = 0;
        self.expect(&Event::End(of))
    }

    /// Runs the step of a component, or of its state; `moved` is true if it has just entered the state.
    pub(super) fn step(&mut self, of: usize, moved: bool) -> Comparison {
        if let Some(state) = self.memories[of].state.filter(|_| moved) {
            self.expect(&Event::Begin(of))?;
            self.hooks(of, state, true)?;
        }
        self.body(of)?;
        self.components[of].ran = self.now;
        self.expect(&Event::End(of))
    }
}

/// Returns all components, each after its possible activators; otherwise in the order of the list.
fn activators_first(graph: &Graph) -> Vec<usize> {
    let count = graph.nodes.len();
    let mut order: Vec<usize> = Vec::new();
    while order.len() < count {
        let waits = |index: usize| {
            let activates = |&from: &usize| graph.nodes[from].links.iter().any(|link| link.to == index);
            (0..count).filter(activates).any(|from| !order.contains(&from))
        };
        let next = (0..count).find(|index| !order.contains(index) && !waits(*index));
        order.push(next.expect("no activation cycle"));
    }
    order
}
