//! Story of a game: one line for each change of the tree and each event.

use bica_app::{Console, Failure, Style};
use bica_drawing::TreeState;
use bica_evaluation::polar::{Polar, describe};
use bica_sim::referee::TimedEvent;
use serde::Serialize;

use crate::game::event;
use crate::game::observer::GameObserver;
use crate::game::scene::Scene;
use crate::game::summary::FaultRecord;

/// Change of the tree, for JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct TreeChange {
    /// Time, s.
    t: f64,
    /// State of the root.
    state: &'static str,
    /// Active components in the order of the tree; state machines with their states.
    active: Vec<String>,
    ball: Option<Polar>,
    goal: Option<Polar>,
}

/// Observer that prints the story.
pub(crate) struct Story {
    console: Console,
    /// All changes so far; only kept for JSON.
    pub(crate) changes: Vec<TreeChange>,
    has_header: bool,
}

impl Story {
    pub(crate) const fn new(console: Console) -> Self {
        Self { console, changes: Vec::new(), has_header: false }
    }

    /// Prints a line, and the header of the columns before the first one. So a game that is refused prints nothing.
    fn print(&mut self, line: &str) -> Result<(), Failure> {
        if !std::mem::replace(&mut self.has_header, true) {
            let header = columns(self.console, "time", "state", (" ball", " goal"), Style::Faint);
            let active = "active components without inputs and outputs (+ started, - stopped)";
            self.console.print(&format!("{header}{}", self.console.styled(Style::Faint, active)))?;
        }
        self.console.print(line)
    }

    /// Returns the active components that activate others; those that just started are marked. Then those that stopped.
    fn components(&self, scene: &Scene<'_>, tree: &TreeState<'_>) -> String {
        let is_in = |list: &[bica::ComponentId], node: usize| list.iter().any(|id| id.index() == node);
        let activates = |node: usize| !tree.tree.components[node].links.is_empty();
        let mut parts: Vec<String> = active(tree)
            .filter(|&node| activates(node))
            .map(|node| {
                let started = is_in(&scene.meter.started, node);
                let name = format!("{}{}", if started { "+" } else { "" }, with_state(tree, node));
                self.console.styled(if started { Style::New } else { Style::Plain }, &name)
            })
            .collect();
        for id in scene.meter.stopped.iter().filter(|id| activates(id.index()) && !tree.is_active(id.index())) {
            parts.push(self.console.styled(Style::Faint, &format!("-{}", tree.tree.components[id.index()].name)));
        }
        parts.join(" ")
    }
}

impl GameObserver for Story {
    fn tree_changed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        let (tree, (ball, goal)) = (scene.tree(), scene.positions());
        let state = tree.state(tree.tree.root).unwrap_or("-");
        let row = columns(self.console, &time(scene.t), state, (&describe(ball), &describe(goal)), Style::Strong);
        let line = format!("{row}{}", self.components(scene, &tree));
        self.print(&line)?;
        if self.console.is_json() {
            let active = active(&tree).map(|node| with_state(&tree, node)).collect();
            self.changes.push(TreeChange { t: scene.t, state, active, ball, goal });
        }
        Ok(())
    }

    fn fault(&mut self, fault: &FaultRecord) -> Result<(), Failure> {
        let text = self.console.styled(Style::Bad, &format!("* {}", fault.text()));
        self.print(&format!("{}  {text}", time(fault.t)))
    }

    fn event(&mut self, event: &TimedEvent) -> Result<(), Failure> {
        let (style, text) = event::describe(&event.event);
        let text = self.console.styled(style, &format!("* {text}"));
        self.print(&format!("{}  {text}", time(event.at.as_secs_f64())))
    }
}

fn time(t: f64) -> String {
    format!("{t:>7.2}")
}

fn columns(console: Console, time: &str, state: &str, (ball, goal): (&str, &str), style: Style) -> String {
    format!("{time:>7}  {}  {ball:<20} {goal:<20} ", console.styled(style, &format!("{state:<13}")))
}

/// Active components except the root.
fn active(tree: &TreeState<'_>) -> impl Iterator<Item = usize> {
    tree.active().filter(|&node| node != tree.tree.root)
}

fn with_state(tree: &TreeState<'_>, node: usize) -> String {
    let name = &tree.tree.components[node].name;
    tree.state(node).map_or_else(|| name.clone(), |state| format!("{name}:{state}"))
}
