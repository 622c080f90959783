//! Coverage of a machine: number and duration of the visits of its states and transitions.

mod table;

use std::collections::{BTreeMap, BTreeSet};

use bica_syntax::component::model::Edge;
use serde::Serialize;

use crate::model::{Component, Function};

/// Visits of a machine's states in one or several runs.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Visits {
    states: BTreeMap<String, Stays>,
    /// Number of changes between two states.
    ways: BTreeMap<(String, String), u64>,
    /// Time, µs, and state of the last sample; no state while the component is latent.
    last: Option<(u64, Option<String>)>,
    runs: usize,
}

/// Stays in a state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Stays {
    /// Number of entries.
    pub visits: u64,
    /// Total time in it, µs.
    pub us: u64,
    /// Longest stay without interruption, µs.
    pub longest_us: u64,
    /// Length of the current stay, µs.
    #[serde(skip)]
    current_us: u64,
}

impl Visits {
    /// Begins a new run or, after missing samples, a new sequence: the current stay ends.
    pub fn begin(&mut self) {
        (self.last, self.runs) = (None, self.runs + 1);
    }

    /// Adds a sample: the state from `time_us` µs until the next sample; `None` while the component is latent. Samples of all cycles and
    /// samples of changes only give the same result if the last cycle has a sample.
    pub fn sample(&mut self, time_us: u64, state: Option<&str>) {
        let before = self.last.replace((time_us, state.map(str::to_owned)));
        let (since, left) = before.map_or((time_us, None), |(since, left)| (since, left));
        if let Some(left) = &left {
            let stays = self.states.entry(left.clone()).or_default();
            let us = time_us.saturating_sub(since);
            (stays.us, stays.current_us) = (stays.us + us, stays.current_us + us);
            stays.longest_us = stays.longest_us.max(stays.current_us);
        }
        if left.as_deref() == state {
            return;
        }
        if let Some(entered) = state {
            let stays = self.states.entry(entered.to_owned()).or_default();
            (stays.visits, stays.current_us) = (stays.visits + 1, 0);
            if let Some(left) = left {
                *self.ways.entry((left, entered.to_owned())).or_default() += 1;
            }
        }
    }
}

/// The coverage of a machine.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Coverage {
    /// Key of the component.
    pub component: String,
    /// Number of runs.
    pub runs: usize,
    /// Time in which it was active, µs.
    pub us: u64,
    /// Its states, in the order of the source.
    pub states: Vec<StateCoverage>,
    /// Its transitions, in the order in which they are tried, one entry for each state that they leave.
    pub transitions: Vec<TransitionCoverage>,
    /// States of the runs that are not in the source.
    pub unknown: Vec<String>,
}

/// The coverage of a state.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct StateCoverage {
    /// Name.
    pub name: String,
    /// Stays in it.
    #[serde(flatten)]
    pub stays: Stays,
}

/// The coverage of a transition from one state.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct TransitionCoverage {
    /// Name.
    pub name: String,
    /// State that it leaves.
    pub from: String,
    /// State that it enters.
    pub to: String,
    /// Whether its attribute names all states by `*`.
    pub any: bool,
    /// Number of changes from the one state to the other; `None` for a transition from a state to itself, which samples of states
    /// do not show.
    pub taken: Option<u64>,
    /// Other transitions between the same states; samples of states do not distinguish them.
    pub or: Vec<String>,
}

impl Coverage {
    /// Evaluates the visits of a machine.
    #[must_use]
    pub fn of(component: &Component, visits: &Visits) -> Self {
        let names: Vec<&str> = component.states.iter().map(|state| &*state.function.name.text).collect();
        let stays = |name: &&str| visits.states.get(*name).copied().unwrap_or_default();
        let states = names.iter().map(|name| StateCoverage { name: (*name).to_owned(), stays: stays(name) });
        let edges = component.machine().edges;
        let condition = |edge: &Edge<&Function>| edge.name();
        let transitions = edges.iter().map(|edge| {
            let [from, to] = [edge.from, edge.to].map(|state| names[state].to_owned());
            let same =
                edges.iter().filter(|one| (one.from, one.to) == (edge.from, edge.to) && one.name() != edge.name());
            let or = same.map(condition).collect();
            let count = |from: &str| visits.ways.get(&(from.to_owned(), to.clone())).copied().unwrap_or_default();
            let taken = (from != to).then(|| count(&from));
            TransitionCoverage { name: condition(edge), from, to, any: edge.any, taken, or }
        });
        Self {
            component: component.key.clone(),
            runs: visits.runs,
            us: visits.states.values().map(|stays| stays.us).sum(),
            states: states.collect(),
            transitions: transitions.collect(),
            unknown: visits.states.keys().filter(|name| !names.contains(&name.as_str())).cloned().collect(),
        }
    }

    /// Returns the number of visited states.
    #[must_use]
    pub fn visited(&self) -> usize {
        self.states.iter().filter(|state| state.stays.visits > 0).count()
    }

    /// Returns the number of conditions that led to another state, and the number of all that can. Of several conditions between the same
    /// states each one counts as taken.
    #[must_use]
    pub fn taken(&self) -> (usize, usize) {
        let names = |is_counted: &dyn Fn(&&TransitionCoverage) -> bool| {
            self.transitions.iter().filter(is_counted).map(|one| &one.name).collect::<BTreeSet<_>>().len()
        };
        (names(&|one| one.taken > Some(0)), names(&|one| one.taken.is_some()))
    }
}
