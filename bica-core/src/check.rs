//! Rules for a tree as a whole: no activation cycle, no unreachable component, feasible rates and budgets, one
//! place for a frame.
//!
//! `activation_tree!` calls [`check`] in a constant: a tree that breaks a rule does not compile, and the compiler reports
//! the panic's message. Everything here is ordinary code as well, for tools that have a [`Graph`]:
//! [`first_violation`] returns the violation as data and [`message`] its text.
//!
//! The indices of a graph (`root`, `to`, `from`, `state`) must lie inside their slices, as the macros write them; every
//! function here panics on one that does not.

mod frames;
mod message;
mod order;
mod path;
mod reach;
mod set;
mod sum_message;
mod violation;
mod weight;
mod wording;
mod worst_case;
mod writers;

pub use frames::OutputIndex;
pub use message::message;
pub use order::{activators, cycle, ranks};
#[doc(hidden)]
pub use path::Path;
pub use reach::{reachable, states_reached, unreachable};
#[doc(hidden)]
pub use set::Set;
pub use violation::{Number, Violation, first_violation};
pub use worst_case::{Choice, WorstCase, load, longest_chain, most_writers, steps};
pub use writers::{Writers, writers};

use crate::graph::Graph;
#[doc(hidden)]
pub use crate::text::Text;

/// Largest number of components of a tree, and of states of a state machine: recordings and links number both in one byte,
/// in which 255 stands for none.
pub const CAPACITY: usize = 255;

/// Stops the compiler with a message if a rule is broken. The compiler points at the caller.
///
/// # Panics
/// With [`message`] of the [`first_violation`] violation.
#[track_caller]
pub const fn check(graph: &Graph) {
    if let Some(violation) = first_violation(graph) {
        panic!("{}", message(graph, &violation).as_str());
    }
}
