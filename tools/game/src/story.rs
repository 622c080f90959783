//! The story of a game, a line for every change of the tree and for everything that the referee reports.

use bica_sim::referee::TimedEvent;
use serde::Serialize;

use super::event;
use super::scene::Scene;
use crate::observer::Observer;
use bica_console::Failure;
use bica_console::{Console, Style};
use bica_drawing::polar::{Sight, words};
use bica_drawing::scene::TreeNow;

/// A change of the tree for machines.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Change {
    /// When, s.
    pub t: f64,
    /// The state of the root.
    pub state: &'static str,
    /// The active components with the states of the machines among them, in the order of the tree's list.
    pub active: Vec<String>,
    pub ball: Option<Sight>,
    pub goal: Option<Sight>,
}

/// Tells a game as it goes, and keeps what it told.
pub struct Story {
    console: Console,
    /// All changes so far; kept for machines only.
    pub changes: Vec<Change>,
}

impl Story {
    /// A story not begun yet.
    pub const fn new(console: Console) -> Self {
        Self { console, changes: Vec::new() }
    }

    /// The heading of the columns.
    pub fn begin(&self) -> Result<(), Failure> {
        let heading = columns(self.console, "time", "state", (" ball", " goal"), Style::Faint);
        self.console.print(&format!(
            "{heading}{}",
            self.console.styled(Style::Faint, "active components but inputs and outputs: + new, - gone")
        ))
    }

    /// The active components but the root and those that activate nothing, new ones marked, then those that have gone.
    fn components(&self, scene: &Scene<'_>, tree: &TreeNow) -> String {
        let is_in = |list: &[bica::ComponentId], node: usize| list.iter().any(|id| id.index() == node);
        let activates = |node: usize| !tree.graph.nodes[node].links.is_empty();
        let mut parts: Vec<String> = active(tree)
            .filter(|&node| activates(node))
            .map(|node| {
                let new = is_in(&scene.meter.started, node);
                let name = format!("{}{}", if new { "+" } else { "" }, with_state(tree, node));
                self.console.styled(if new { Style::New } else { Style::Plain }, &name)
            })
            .collect();
        for gone in scene.meter.stopped.iter().filter(|id| activates(id.index()) && !tree.active[id.index()]) {
            parts.push(self.console.styled(Style::Faint, &format!("-{}", tree.graph.nodes[gone.index()].name)));
        }
        parts.join(" ")
    }
}

impl Observer for Story {
    fn changed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        let (tree, (ball, goal)) = (scene.tree(), scene.sights());
        let state = tree.state(tree.graph.root).unwrap_or("-");
        let row = columns(self.console, &time(scene.t), state, (&words(ball), &words(goal)), Style::Strong);
        self.console.print(&format!("{row}{}", self.components(scene, &tree)))?;
        if self.console.is_json() {
            let active = active(&tree).map(|node| with_state(&tree, node)).collect();
            self.changes.push(Change { t: scene.t, state, active, ball, goal });
        }
        Ok(())
    }

    fn happened(&mut self, happened: &TimedEvent) -> Result<(), Failure> {
        let (style, words) = event::words(&happened.event);
        let words = self.console.styled(style, &format!("* {words}"));
        self.console.print(&format!("{}  {words}", time(happened.at.as_secs_f64())))
    }
}

/// Seconds, right-aligned.
fn time(t: f64) -> String {
    format!("{t:>7.2}")
}

fn columns(console: Console, time: &str, state: &str, (ball, goal): (&str, &str), style: Style) -> String {
    format!("{time:>7}  {}  {ball:<20} {goal:<20} ", console.styled(style, &format!("{state:<13}")))
}

/// The active components but the root.
fn active(tree: &TreeNow) -> impl Iterator<Item = usize> {
    (0..tree.active.len()).filter(|&node| tree.active[node] && node != tree.graph.root)
}

fn with_state(tree: &TreeNow, node: usize) -> String {
    let name = tree.graph.nodes[node].name;
    tree.state(node).map_or_else(|| name.to_owned(), |state| format!("{name}:{state}"))
}
