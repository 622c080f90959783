//! Differences of parts, and the pairing of two lists.

use serde::Serialize;

/// Change of a part from the first to the second version.
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
    /// Returns the sign before the part's name: `+`, `-`, `~`.
    #[must_use]
    pub const fn sign(self) -> char {
        match self {
            Self::Added => '+',
            Self::Removed => '-',
            Self::Changed => '~',
        }
    }
}

/// The difference of a part: a state, a transition, a parameter, …
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct PartChange {
    /// Kind of the part: `component`, `step`, `state`, `transition`, `hook`, `output`, `modulation`, `function`, `parameter`.
    pub part: &'static str,
    /// Its name.
    pub name: String,
    /// Its change.
    pub change: Change,
    /// Properties that differ; all properties of an added or removed part.
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

pub(super) const fn change_of<T>(old: Option<&T>, new: Option<&T>) -> Change {
    match (old, new) {
        (None, _) => Change::Added,
        (_, None) => Change::Removed,
        _ => Change::Changed,
    }
}

/// Pairs the elements of two lists by key, in the order of the second list; elements of the first list alone follow. Elements with
/// equal keys, such as functions under `cfg`, are paired in their order.
pub(super) fn paired<'a, T, K: PartialEq>(
    before: &'a [T],
    after: &'a [T],
    key: impl Fn(&'a T) -> K,
) -> Vec<Pair<'a, T>> {
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
pub(super) type Pair<'a, T> = (Option<&'a T>, Option<&'a T>);
