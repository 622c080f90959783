//! The story of a game, a line for every change of the tree and for everything that the referee reports.

use bica_sim::referee::TimedEvent;
use serde::Serialize;

use super::audience::Audience;
use super::event;
use super::scene::Scene;
use super::sight::{Sight, words};
use crate::program::ending::Failure;
use crate::program::picture::scene::TreeNow;
use crate::program::voice::{Style, Voice};

/// A change of the tree for machines.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Change {
    /// When, s.
    pub(crate) t: f64,
    /// The state of the root.
    pub(crate) state: &'static str,
    /// The active components with the states of the machines among them, in the order of the tree's list.
    pub(crate) active: Vec<String>,
    pub(crate) ball: Option<Sight>,
    pub(crate) goal: Option<Sight>,
}

/// Tells a game as it goes, and keeps what it told.
pub(crate) struct Story {
    voice: Voice,
    /// All changes so far; kept for machines only.
    pub(crate) changes: Vec<Change>,
}

impl Story {
    /// A story not begun yet.
    pub(crate) const fn new(voice: Voice) -> Self {
        Self { voice, changes: Vec::new() }
    }

    /// The heading of the columns.
    pub(crate) fn begin(&self) -> Result<(), Failure> {
        let heading = columns(self.voice, "time", "state", (" ball", " goal"), Style::Faint);
        self.voice.say(&format!(
            "{heading}{}",
            self.voice.style(Style::Faint, "active components but inputs and outputs: + new, - gone")
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
                self.voice.style(if new { Style::New } else { Style::Plain }, &name)
            })
            .collect();
        for gone in scene.meter.stopped.iter().filter(|id| activates(id.index()) && !tree.active[id.index()]) {
            parts.push(self.voice.style(Style::Faint, &format!("-{}", tree.graph.nodes[gone.index()].name)));
        }
        parts.join(" ")
    }
}

impl Audience for Story {
    fn changed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        let (tree, (ball, goal)) = (scene.tree(), scene.sights());
        let state = tree.state(tree.graph.root).unwrap_or("-");
        let row = columns(self.voice, &time(scene.t), state, (&words(ball), &words(goal)), Style::Strong);
        self.voice.say(&format!("{row}{}", self.components(scene, &tree)))?;
        if self.voice.is_json() {
            let active = active(&tree).map(|node| with_state(&tree, node)).collect();
            self.changes.push(Change { t: scene.t, state, active, ball, goal });
        }
        Ok(())
    }

    fn happened(&mut self, happened: &TimedEvent) -> Result<(), Failure> {
        let (style, words) = event::words(&happened.event);
        let words = self.voice.style(style, &format!("* {words}"));
        self.voice.say(&format!("{}  {words}", time(happened.at.as_secs_f64())))
    }
}

/// Seconds, right-aligned.
fn time(t: f64) -> String {
    format!("{t:>7.2}")
}

fn columns(voice: Voice, time: &str, state: &str, (ball, goal): (&str, &str), style: Style) -> String {
    format!("{time:>7}  {}  {ball:<20} {goal:<20} ", voice.style(style, &format!("{state:<13}")))
}

/// The active components but the root.
fn active(tree: &TreeNow) -> impl Iterator<Item = usize> {
    (0..tree.active.len()).filter(|&node| tree.active[node] && node != tree.graph.root)
}

fn with_state(tree: &TreeNow, node: usize) -> String {
    let name = tree.graph.nodes[node].name;
    tree.state(node).map_or_else(|| name.to_owned(), |state| format!("{name}:{state}"))
}
