//! Games controlled by firmware on an emulated microcontroller.
//!
//! The world executes the commands of this program's forward, which runs on the same sensor values as the firmware. In
//! every cycle both must produce the same commands, bit for bit, and the same tree; a deviation ends the game. So the
//! story of the game is that of the firmware. Requests of an operator are sent to both.

use std::path::{Path, PathBuf};

use bica::runner::{Cycle, Observer, Request};
use bica::{ComponentId, Instant, Probe, Tree};
use bica_app::{Console, Failure, Style};
use bica_field::GoalColour;
use bica_motion::robot::Sensors;
use bica_player::tunable::Forward;
use bica_sim::setup::Frame;
use bica_wire::message::Change;
use bica_wire::model::Invalid;
use serde::Serialize;

use crate::emulator::{Controller, CycleReport, Transport, command_bits, unexpected};
use crate::game::scene::GRAPH;

/// Firmware image for the emulated microcontroller.
#[derive(Clone, Copy, Debug)]
pub struct FirmwareImage {
    path: &'static Path,
    /// Size of the camera images that the firmware receives.
    size: Frame,
}

impl FirmwareImage {
    /// Path at which `cargo xtask firmware --build` puts the image for camera images of 160×120, relative to the repository.
    pub const DEFAULT: &str = "firmware/target/thumbv7em-none-eabihf/release/forward-an500";

    /// Path of the image with the server for monitors, which a served game needs for an operator. It accepts camera
    /// images of 160×120.
    pub const MONITOR: &str = "firmware/target/thumbv7em-none-eabihf/release/forward-an500-monitor";

    /// Path of the image for camera images of 320×240.
    pub const MEDIUM: &str = "firmware/target/thumbv7em-none-eabihf/release/forward-an500-medium";

    /// Returns the path of the image for a game with camera images of a size. A `served` game gets an image with the
    /// server for monitors if there is one; a game without it can only be watched.
    #[must_use]
    pub const fn built(size: Frame, served: bool) -> &'static str {
        match (size, served) {
            (Frame::Small, false) => Self::DEFAULT,
            (Frame::Small, true) => Self::MONITOR,
            (Frame::Medium | Frame::Large, _) => Self::MEDIUM,
        }
    }

    /// Creates the image of a file, for camera images of a size.
    ///
    /// # Errors
    /// If no firmware image can process camera images of this size.
    pub fn new(path: PathBuf, size: Frame) -> Result<Self, Failure> {
        if size == Frame::Large {
            let what = "no firmware image takes camera images of 640x480";
            return Err(Failure::new(what, "give --size 160x120 or --size 320x240"));
        }
        // The path is leaked once: it lives as long as the program and is shared by all threads.
        Ok(Self { path: Box::leak(path.into_boxed_path()), size })
    }

    pub(crate) fn start(self, attacks: GoalColour) -> Result<Controller, Failure> {
        let controller = Controller::start(self.path, Transport::Pipe, attacks, None)?;
        let ((width, height), most) = (self.size.size(), controller.image_bytes());
        if most < 2 * width * height {
            let path = self.path.display();
            let what = format!("the firmware image `{path}` takes at most {} pixels, not {width}x{height}", most / 2);
            let help = format!(
                "give `--image {}`, which `cargo xtask firmware --build` builds, or --size 160x120",
                Self::MEDIUM
            );
            return Err(Failure::new(what, help));
        }
        Ok(controller)
    }
}

/// Observer that runs the firmware, if there is one, and compares it with this program.
#[derive(Debug)]
pub(crate) struct FirmwareCheck {
    controller: Option<Controller>,
    /// Changes that this program's forward accepted before the next cycle; `None` for a change that no message can express.
    changes: Vec<Option<Change>>,
    report: Option<Result<CycleReport, Invalid>>,
    failure: Option<Failure>,
    /// Instructions of each cycle.
    cycles: Vec<u64>,
    /// Instructions of each run of each component.
    runs: Vec<Vec<u64>>,
}

impl FirmwareCheck {
    pub(crate) fn new(controller: Option<Controller>) -> Self {
        let runs = vec![Vec::new(); GRAPH.nodes.len()];
        Self { controller, changes: Vec::new(), report: None, failure: None, cycles: Vec::new(), runs }
    }

    /// Returns whether the firmware takes part and accepts no requests.
    pub(crate) fn is_watch_only(&mut self) -> Result<bool, Failure> {
        let Some(controller) = &mut self.controller else { return Ok(false) };
        Ok(!controller.has_monitors()?)
    }

    /// Returns the first failure.
    pub(crate) fn result(&mut self) -> Result<(), Failure> {
        self.failure.take().map_or(Ok(()), Err)
    }

