//! The difference of two versions of a file in components, states, transitions, children, conditions and parameters, matched by name.

mod commit;
mod facts;
mod marks;
mod text;

use serde::Serialize;

pub use self::commit::{Committed, committed};
use self::facts::{Fact, component_parts, parameter_parts};
pub use self::marks::{Marks, union};
pub use self::text::report;
use crate::model::{Component, Model};

/// How a part of the second version differs from the first one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Change {
    /// Only the second version has it.
    Added,
    /// Only the first version has it.
    Removed,
    /// Both have it, with differences.
    Changed,
}

impl Change {
    /// The sign before its name: `+`, `-`, `~`.
    #[must_use]
    pub const fn sign(self) -> char {
        match self {
            Self::Added => '+',
            Self::Removed => '-',
            Self::Changed => '~',
        }
    }
}

/// The difference of two versions of a file. Empty if their models are equal; comments, white space in code and the order of functions
/// do not count.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Comparison {
    /// Components with a difference, in the order of the second version, removed ones at the end.
    pub components: Vec<ComponentChange>,
    /// Parameters with a difference, as `Struct.field`.
    pub parameters: Vec<PartChange>,
}

/// The difference of a component.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ComponentChange {
    /// Its key.
    pub key: String,
    /// How it differs.
    pub change: Change,
    /// Its parts with a difference.
    pub parts: Vec<PartChange>,
    /// The same by what is drawn.
    pub marks: Marks,
}

/// The difference of a part: a state, a transition, a parameter, …
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct PartChange {
    /// Kind of the part: `component`, `step`, `state`, `transition`, `hook`, `output`, `modulation`, `function`, `parameter`.
    pub part: &'static str,
    /// Its name.
    pub name: String,
    /// How it differs.
    pub change: Change,
    /// Its properties with a difference; of an added or removed part all.
    pub details: Vec<Detail>,
}

/// The difference of a property of a part.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Detail {
    /// The property: `condition`, `from`, `child Body`, …
    pub what: String,
    /// Value in the first version, if it has one.
    pub before: Option<String>,
    /// Value in the second version, if it has one.
    pub after: Option<String>,
}

/// A file's text with its model.
#[derive(Clone, Copy)]
pub struct Version<'a> {
    /// Text.
    pub text: &'a str,
    /// Model of the text.
    pub model: &'a Model,
}

/// Compares two versions of a file.
#[must_use]
pub fn compare(before: Version<'_>, after: Version<'_>) -> Comparison {
    let pairs = paired(&before.model.components, &after.model.components, |one| &one.key);
    let components = pairs.into_iter().filter_map(|(old, new)| {
        let parts =
            |component: Option<&Component>, text| component.map_or_else(Vec::new, |one| component_parts(one, text));
        let parts = differences(&parts(old, before.text), &parts(new, after.text));
        let change = change_of(old, new);
        let marks = Marks::of(old, new, &parts);
        (!parts.is_empty()).then(|| ComponentChange {
            key: new.or(old).map(|one| one.key.clone()).unwrap_or_default(),
            change,
            parts,
            marks,
        })
    });
    let parameters = differences(&parameter_parts(before.model), &parameter_parts(after.model));
    Comparison { components: components.collect(), parameters }
}

impl Comparison {
    /// Whether the versions are equal.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.components.is_empty() && self.parameters.is_empty()
    }

    /// Numbers of added, removed and changed states and transitions: `+ 1 state, - 2 transitions`; empty without any.
    #[must_use]
    pub fn summary(&self) -> String {
        let parts: Vec<&PartChange> =
            self.components.iter().flat_map(|one| &one.parts).chain(&self.parameters).collect();
        let mut words = Vec::new();
        for change in [Change::Added, Change::Removed, Change::Changed] {
            for kind in facts::KINDS {
                let number = parts.iter().filter(|part| part.part == kind && part.change == change).count();
                if number > 0 {
                    words.push(format!("{} {number} {kind}{}", change.sign(), if number == 1 { "" } else { "s" }));
                }
            }
        }
        words.join(", ")
    }
}

/// A part with all its properties.
struct Part {
    kind: &'static str,
    name: String,
    facts: Vec<Fact>,
}

/// The parts that are not equal in two lists.
fn differences(before: &[Part], after: &[Part]) -> Vec<PartChange> {
    let pairs = paired(before, after, |part| (part.kind, &part.name));
    let changes = pairs.into_iter().filter_map(|(old, new)| {
        let (old_facts, new_facts) = (old.map_or(&[][..], |part| &part.facts), new.map_or(&[][..], |part| &part.facts));
        let facts = paired(old_facts, new_facts, |fact| &fact.what);
        let is_different = |pair: &(Option<&Fact>, Option<&Fact>)| {
            pair.0.map(|fact| &fact.meaning) != pair.1.map(|fact| &fact.meaning)
        };
        let value = |fact: Option<&Fact>| fact.map(|fact| fact.value.clone());
        let details: Vec<Detail> = facts
            .into_iter()
            .filter(is_different)
            .filter_map(|(old, new)| {
                Some(Detail { what: old.or(new)?.what.clone(), before: value(old), after: value(new) })
            })
            .collect();
        let (part, change) = (new.or(old)?, change_of(old, new));
        (change != Change::Changed || !details.is_empty()).then(|| PartChange {
            part: part.kind,
            name: part.name.clone(),
            change,
            details,
        })
    });
    let mut changes: Vec<PartChange> = changes.collect();
    changes.sort_by_key(|change| facts::KINDS.iter().position(|kind| *kind == change.part));
    changes
}

const fn change_of<T>(old: Option<&T>, new: Option<&T>) -> Change {
    match (old, new) {
        (None, _) => Change::Added,
        (_, None) => Change::Removed,
        _ => Change::Changed,
    }
}

/// The elements of two lists with the same key, in the order of the second one; then those of the first one alone. Several elements of a
/// key, as functions under `cfg`, are matched in their order.
fn paired<'a, T, K: PartialEq>(before: &'a [T], after: &'a [T], key: impl Fn(&'a T) -> K) -> Vec<Pair<'a, T>> {
    let keyed = |list: &'a [T]| -> Vec<(K, usize)> {
        let number = |at: usize| list[..at].iter().filter(|other| key(other) == key(&list[at])).count();
        (0..list.len()).map(|at| (key(&list[at]), number(at))).collect()
    };
    let (old, new) = (keyed(before), keyed(after));
    let place = |list: &[(K, usize)], wanted: &(K, usize)| list.iter().position(|one| one == wanted);
    let common = after.iter().zip(&new).map(|(one, key)| (place(&old, key).map(|at| &before[at]), Some(one)));
    let gone = before.iter().zip(&old).filter(|(_, key)| place(&new, key).is_none());
    common.chain(gone.map(|(one, _)| (Some(one), None))).collect()
}

/// An element of the first list and one of the second, or only one of them.
type Pair<'a, T> = (Option<&'a T>, Option<&'a T>);
