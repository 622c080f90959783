//! What must hold for a tree as a whole: no activation cycle, nothing unreachable, rates and budgets that can be kept.
//!
//! [`check`] is what `activation_tree!` calls in a constant: a tree that breaks a rule does not compile, and the panic's
//! message is the compiler's. Everything here is ordinary code as well, for tools that have a [`Graph`] in hand:
//! [`first`] gives the finding as data and [`message`] the words.
//!
//! The indices of a graph (`root`, `to`, `from`, `state`) must lie inside their slices, as the macros write them; every
//! function here panics on one that does not.

mod finding;
mod message;
mod order;
mod path;
mod reach;
mod set;
mod sums;
mod text;
mod weight;
mod worst;

pub use finding::{Figure, Finding, first};
pub use message::message;
pub use order::{activators, cycle, ranks};
pub use path::Path;
pub use reach::{reachable, states_reached, unreachable};
pub use set::Set;
pub use text::Text;
pub use worst::{Choice, Worst, load, longest_chain, steps};

use crate::graph::Graph;

/// The most components that one tree, and the most states that one machine can be checked for.
pub const CAPACITY: usize = 256;

/// Stops the compiler, with the whole reason in words, if a rule is broken. The compiler points at the caller.
///
/// # Panics
/// With [`message`] of the [`first`] finding.
#[track_caller]
pub const fn check(graph: &Graph) {
    if let Some(finding) = first(graph) {
        panic!("{}", message(graph, &finding).as_str());
    }
}