    fn compare(&mut self, cycle: &Cycle<'_, Forward>, report: &CycleReport) -> Result<(), Failure> {
        let robot = cycle.robot;
        let same_tree = (0..GRAPH.nodes.len()).map(ComponentId::new).all(|id| {
            let index = id.index();
            report.active.get(index) == Some(&robot.at(id).is_ok_and(|component| component.is_active()))
                && report.states.get(index) == Some(&robot.state(id))
        });
        if !command_bits(&report.command).eq(command_bits(cycle.command)) || !same_tree || report.lost > 0 {
            let what = format!("firmware and program deviate at {} µs", cycle.now.as_micros());
            return Err(Failure::new(what, "rebuild the image from these sources: cargo xtask firmware --build"));
        }
        self.cycles.push(report.instructions);
        for (runs, &cost) in self.runs.iter_mut().zip(&report.costs).filter(|(_, cost)| **cost > 0) {
            runs.push(cost);
        }
        Ok(())
    }

    /// Returns the instruction counts of the game, if the firmware took part.
    pub(crate) fn summarize(self) -> Option<FirmwareSummary> {
        self.controller.as_ref()?;
        let count = |(node, runs): (&bica::graph::Node, _)| InstructionCount::new(node.name, runs);
        let components = GRAPH.nodes.iter().zip(self.runs).map(count).collect();
        Some(FirmwareSummary { chain: InstructionCount::new("chain", self.cycles), components })
    }
}

impl Probe for FirmwareCheck {}

impl Observer<Forward> for FirmwareCheck {
    fn requested(&mut self, _now: Instant, request: &Request<'_>) {
        match request {
            _ if self.controller.is_none() => {}
            // Requests to the world concern only this program.
            Request::World { .. } => {}
            Request::Go { .. } => {
                let what =
                    "the firmware's image goes to no state by request, so it and this program differ from now on";
                self.failure = Some(Failure::new(what, "play with `--world built-in`"));
            }
            request => self.changes.push(request.store()),
        }
    }

    fn sensing(&mut self, now: Instant, sensors: &Sensors<'_>) {
        let Some(controller) = &mut self.controller else { return };
        self.report = Some(cycle(controller, self.changes.drain(..), now.as_micros(), sensors));
    }

    fn acted(&mut self, cycle: &Cycle<'_, Forward>) {
        let result = match self.report.take() {
            Some(Ok(report)) => self.compare(cycle, &report),
            Some(Err(error)) => Err(error.into()),
            None => Ok(()),
        };
        self.failure = self.failure.take().or(result.err());
    }
}

/// Sends the changes to the firmware, then runs a cycle.
fn cycle(
    controller: &mut Controller,
    changes: impl Iterator<Item = Option<Change>>,
    time_us: u64,
    sensors: &Sensors<'_>,
) -> Result<CycleReport, Invalid> {
    for change in changes {
        let unknown = || unexpected("a request that the firmware does not know");
        controller.request(change.ok_or_else(unknown)?)?;
    }
    controller.keep()?;
    controller.cycle(time_us, sensors)
}

/// Instruction counts of a game, by the clock of the emulated microcontroller (one tick per 40 instructions).
#[derive(Clone, Debug, Serialize)]
pub struct FirmwareSummary {
    /// Each cycle, from sensing to acting.
    pub chain: InstructionCount,
    /// The runs of each component.
    pub components: Vec<InstructionCount>,
}

/// Instructions of many runs.
#[derive(Clone, Debug, Serialize)]
pub struct InstructionCount {
    /// Name of the component, or `chain`.
    pub name: &'static str,
    /// Number of runs.
    pub runs: usize,
    /// Median of a run.
    pub median: u64,
    /// Maximum of a run.
    pub max: u64,
    /// Sum of all runs.
    pub total: u64,
}

impl InstructionCount {
    fn new(name: &'static str, mut runs: Vec<u64>) -> Self {
        runs.sort_unstable();
        let at = |index: usize| runs.get(index).copied().unwrap_or(0);
        let (median, max) = (at(runs.len() / 2), at(runs.len().saturating_sub(1)));
        Self { name, runs: runs.len(), median, max, total: runs.iter().sum() }
    }
}

impl FirmwareSummary {
    /// Prints a table with the most expensive component first.
    pub(crate) fn print(&self, console: Console) -> Result<(), Failure> {
        let InstructionCount { median, max, .. } = self.chain;
        let chain =
            format!("sense-think-act median {median}  max {max} instructions per cycle, on the microcontroller");
        console.print_row("cost", &chain)?;
        console.print("")?;
        let header = format!("{:<14} {:>7} {:>11} {:>11} {:>13}", "component", "runs", "median", "max", "total");
        console.print(&console.styled(Style::Strong, &format!("{header}  instructions")))?;
        let mut sorted: Vec<_> = self.components.iter().filter(|count| count.runs > 0).collect();
        sorted.sort_by_key(|count| std::cmp::Reverse(count.total));
        for InstructionCount { name, runs, median, max, total } in sorted {
            console.print(&format!("{name:<14} {runs:>7} {median:>11} {max:>11} {total:>13}"))?;
        }
        Ok(())
    }
}
