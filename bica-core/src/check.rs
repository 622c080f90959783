//! What must hold for a tree as a whole: no activation cycle, nothing unreachable, rates and budgets that can be kept.
//!
//! [`check`] is what `activation_tree!` calls in a constant: a tree that breaks a rule does not compile, and the panic's
//! message is the compiler's. Everything here is ordinary code as well, for tools that have a [`Graph`] in hand:
//! [`first`] gives the violation as data and [`message`] the words.
//!
//! The indices of a graph (`root`, `to`, `from`, `state`) must lie inside their slices, as the macros write them; every
//! function here panics on one that does not.

mod message;
mod order;
mod path;
mod reach;
mod set;
mod sum_message;
mod text;
mod violation;
mod weight;
mod worst_case;

pub use message::message;
pub use order::{activators, cycle, ranks};
pub use path::Path;
pub use reach::{reachable, states_reached, unreachable};
pub use set::Set;
pub use text::Text;
pub use violation::{Number, Violation, first_violation};
pub use worst_case::{Choice, WorstCase, load, longest_chain, steps};

use crate::graph::Graph;

/// The most components that one tree, and the most states that one machine can be checked for.
pub const CAPACITY: usize = 256;

/// Stops the compiler, with the whole reason in words, if a rule is broken. The compiler points at the caller.
///
/// # Panics
/// With [`message`] of the [`first`] violation.
#[track_caller]
pub const fn check(graph: &Graph) {
    if let Some(violation) = first_violation(graph) {
        panic!("{}", message(graph, &violation).as_str());
    }
}
