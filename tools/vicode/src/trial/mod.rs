//! Trial of a machine without its program: conditions are switches, timers run.
//!
//! A trial is a list of [`Step`]s; [`Trial::run`] evaluates it from the beginning, by the code that runs trees
//! ([`bica_core::LoneMachine`]), for one component that is active from the first cycle on. Code of states, hooks and children does not run.

mod place;
mod skeleton;

use std::collections::BTreeMap;

use bica_core::rate::instant_of_cycle;
use bica_core::{Instant, LoneMachine, Value, graph};
use bica_syntax::component::model::{self as syntax, Edge, Timer};
use bica_syntax::number::hertz;
use bica_syntax::text;
use serde::{Deserialize, Serialize};

pub use self::place::{Place, Tree};
use crate::model::{Component, Function, ParameterGroup};
use crate::read::{lexed, read};

/// Longest trial, µs.
const LONGEST: u64 = 3_600_000_000;
/// Largest number of transitions of a trial.
const MOST_TRANSITIONS: usize = 10_000;
/// Largest number of steps of a trial.
const MOST_STEPS: usize = 5_000;

/// A step of a trial.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Step {
    /// Switches a condition. Conditions are off at first, except those whose code is `true`.
    Switch {
        /// Name of the transition.
        condition: String,
        /// Whether it holds from now on.
        on: bool,
    },
    /// Lets time pass, ms.
    Run(u32),
}

/// The result of a trial.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Trial {
    /// Time since the machine became active, µs.
    pub now_us: u64,
    /// Mean time between two runs, µs.
    pub period_us: u64,
    /// Time of the next run, µs.
    pub next_run_us: u64,
    /// Stays in states in the order of time, the current one at the end. The first one begins with the first run.
    pub visits: Vec<Visit>,
    /// Ways out of the current state, in the order in which they are tried.
    pub ways: Vec<Way>,
    /// Whether each condition holds.
    pub switches: BTreeMap<String, bool>,
    #[serde(skip)]
    cycle_hz: f32,
}

/// A stay in a state.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Visit {
    /// State.
    pub state: String,
    /// Time at which it was entered, µs.
    pub from_us: u64,
    /// Total time in it, µs.
    pub us: u64,
    /// Transition by which it was entered; `None` for the first one.
    pub by: Option<String>,
    /// Index of the step in which it was entered.
    pub step: usize,
}

/// A way out of a state.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Way {
    /// Name of the transition.
    pub condition: String,
    /// State that it enters.
    pub to: String,
    /// Whether the condition holds.
    pub on: bool,
    /// Time until its timer allows it, µs; 0 without a timer.
    pub remaining_us: u64,
    /// How often it can still be taken in a row; `None` if it does not count.
    pub left: Option<u8>,
}

impl Trial {
    /// Evaluates a trial of a machine in a tree with `cycle_hz` cycles per second; `text` is the machine's file.
    ///
    /// # Errors
    /// If the machine has no states, a step names no transition of it, or the trial is too long.
    pub fn run(component: &Component, text: &str, cycle_hz: f64, steps: &[Step]) -> Result<Self, String> {
        let mut machine = Machine::new(component, text, cycle_hz)?;
        if steps.len() > MOST_STEPS {
            return Err(format!("a trial has at most {MOST_STEPS} steps: start over"));
        }
        for (number, step) in steps.iter().enumerate() {
            match step {
                Step::Switch { condition, on } => {
                    let known = machine.switches.get_mut(condition);
                    *known.ok_or_else(|| {
                        format!("no transition is called `{condition}`: it may have been renamed; start over")
                    })? = *on;
                }
                Step::Run(ms) => machine.advance(u64::from(*ms) * 1000, number)?,
            }
        }
        Ok(machine.trial())
    }
}

/// State of a trial.
struct Machine<'a> {
    names: Vec<String>,
    edges: Vec<Edge<&'a Function>>,
    /// The edges in the form that `lone` takes.
    transitions: Vec<graph::Transition>,
    lone: LoneMachine,
    cycle_hz: f32,
    hz: f32,
    /// Number of the next cycle.
    cycle: u64,
    now: u64,
    switches: BTreeMap<String, bool>,
    visits: Vec<Visit>,
}

