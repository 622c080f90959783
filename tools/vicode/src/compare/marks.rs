//! Drawing of both versions of a machine.

use std::collections::BTreeMap;

use serde::Serialize;

use super::change::{Change, PartChange, change_of, paired};
use crate::model::{Arrow, Component, Function, Sources, State, Transition};

/// Differences of a machine, grouped by drawn element; unchanged elements are omitted.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Marks {
    /// States.
    pub states: BTreeMap<String, Change>,
    /// Arrows.
    pub arrows: Vec<ArrowMark>,
}

/// The difference of an arrow.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ArrowMark {
    /// Name of the transition.
    pub name: String,
    /// State that it leaves; `*` for all.
    pub from: String,
    /// State that it enters.
    pub to: String,
    /// Its change.
    pub change: Change,
}

impl Marks {
    pub(super) fn of(old: Option<&Component>, new: Option<&Component>, parts: &[PartChange]) -> Self {
        let of_kind = |kind| parts.iter().filter(move |part| part.part == kind);
        let mut states: BTreeMap<String, Change> =
            of_kind("state").map(|part| (part.name.clone(), part.change)).collect();
        let has_changed = |name: &str| of_kind("hook").any(|part| part.name == name);
        let hooks = old.iter().chain(&new).flat_map(|component| &component.hooks);
        for state in hooks.filter(|hook| has_changed(&hook.function.name.text)).flat_map(|hook| &hook.states) {
            states.entry(state.text.clone()).or_insert(Change::Changed);
        }
        let (before, after) = (old.map_or_else(Vec::new, arrows), new.map_or_else(Vec::new, arrows));
        // Changed sources, targets and timers belong to single arrows, all other changes to the whole transition.
        let is_whole = |part: &PartChange| {
            let of_one = ["from", "to", "timer", "when", "times"];
            part.details.iter().any(|one| of_one.iter().all(|word| !one.what.starts_with(word)))
        };
        let pairs = paired(&before, &after, |arrow| (arrow.name, arrow.from, arrow.to));
        let marks = pairs.into_iter().filter_map(|(old, new)| {
            let (arrow, change) = (new.or(old)?, change_of(old, new));
            let is_different = change != Change::Changed
                || old.map(|one| &one.waits) != new.map(|one| &one.waits)
                || of_kind("transition").any(|part| part.name == arrow.name && is_whole(part));
            let [name, from, to] = [arrow.name, arrow.from, arrow.to].map(str::to_owned);
            is_different.then_some(ArrowMark { name, from, to, change })
        });
        let arrows = marks.collect();
        Self { states, arrows }
    }

    /// Returns the change of an arrow; `None` if it is equal.
    #[must_use]
    pub fn arrow(&self, name: &str, from: &str, to: &str) -> Option<Change> {
        self.arrows.iter().find(|one| one.name == name && one.from == from && one.to == to).map(|one| one.change)
    }
}

/// An arrow with one source.
struct Ends<'a> {
    name: &'a str,
    from: &'a str,
    to: &'a str,
    waits: String,
}

fn arrows(component: &Component) -> Vec<Ends<'_>> {
    let name = |(function, bare, arrow)| (named(function, bare, arrow), arrow);
    component
        .arrows()
        .map(name)
        .flat_map(|(name, arrow)| sources(arrow).into_iter().map(move |from| ends(name, from, arrow)))
        .collect()
}

/// The name with which an arrow is drawn.
fn named<'a>(function: &'a Function, bare: bool, arrow: &'a Arrow) -> &'a str {
    if bare { arrow.bare_name() } else { &function.name.text }
}

fn ends<'a>(name: &'a str, from: &'a str, arrow: &'a Arrow) -> Ends<'a> {
    Ends { name, from, to: &arrow.to.text, waits: arrow.waits() }
}

fn sources(arrow: &Arrow) -> Vec<&str> {
    match &arrow.from {
        Sources::Any => vec!["*"],
        Sources::These(names) => names.iter().map(|name| &*name.text).collect(),
    }
}

/// Merges two versions of a machine: the second one, with the states and arrows that only the first one has. Spans refer to the
/// version that a part comes from.
#[must_use]
pub fn union(before: &Component, after: &Component) -> Component {
    let mut both = after.clone();
    let is_new = |state: &&State| after.state(&state.function.name.text).is_none();
    both.states.extend(before.states.iter().filter(is_new).cloned().map(|state| State { initial: false, ..state }));
    let known = arrows(after);
    let is_known =
        |name: &str, from: &str, to: &str| known.iter().any(|one| one.name == name && one.from == from && one.to == to);
    for old in &before.states {
        let is_gone = |arrow: &&Arrow| !is_known(arrow.bare_name(), &old.function.name.text, &arrow.to.text);
        if let Some(one) = both.states.iter_mut().find(|one| one.function.name.text == old.function.name.text)
            && after.state(&old.function.name.text).is_some()
        {
            one.arrows.extend(old.arrows.iter().filter(is_gone).cloned());
        }
    }
    for old in &before.transitions {
        let name = &old.function.name.text;
        let gone = old
            .arrows
            .iter()
            .filter_map(|arrow| without(arrow, |from| is_known(name, from, &arrow.to.text)))
            .collect::<Vec<_>>();
        match both.transitions.iter_mut().find(|one| one.function.name.text == *name) {
            Some(one) => one.arrows.extend(gone),
            None => both.transitions.push(Transition { function: old.function.clone(), arrows: gone }),
        }
    }
    both
}

/// Removes sources of an arrow; `None` if no source remains.
fn without(arrow: &Arrow, is_out: impl Fn(&str) -> bool) -> Option<Arrow> {
    match &arrow.from {
        Sources::Any => (!is_out("*")).then(|| arrow.clone()),
        Sources::These(names) => {
            let names: Vec<_> = names.iter().filter(|name| !is_out(&name.text)).cloned().collect();
            (!names.is_empty()).then(|| Arrow { from: Sources::These(names), ..arrow.clone() })
        }
    }
}
