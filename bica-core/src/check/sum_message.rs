//! The message for a sum that is too large: each share, and the states of the machines.

use super::weight::Weight;
use super::wording::{Message, push_given, words};
use super::worst_case::order;
use super::{CAPACITY, Choice, WorstCase};
use crate::graph::{Graph, Node};

/// Number of shares of the load that are listed, the largest ones.
const LARGEST: usize = 8;

/// Number of machines whose states are listed.
const SITUATION: usize = 8;

pub(super) const fn over_budget(text: &mut Message, graph: &Graph, chain: &WorstCase) {
    words(text, &["one cycle of tree `", graph.name, "` can take too long: "]);
    let weights = Weight::Time.of_all(graph);
    let order = order(graph.nodes);
    let mut shares = Shares { text, graph, scale: 1.0, unit: " µs", listed: 0 };
    let mut place = 0;
    while place < graph.nodes.len() {
        if chain.active.contains(order[place]) {
            shares.push(order[place], weights[order[place]]);
        }
        place += 1;
    }
    text.push(if chain.exact { " = " } else { " = at most " });
    text.push_number(chain.sum * 1e-3);
    text.push(" ms > budget_ms = ");
    push_given(text, graph.budget_ms);
    situation(text, graph, chain);
    text.push("; lower budgets, or let fewer components run in one cycle");
}

pub(super) const fn overload(text: &mut Message, graph: &Graph, load: &WorstCase) {
    words(text, &["tree `", graph.name, "` needs more than one processor: "]);
    let mut weights = Weight::Load.of_all(graph);
    let mut shares = Shares { text, graph, scale: 100.0, unit: " %", listed: 0 };
    while shares.listed < LARGEST
        && let Some(index) = largest(load, &weights)
    {
        shares.push(index, weights[index]);
        weights[index] = 0.0;
    }
    if largest(load, &weights).is_some() {
        text.push(" + …");
    }
    text.push(if load.exact { " = " } else { " = at most " });
    text.push_number(load.sum * 100.0);
    text.push(" % > 100 % (budget × hz)");
    situation(text, graph, load);
    text.push("; lower budgets or rates");
}

/// The active component with the largest weight above 0.
const fn largest(worst: &WorstCase, weights: &[f64; CAPACITY]) -> Option<usize> {
    let mut largest = None;
    let mut weight = 0.0;
    let mut index = 0;
    while index < CAPACITY {
        if worst.active.contains(index) && weights[index] > weight {
            weight = weights[index];
            largest = Some(index);
        }
        index += 1;
    }
    largest
}

/// Writes a sum share by share.
struct Shares<'a> {
    text: &'a mut Message,
    graph: &'a Graph,
    scale: f64,
    unit: &'static str,
    listed: usize,
}

impl Shares<'_> {
    /// Adds the share of a component, unless it is zero.
    const fn push(&mut self, index: usize, weight: f64) {
        if weight > 0.0 {
            words(self.text, &[if self.listed == 0 { "" } else { " + " }, self.graph.nodes[index].name, " "]);
            self.text.push_number(weight * self.scale);
            self.text.push(self.unit);
            self.listed += 1;
        }
    }
}

/// Adds the states of the worst case, for the first machines.
pub(super) const fn situation(text: &mut Message, graph: &Graph, worst: &WorstCase) {
    let mut named = 0;
    let mut index = 0;
    while index < graph.nodes.len() && named <= SITUATION {
        if !matches!(worst.choices[index], Choice::None) {
            text.push(if named == 0 { ", while " } else { ", " });
            if named == SITUATION {
                text.push("…");
            } else {
                doing(text, &graph.nodes[index], worst.choices[index]);
            }
            named += 1;
        }
        index += 1;
    }
}

/// Adds what a machine does.
const fn doing(text: &mut Message, node: &Node, choice: Choice) {
    words(text, &["`", node.name, "`"]);
    match choice {
        Choice::None => {}
        Choice::State(state) => words(text, &[" is in `", node.states[state].name, "`"]),
        Choice::Transition(transition) => {
            let transition = &node.transitions[transition];
            words(
                text,
                &[" goes from `", node.states[transition.from].name, "` to `", node.states[transition.to].name, "`"],
            );
        }
        Choice::Any => text.push(" is in any state"),
    }
}