impl<'a> Machine<'a> {
    fn new(component: &'a Component, text: &str, cycle_hz: f64) -> Result<Self, String> {
        let names: Vec<String> = component.states.iter().map(|state| state.function.name.text.clone()).collect();
        let syntax::Machine { initial, edges, .. } = component.machine();
        let first =
            names.get(initial).ok_or_else(|| format!("`{}` has no states: there is nothing to try", component.key))?;
        let cycle_hz = cycle_hz as f32;
        let own = component.options.get("hz").and_then(|one| hertz(&one.value.as_ref()?.text));
        // The compiler refuses a component that is faster than its tree.
        let own = own.filter(|hz| *hz <= cycle_hz);
        let visits = vec![Visit { state: first.clone(), from_us: 0, us: 0, by: None, step: 0 }];
        let is_always = |function: &Function| function.body.is_some_and(|body| on_one_line(body.of(text)) == "true");
        let conditions = component.transitions.iter().map(|one| &one.function);
        // A timer on a state needs no switch.
        let results = edges.iter().filter(|edge| edge.guard.bare && edge.guard.when.is_some());
        let switches = conditions.map(|one| (one.name.text.clone(), is_always(one)));
        let switches = switches.chain(results.map(|edge| (edge.name(), false))).collect();
        let parameters = if edges.iter().any(|edge| matches!(edge.guard.timer, Some(Timer::Parameter(_)))) {
            read(text).parameters
        } else {
            Vec::new()
        };
        let transition = |edge: &Edge<&Function>| graph::Transition {
            after_ms: edge.guard.timer.as_ref().map(|timer| match timer {
                Timer::Ms(ms) => *ms,
                Timer::Parameter(timer) => default_ms(&parameters, timer),
            }),
            times: edge.guard.times,
            ..graph::Transition::new("", edge.from, edge.to)
        };
        Ok(Self {
            transitions: edges.iter().map(transition).collect(),
            lone: LoneMachine::new(cycle_hz, own, initial),
            hz: own.unwrap_or(cycle_hz),
            cycle: 0,
            now: 0,
            names,
            edges,
            cycle_hz,
            switches,
            visits,
        })
    }

    /// Returns the instant of the next cycle.
    fn next(&self) -> Instant {
        instant_of_cycle(self.cycle_hz, self.cycle)
    }

    /// Advances the time by `us` µs, and runs the cycles in it.
    fn advance(&mut self, us: u64, step: usize) -> Result<(), String> {
        let end = self.now + us;
        if end > LONGEST {
            return Err("a trial lasts at most an hour: start over".to_owned());
        }
        while self.next().as_micros() < end {
            self.run_cycle(step);
            if self.visits.len() > MOST_TRANSITIONS {
                return Err(format!(
                    "a trial has at most {MOST_TRANSITIONS} transitions: switch a condition off, or start over"
                ));
            }
        }
        self.now = end;
        Ok(())
    }

    fn run_cycle(&mut self, step: usize) {
        let at = self.next();
        self.cycle += 1;
        let holds = |index: usize| is_on(&self.switches, &self.edges[index]);
        let Some(taken) = self.lone.tick(at, &self.transitions, holds).flatten() else { return };
        let from_us = at.as_micros();
        if let Some(last) = self.visits.last_mut() {
            last.us = from_us - last.from_us;
        }
        let (state, by) = (self.names[self.lone.state()].clone(), Some(self.edges[taken].name()));
        self.visits.push(Visit { state, from_us, us: 0, by, step });
    }

    fn trial(mut self) -> Trial {
        let state = self.lone.state();
        let stayed = self.lone.in_state(Instant::from_micros(self.now)).as_micros();
        if let Some(last) = self.visits.last_mut() {
            last.us = self.now - last.from_us;
        }
        let taken = self.lone.taken();
        let of_state = self.edges.iter().zip(&self.transitions).filter(|(edge, _)| edge.from == state);
        let ways = of_state.map(|(edge, transition)| Way {
            condition: edge.name(),
            to: self.names[edge.to].clone(),
            on: is_on(&self.switches, edge),
            remaining_us: transition.after_ms.map_or(0, |ms| (u64::from(ms) * 1000).saturating_sub(stayed)),
            left: transition.times.map(|times| times.saturating_sub(taken)),
        });
        let ways = ways.collect();
        while self.next().as_micros() < LONGEST && self.lone.tick(self.next(), &[], |_| false).is_none() {
            self.cycle += 1;
        }
        Trial {
            now_us: self.now,
            period_us: (1e6 / f64::from(self.hz)).round() as u64,
            next_run_us: self.next().as_micros(),
            visits: self.visits,
            ways,
            switches: self.switches,
            cycle_hz: self.cycle_hz,
        }
    }
}

/// Whether the condition of a transition holds. A timer on a state has none.
fn is_on(switches: &BTreeMap<String, bool>, edge: &Edge<&Function>) -> bool {
    let is_timer = edge.guard.bare && edge.guard.when.is_none();
    is_timer || switches.get(&edge.name()) == Some(&true)
}

/// Default of a timer that is a parameter of this file, ms; 0 if another file has it.
fn default_ms(groups: &[ParameterGroup], timer: &syntax::Parameter) -> u32 {
    let of = text::written(&timer.of.0);
    let group = groups.iter().find(|group| of.rsplit("::").next() == Some(&group.name.text));
    let field = text::name(&timer.field);
    let parameter = group.and_then(|group| group.parameters.iter().find(|one| one.name.text == field));
    let value = parameter.and_then(|one| Some((&one.ty.text, one.value("default")?.text.parse::<f32>().ok()?)));
    let value = value.map(|(ty, default)| if ty == "f32" { Value::F32(default) } else { Value::U32(default as u32) });
    value.and_then(Value::milliseconds).unwrap_or_default()
}

/// Formats a body on one line, without comments.
fn on_one_line(code: &str) -> String {
    let tokens = lexed(code);
    let words: Vec<&str> = tokens
        .iter()
        .filter(|token| !token.is_trivia() || token.text.trim().is_empty())
        .map(|token| token.text)
        .collect();
    words.concat().split_whitespace().collect::<Vec<_>>().join(" ")
}
