//! The rules in the order in which they are checked.

use super::frames::{frame_cycle, two_places};
use super::weight::hz;
use super::writers::unordered;
use super::{CAPACITY, OutputIndex, Path, WorstCase, cycle, load, longest_chain, steps, unreachable};
use crate::graph::{Graph, Node};

/// A broken rule.
#[derive(Clone, Copy, Debug)]
pub enum Violation {
    /// More components than [`CAPACITY`]; how many.
    TooManyComponents(usize),
    /// A component, by index, with more states than [`CAPACITY`].
    TooManyStates(usize),
    /// A rate or a budget that is not a valid number.
    BadNumber(Number),
    /// Components that activate each other in a cycle; see [`cycle`].
    Cycle(Path),
    /// Components that nothing can ever activate; see [`unreachable()`].
    Unreachable(Path),
    /// A component, by index, that declares a higher rate than the tree.
    TooFast(usize),
    /// The components that can run in one cycle take longer than the tree's budget; see [`longest_chain`].
    OverBudget(WorstCase),
    /// The active components need more than a whole processor; see [`load`].
    Overload(WorstCase),
    /// A component, by index, that several can write in one cycle, and that does not say which of them counts; see
    /// [`writers()`](super::writers()).
    Unordered(usize),
    /// Two outputs that are the place of one frame.
    TwoPlaces(OutputIndex, OutputIndex),
    /// An output that places a frame in itself, directly or by other frames.
    FrameCycle(OutputIndex),
}

/// A number of the declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// [`Graph::cycle_hz`].
    CycleHz,
    /// [`Graph::budget_ms`].
    BudgetMs,
    /// [`Node::hz`] of a component by index.
    Hz(usize),
    /// [`Node::budget_us`] of a component by index.
    BudgetUs(usize),
}

/// Returns the first broken rule of a tree; `None` if it breaks none.
#[must_use]
pub const fn first_violation(graph: &Graph) -> Option<Violation> {
    if graph.nodes.len() > CAPACITY {
        return Some(Violation::TooManyComponents(graph.nodes.len()));
    }
    if let Some(index) = too_many_states(graph.nodes) {
        return Some(Violation::TooManyStates(index));
    }
    if let Some(figure) = bad_number(graph) {
        return Some(Violation::BadNumber(figure));
    }
    if let Some(path) = cycle(graph.nodes) {
        return Some(Violation::Cycle(path));
    }
    let unreachable = unreachable(graph);
    if !unreachable.is_empty() {
        return Some(Violation::Unreachable(unreachable));
    }
    if let Some(index) = too_fast(graph) {
        return Some(Violation::TooFast(index));
    }
    if let Some(child) = unordered(graph) {
        return Some(Violation::Unordered(child));
    }
    if let Some((first, second)) = two_places(graph) {
        return Some(Violation::TwoPlaces(first, second));
    }
    if let Some(output) = frame_cycle(graph) {
        return Some(Violation::FrameCycle(output));
    }
    sums(graph)
}

const fn too_many_states(nodes: &[Node]) -> Option<usize> {
    let mut index = 0;
    while index < nodes.len() {
        if nodes[index].states.len() > CAPACITY {
            return Some(index);
        }
        index += 1;
    }
    None
}

const fn bad_number(graph: &Graph) -> Option<Number> {
    if !is_rate(Some(graph.cycle_hz)) {
        return Some(Number::CycleHz);
    }
    if !is_rate(graph.budget_ms) {
        return Some(Number::BudgetMs);
    }
    let mut index = 0;
    while index < graph.nodes.len() {
        if !is_rate(graph.nodes[index].hz) {
            return Some(Number::Hz(index));
        }
        if !is_time(graph.nodes[index].budget_us) {
            return Some(Number::BudgetUs(index));
        }
        index += 1;
    }
    None
}

/// Finite and above 0, or not given.
const fn is_rate(figure: Option<f32>) -> bool {
    match figure {
        Some(figure) => figure > 0.0 && figure.is_finite(),
        None => true,
    }
}

/// Finite and not below 0, or not given.
const fn is_time(figure: Option<f32>) -> bool {
    match figure {
        Some(figure) => figure >= 0.0 && figure.is_finite(),
        None => true,
    }
}

const fn too_fast(graph: &Graph) -> Option<usize> {
    let mut index = 0;
    while index < graph.nodes.len() {
        if hz(graph, &graph.nodes[index]) > graph.cycle_hz as f64 {
            return Some(index);
        }
        index += 1;
    }
    None
}

const fn sums(graph: &Graph) -> Option<Violation> {
    if let Some(budget_ms) = graph.budget_ms {
        let chain = longest_chain(graph, steps(graph));
        // The budget is a decimal number rounded to 24 bits: a chain of exactly that number is within it.
        if chain.sum > budget_ms as f64 * 1e3 * (1.0 + f32::EPSILON as f64) {
            return Some(Violation::OverBudget(chain));
        }
    }
    let load = load(graph, steps(graph));
    if load.sum > 1.0 {
        return Some(Violation::Overload(load));
    }
    None
}
