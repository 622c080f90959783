//! A game in which an emulated microcontroller thinks.
//!
//! The world obeys the microcontroller alone. The forward of this program is its twin: it senses the same, and has to
//! come to the same commands, bit for bit, and the same tree in every cycle. So the story of the one is the story of the
//! other, and any difference ends the game.

use std::path::{Path, PathBuf};

use bica::{ComponentId, Instant, Tree};
use bica_emulator::{Controller as Remote, Error, Transport, command_bits};
use bica_field::GoalColour;
use bica_motion::robot::{Command, Sensors};
use bica_player::Forward;
use bica_sim::setup::Frame;
use serde::Serialize;

use super::scene::GRAPH;
use bica_console::Failure;
use bica_console::{Console, Style};

/// An image for the microcontroller.
#[derive(Clone, Copy, Debug)]
pub struct Image(&'static Path);

impl Image {
    /// The image of a file, for cameras of a size.
    pub fn new(path: PathBuf, size: Frame) -> Result<Self, Failure> {
        if size != Frame::Small {
            return Err(Failure::new("the microcontroller takes no images larger than 160x120", "leave --size away"));
        }
        // The one path of the program's whole life; every thread that plays reads it.
        Ok(Self(Box::leak(path.into_boxed_path())))
    }

    /// Starts it.
    pub fn start(self, attacks: GoalColour) -> Result<Mind, Failure> {
        let remote = Remote::start(self.0, Transport::Pipe, attacks, None).map_err(|error| failure(&error))?;
        Ok(Mind { remote, chains: Vec::new(), runs: vec![Vec::new(); GRAPH.nodes.len()] })
    }
}

fn failure(error: &Error) -> Failure {
    Failure::new(error.to_string(), "`cargo xtask firmware` gets what is needed, builds the image and tests it")
}

/// A microcontroller that thinks.
pub struct Mind {
    remote: Remote,
    /// Instructions of every cycle.
    chains: Vec<u64>,
    /// Instructions of every run of each component.
    runs: Vec<Vec<u64>>,
}

impl Mind {
    /// Senses, thinks, acts; the twin has just done the same.
    pub fn think(
        &mut self,
        now: Instant,
        sensors: &Sensors<'_>,
        twin: &Command,
        robot: &Forward,
    ) -> Result<(), Failure> {
        let thought = self.remote.cycle(now.as_micros(), sensors).map_err(|error| failure(&error))?;
        let same_tree = (0..GRAPH.nodes.len()).map(ComponentId::new).all(|id| {
            let index = id.index();
            thought.active.get(index) == Some(&robot.is_active(id))
                && thought.states.get(index) == Some(&robot.state(id))
        });
        if !command_bits(&thought.command).eq(command_bits(twin)) || !same_tree || thought.lost > 0 {
            let what = format!("the microcontroller thinks otherwise than this program, at {} µs", now.as_micros());
            return Err(Failure::new(what, "build the image anew from these sources: cargo xtask firmware --build"));
        }
        self.chains.push(thought.instructions);
        for (runs, &cost) in self.runs.iter_mut().zip(&thought.costs).filter(|(_, cost)| **cost > 0) {
            runs.push(cost);
        }
        Ok(())
    }

    /// What it spent.
    pub fn sum_up(self) -> Figures {
        let components = GRAPH.nodes.iter().zip(self.runs).map(|(node, runs)| Spent::new(node.name, runs)).collect();
        Figures { chain: Spent::new("chain", self.chains), components }
    }
}

/// Instructions that a game took, counted by the microcontroller's own clock: one in 40 instructions.
#[derive(Clone, Debug, Serialize)]
pub struct Figures {
    /// From sensing to acting, of every cycle.
    pub chain: Spent,
    pub components: Vec<Spent>,
}

/// Instructions of many runs.
#[derive(Clone, Debug, Serialize)]
pub struct Spent {
    pub name: &'static str,
    pub runs: usize,
    pub median: u64,
    pub max: u64,
    pub total: u64,
}

impl Spent {
    fn new(name: &'static str, mut runs: Vec<u64>) -> Self {
        runs.sort_unstable();
        let at = |place: usize| runs.get(place).copied().unwrap_or(0);
        let (median, max) = (at(runs.len() / 2), at(runs.len().saturating_sub(1)));
        Self { name, runs: runs.len(), median, max, total: runs.iter().sum() }
    }
}

impl Figures {
    /// Tells people, the costliest component first.
    pub fn tell(&self, console: Console) -> Result<(), Failure> {
        let Spent { median, max, .. } = self.chain;
        let chain = format!("sense-think-act median {median}  max {max} instructions a cycle, on the microcontroller");
        console.print_row("cost", &chain)?;
        console.print("")?;
        let heading = format!("{:<14} {:>7} {:>11} {:>11} {:>13}", "component", "runs", "median", "max", "total");
        console.print(&console.styled(Style::Strong, &format!("{heading}  instructions")))?;
        let mut sorted: Vec<_> = self.components.iter().filter(|spent| spent.runs > 0).collect();
        sorted.sort_by_key(|spent| std::cmp::Reverse(spent.total));
        for Spent { name, runs, median, max, total } in sorted {
            console.print(&format!("{name:<14} {runs:>7} {median:>11} {max:>11} {total:>13}"))?;
        }
        Ok(())
    }
}
