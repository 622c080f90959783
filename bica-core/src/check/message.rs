//! The message for each violation: what was found, what is required, the remedy.

use super::frames::parent;
use super::sum_message::{over_budget, overload, situation};
use super::wording::{Message, push_given, words};
use super::worst_case::leading_to;
use super::writers::meeting;
use super::{CAPACITY, Choice, Number, OutputIndex, Path, Violation, WorstCase, Writers};
use crate::graph::{Graph, Node};

/// Returns the message for a violation, in one line.
#[must_use]
pub const fn message(graph: &Graph, violation: &Violation) -> Message {
    let mut text = Message::new();
    match violation {
        Violation::TooManyComponents(count) => too_many(&mut text, graph, *count),
        Violation::TooManyStates(index) => too_many_states(&mut text, &graph.nodes[*index]),
        Violation::BadNumber(figure) => bad_number(&mut text, graph, *figure),
        Violation::Cycle(path) => cycle(&mut text, graph, path),
        Violation::Unreachable(path) => unreachable(&mut text, graph, path),
        Violation::TooFast(index) => too_fast(&mut text, graph, *index),
        Violation::OverBudget(chain) => over_budget(&mut text, graph, chain),
        Violation::Overload(load) => overload(&mut text, graph, load),
        Violation::Unordered(child) => {
            if let Some(writers) = meeting(graph, *child) {
                unordered(&mut text, graph, *child, &writers);
            }
        }
        Violation::TwoPlaces(first, second) => two_places(&mut text, graph, *first, *second),
        Violation::FrameCycle(output) => frame_cycle(&mut text, graph, *output),
    }
    text
}

const fn too_many(text: &mut Message, graph: &Graph, count: usize) {
    words(text, &["tree `", graph.name, "` lists "]);
    text.push_whole(count as u64);
    text.push(" components, and a tree can be checked for ");
    text.push_whole(CAPACITY as u64);
    text.push(" at most; merge some");
}

const fn too_many_states(text: &mut Message, node: &Node) {
    words(text, &["component `", node.name, "` has "]);
    text.push_whole(node.states.len() as u64);
    text.push(" states, and a machine can be checked for ");
    text.push_whole(CAPACITY as u64);
    text.push(" at most; make a component of some");
}

const fn bad_number(text: &mut Message, graph: &Graph, figure: Number) {
    match figure {
        Number::CycleHz => {
            words(text, &["tree `", graph.name, "` has cycle_hz = "]);
            text.push_number(graph.cycle_hz as f64);
            text.push(": a rate is a finite number above 0; write how often per second the tree is ticked");
        }
        Number::BudgetMs => {
            words(text, &["tree `", graph.name, "` has budget_ms = "]);
            push_given(text, graph.budget_ms);
            text.push(": a cycle's budget is a finite number above 0; give it, or leave it out for no limit");
        }
        Number::Hz(index) => {
            words(text, &["component `", graph.nodes[index].name, "` has hz = "]);
            push_given(text, graph.nodes[index].hz);
            text.push(": a rate is a finite number above 0; give one, or leave it out to run in every cycle");
        }
        Number::BudgetUs(index) => {
            words(text, &["component `", graph.nodes[index].name, "` has budget_us = "]);
            push_given(text, graph.nodes[index].budget_us);
            text.push(": a budget is a finite number, not below 0; give one, or leave it out to count nothing");
        }
    }
}

const fn cycle(text: &mut Message, graph: &Graph, path: &Path) {
    text.push("activation cycle: ");
    let mut place = 0;
    while place < path.len() {
        text.push(if place == 0 { "" } else { " -> " });
        text.push(graph.nodes[path.get(place)].name);
        place += 1;
    }
}

const fn unreachable(text: &mut Message, graph: &Graph, path: &Path) {
    let one = path.len() == 1;
    text.push(if one { "component " } else { "components " });
    let mut place = 0;
    while place < path.len() {
        text.push(if place == 0 { "" } else { ", " });
        words(text, &["`", graph.nodes[path.get(place)].name, "`"]);
        place += 1;
    }
    let root = graph.nodes[graph.root].name;
    words(text, &[" of tree `", graph.name, "` can never be activated: no component reachable from the root `", root]);
    text.push(if one {
        "` links to it; link it or remove it from the list"
    } else {
        "` links to them; link them or remove them from the list"
    });
}

const fn too_fast(text: &mut Message, graph: &Graph, index: usize) {
    let node = &graph.nodes[index];
    words(text, &["component `", node.name, "` has hz = "]);
    push_given(text, node.hz);
    words(text, &[", faster than tree `", graph.name, "`, which is ticked with cycle_hz = "]);
    text.push_number(graph.cycle_hz as f64);
    text.push("; lower the component's hz or raise the tree's cycle_hz");
}

/// A case with the states only that matter to the writers of a child.
const fn relevant(graph: &Graph, child: usize, case: &WorstCase) -> WorstCase {
    let mut case = *case;
    let (leading, mut index) = (leading_to(graph, child), 0);
    while index < graph.nodes.len() {
        if !leading.contains(index) {
            case.choices[index] = Choice::None;
        }
        index += 1;
    }
    case
}

const fn unordered(text: &mut Message, graph: &Graph, index: usize, writers: &Writers) {
    let (child, first) = (graph.nodes[index].name, graph.nodes[writers.order.get(0)].name);
    let last = graph.nodes[writers.order.get(writers.order.len() - 1)].name;
    words(text, &["`", child, "` is written in one cycle by `", first, "`"]);
    let mut place = 1;
    while place < writers.order.len() {
        words(text, &[", then by `", graph.nodes[writers.order.get(place)].name, "`"]);
        place += 1;
    }
    situation(text, graph, &relevant(graph, index, &writers.case));
    words(text, &["; write `#[component(writers = first)]` on `", child, "` if what `", first, "` writes counts"]);
    words(text, &[", `writers = last` if what `", last, "` does, or let one component write it"]);
}

/// The output, as `Localization.robot_pose`.
const fn output(text: &mut Message, graph: &Graph, output: OutputIndex) {
    words(text, &["`", graph.nodes[output.0].name, ".", output.of(graph).name, "`"]);
}

const fn two_places(text: &mut Message, graph: &Graph, first: OutputIndex, second: OutputIndex) {
    output(text, graph, first);
    text.push(" and ");
    output(text, graph, second);
    if let Some(child) = first.child(graph) {
        words(
            text,
            &[" are both the place of the frame `", child, "`; a frame has one place: remove `child` from one"],
        );
    }
}

const fn frame_cycle(text: &mut Message, graph: &Graph, first: OutputIndex) {
    text.push("frame cycle: ");
    let mut at = Some(first);
    while let Some(here) = at {
        if let (Some(child), Some(frame)) = (here.child(graph), here.frame(graph)) {
            words(text, &[child, " in ", frame, " by "]);
        }
        output(text, graph, here);
        at = match parent(graph, here) {
            Some(next) if next.0 == first.0 && next.1 == first.1 => None,
            next => next,
        };
        text.push(if at.is_some() { ", " } else { "; remove one of these places" });
    }
}
