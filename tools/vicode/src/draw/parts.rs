//! States and transitions of a drawing, in points.

use bica_syntax::component::model;

use crate::compare::Change;
use crate::model::{Component, Function, Link, LinkKind};

/// Width and least height of a state, points.
pub(super) const WIDTH: f32 = 160.0;
pub(super) const HEIGHT: f32 = 40.0;
/// Height of a line of text, points.
pub(super) const LINE: f32 = 14.0;
/// A state.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// Its name.
    pub name: String,
    /// Whether the machine starts in it.
    pub initial: bool,
    /// Whether no transition leaves it.
    pub last: bool,
    /// Centre and size, points.
    pub centre: (f32, f32),
    /// Width and height, points.
    pub size: (f32, f32),
    /// Type of the found value that the state takes from the transitions that enter it.
    pub takes: Option<String>,
    /// Result with which the machine ends in it.
    pub end: Option<&'static str>,
    /// Its hooks.
    pub hooks: Vec<String>,
    /// Links of the state and of its hooks, without those of the transitions that leave it.
    pub links: Vec<Link>,
    /// Ages and outcomes for which the state and its hooks ask.
    pub asks: Vec<String>,
    /// Mark of the state in a difference; `None` if it is equal.
    pub mark: Option<Change>,
}

/// A transition, or several ones from one state to one other.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// Names and timers, one line each; none if another line of the same transition has the name.
    pub labels: Vec<Label>,
    /// The line, points.
    pub points: Vec<(f32, f32)>,
    /// The line to labels that stand beside it, points; empty without one.
    pub leader: Vec<(f32, f32)>,
    /// Middle of the labels, points.
    pub label_at: (f32, f32),
    /// How it differs, in a difference: as all its transitions do, else it is equal.
    pub mark: Option<Change>,
}

/// Name and timer of a transition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Text; with a mark it begins with the sign of the mark.
    pub text: String,
    /// Mark of the transition in a difference; `None` if it is equal.
    pub mark: Option<Change>,
}

/// Returns the height of a state with `lines` lines below its name, points.
pub(super) fn height(lines: usize) -> f32 {
    HEIGHT + LINE * lines as f32
}

/// Formats the name of a state with the type of the found value that it takes: `kick ← Kick`.
pub(super) fn titled(name: &str, takes: Option<&str>) -> String {
    takes.map_or_else(|| name.to_owned(), |of| format!("{name} ← {of}"))
}

/// Returns the hooks of a state: `entry / greet`.
pub(super) fn hooks_of(component: &Component, state: &str) -> Vec<String> {
    let hooks = component.hooks.iter().filter(|hook| hook.states.iter().any(|one| one.text == state));
    hooks.map(|hook| format!("{} / {}", hook.role.word(), hook.function.name.text)).collect()
}

/// Formats the name of a transition, what it waits for, and for what it asks: `near after 500 ms`, `failed(Reach) 3 times`,
/// `gives_up (outcome of Reach)`.
pub(super) fn label(edge: &model::Edge<&Function>) -> String {
    let when = edge.guard.when.as_ref().filter(|_| !edge.guard.bare).map(|when| format!(" {when}"));
    let timer = edge.guard.timer.as_ref().map(|timer| match timer {
        model::Timer::Ms(ms) => format!(" after {ms} ms"),
        model::Timer::Parameter(timer) => format!(" after {timer}"),
    });
    let times = edge.guard.times.map(|times| format!(" {times} times"));
    let asks: Vec<String> = if edge.guard.bare { Vec::new() } else { edge.condition.asks().collect() };
    let asks = (!asks.is_empty()).then(|| format!(" ({})", asks.join(", ")));
    [Some(edge.name()), when, timer, times, asks].into_iter().flatten().collect()
}

impl Label {
    pub(super) fn new(edge: &model::Edge<&Function>, mark: Option<Change>) -> Self {
        let sign = mark.map_or_else(String::new, |mark| format!("{} ", mark.sign()));
        Self { text: format!("{sign}{}", label(edge)), mark }
    }
}

impl Node {
    /// Returns the name, what the state takes, and its result: `kick ← Kick`, `held [done]`.
    #[must_use]
    pub fn title(&self) -> String {
        let end = self.end.map_or_else(String::new, |end| format!(" [{end}]"));
        titled(&self.name, self.takes.as_deref()) + &end
    }

    /// Returns the lines below the name: hooks, then children; `<` is a requirement, `>` a modulation, `?` an age or outcome.
    #[must_use]
    pub fn lines(&self) -> Vec<String> {
        let mark = |kind| if kind == LinkKind::Requirement { '<' } else { '>' };
        let links = self.links.iter().map(|link| format!("{} {}", mark(link.kind), link.child));
        let asks = self.asks.iter().map(|asks| format!("? {asks}"));
        self.hooks.iter().cloned().chain(links).chain(asks).collect()
    }
}
