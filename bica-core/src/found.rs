//! What a transition found.

/// The value that a transition returned, for the state that it enters: an argument of an `#[entry]` hook.
///
/// A transition that returns `Option<T>` is taken if it returns a value. The entry hook of its state takes the value as `Found<T>`; one
/// of an initial state, in which the machine also starts, as `Option<Found<T>>`. The value exists from the transition to the hook, in one
/// run: the tree stores it nowhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Found<T>(pub T);
