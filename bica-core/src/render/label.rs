//! What is written into the drawings.

use core::fmt::{Display, Formatter, Result, Write, from_fn};

use super::Arrow;
use crate::check::{Writers, writers};
use crate::graph::{Graph, Node, Roles, Transition};

/// Type of a component with a name, rate, budget and writers: `Leg<0> · 30 Hz · 40 µs · written by Avoid, then Follow; in force: Avoid`.
pub(super) fn figures(graph: &Graph, index: usize) -> impl Display {
    from_fn(move |f| {
        let node = &graph.nodes[index];
        node.kind.map_or(Ok(()), |kind| write!(f, "{kind} · "))?;
        match node.hz {
            Some(hz) => write!(f, "{hz} Hz")?,
            None => f.write_str("every cycle")?,
        }
        node.budget_us.map_or(Ok(()), |budget| write!(f, " · {budget} µs"))?;
        let Some(writers) = writers(graph, index) else { return Ok(()) };
        f.write_str(" · ")?;
        written(f, graph, &writers)
    })
}

/// Who writes a component in one cycle, and what counts: `written by Avoid, then Follow; in force: Avoid`.
fn written(f: &mut Formatter<'_>, graph: &Graph, writers: &Writers) -> Result {
    for (place, index) in writers.order.iter().enumerate() {
        write!(f, "{} {}", if place == 0 { "written by" } else { ", then" }, graph.nodes[index].name)?;
    }
    write!(f, "; in force: {}", graph.nodes[writers.in_force()].name)
}

/// The roles of an arrow, and the names of the states in which it holds: `Ball · search, follow`.
pub(super) fn link(graph: &Graph, arrow: Arrow<'_>) -> impl Display {
    from_fn(move |f| {
        let (roles, states) = (graph.role_names(arrow.roles()), arrow.states().map(|state| state.name));
        listed(f, roles)?;
        let are_both = arrow.roles() != Roles::NONE && arrow.states().next().is_some();
        f.write_str(if are_both { " · " } else { "" })?;
        listed(f, states)
    })
}

fn listed<'a>(f: &mut Formatter<'_>, names: impl Iterator<Item = &'a str>) -> Result {
    names.enumerate().try_for_each(|(index, name)| {
        f.write_str(if index == 0 { "" } else { ", " })?;
        f.write_str(name)
    })
}

/// A state's name, what it takes from transitions, its result, and what runs before its own: `kick ← Kick (before: plan)`, `held [done]`.
pub(super) fn state(node: &Node, index: usize) -> impl Display {
    from_fn(move |f| {
        let Some(state) = node.states.get(index) else { return Ok(()) };
        f.write_str(state.name)?;
        node.takes(index).map_or(Ok(()), |of| write!(f, " ← {of}"))?;
        state.end.map_or(Ok(()), |end| write!(f, " [{}]", end.word()))?;
        state.before.map_or(Ok(()), |before| write!(f, " (before: {before})"))
    })
}

/// A transition's name, and what it waits for: `ball_lost, after 1500 ms`, `failed(Reach), 3 times`.
pub(super) fn transition(node: &Node, edge: &Transition) -> impl Display {
    from_fn(move |f| {
        f.write_str(edge.name)?;
        // The name of a transition without a function says so already.
        if let Some(when) = edge.when.filter(|_| !edge.name.ends_with(')')) {
            write!(f, ", when {}", when.end.word())?;
        }
        match (node.timer(edge), edge.after_ms) {
            (Some(parameter), Some(after)) => write!(f, ", after {} ({after} ms)", parameter.name)?,
            (_, Some(after)) => write!(f, ", after {after} ms")?,
            _ => {}
        }
        edge.times.map_or(Ok(()), |times| write!(f, ", {times} times"))
    })
}

/// Writes text with every character escaped that a language needs escaped.
pub(super) struct Escaped<'a, 'f> {
    pub(super) out: &'a mut Formatter<'f>,
    pub(super) escape: fn(&mut Formatter<'_>, char) -> Result,
}

impl Write for Escaped<'_, '_> {
    fn write_str(&mut self, text: &str) -> Result {
        text.chars().try_for_each(|character| (self.escape)(self.out, character))
    }
}
