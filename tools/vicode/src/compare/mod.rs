//! The difference of two versions of a file in components, states, transitions, children, conditions and parameters, matched by name.

mod change;
mod commit;
mod facts;
mod marks;
mod text;

use serde::Serialize;

pub use self::change::{Change, Detail, PartChange};
use self::change::{change_of, paired};
pub use self::commit::{Committed, committed};
use self::facts::{Fact, Part, component_parts, parameter_parts};
pub use self::marks::{Marks, union};
pub use self::text::report;
use crate::model::{Component, Model};

/// Differences of two versions of a file, by their models: comments, white space in code and the order of functions are
/// ignored.
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
    /// Its change.
    pub change: Change,
    /// Its parts with a difference.
    pub parts: Vec<PartChange>,
    /// Differences, grouped by drawn element.
    pub marks: Marks,
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
    /// Returns whether the versions are equal.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.components.is_empty() && self.parameters.is_empty()
    }

    /// Returns the numbers of added, removed and changed parts: `+ 1 state, - 2 transitions`; empty without differences.
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

/// Returns the parts that differ between two lists.
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
