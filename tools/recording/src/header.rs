//! The first and the last record of a recording.

use std::collections::BTreeMap;

use bica::Graph;
use bica::action::Action;
use bica::runner::Change;
use bica::visual::Scene;
use bica_wire::Recordable;
use bica_wire::model::{Description, Messages};
use serde::{Deserialize, Serialize};

use crate::figure::Figure;
use crate::part::RunPart;
use crate::program::{Program, Start};
use crate::request::RequestRecord;
use crate::scenery::Scenery;

/// Version of the format. Version 7 is a bag of ROS 2; version 6 can be upgraded, earlier ones cannot be read.
pub const FORMAT: u32 = 7;
/// Version of the format of a monitor's recordings. Version 8 is a bag of ROS 2; version 7 can be upgraded.
pub const MONITOR_FORMAT: u32 = 8;

/// Data that a replay needs before the first cycle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// Version of the format.
    pub format: u32,
    /// The program that wrote the recording.
    pub program: Program,
    /// Computer and time of the start of the recording.
    pub start: Start,
    /// The robot, with the values of its parameters at the start.
    pub tree: Description,
    /// Ticks of an instant in a second.
    pub tick_hz: u64,
    /// Data with which the program sets up the same run again, by name.
    pub set_up: SetUp,
    /// Whether sensor values, commands and images are stored.
    pub images: ImagePolicy,
    /// Scenery: the objects that do not move in the world.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub scenery: Vec<Scenery>,
    /// Topics for other programs beside the recording.
    #[serde(default)]
    pub topics: Topics,
    /// The monitor, if a monitor made the recording. Such a recording has no sensor values and commands, and only some images.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub monitor: Option<MonitorInfo>,
    /// Part of the run, if the recording was split. The parameters have the values at the beginning of the part.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<RunPart>,
}

/// The monitor that made a recording.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct MonitorInfo {
    /// Address of the robot.
    pub address: String,
    /// Topics that a recording of the robot's own program has and this one has not.
    pub lacks: Vec<String>,
}

/// Data with which a program sets up the same run again, by name: the seed, options, and the name `world` of a simulated world.
/// The program that records chooses the names.
pub type SetUp = BTreeMap<String, serde_json::Value>;

/// Data of each cycle that a recording stores.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ImagePolicy {
    /// Sensor values, images and commands.
    All,
    /// Digests only: the world is re-created from the rules.
    None,
}

/// Topics of a recording for other programs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Topics {
    /// None.
    #[default]
    None,
    /// Data for viewers: previews of images, frames, shapes, states, parameters and log.
    Standard,
    /// Data for viewers, and numbers: all outputs, sensor values, commands and costs as JSON.
    All,
}

/// Default topics of a recording: they are few beside the images, but would be a large part of a file with digests alone.
impl From<ImagePolicy> for Topics {
    fn from(images: ImagePolicy) -> Self {
        match images {
            ImagePolicy::All => Self::Standard,
            ImagePolicy::None => Self::None,
        }
    }
}

/// The last record of a recording that was closed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ending {
    /// Number of recorded cycles.
    pub cycles: u64,
    /// Number of images that were dropped because the disk was slow.
    pub dropped_images: u64,
    /// Reason why the recording ended before the run; empty if it did not.
    pub reason: String,
    /// Result of the run, as text; empty if unknown.
    pub result: String,
    /// Numbers of the result, as the world reports them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub figures: Vec<Figure>,
}

impl Ending {
    /// Returns the result with its numbers, for people; empty if unknown.
    #[must_use]
    pub fn text(&self) -> String {
        Figure::with(&self.result, &self.figures)
    }
}

/// Ticks of an instant of this program in a second.
pub(crate) const fn tick_hz() -> u64 {
    bica::Duration::from_secs(1).as_ticks()
}

impl Header {
    /// Creates the header of a run of this program that starts now, with the standard topics if images are stored.
    #[must_use]
    pub fn new(graph: &Graph, set_up: SetUp, images: ImagePolicy) -> Self {
        Self {
            format: FORMAT,
            program: Program::of(graph),
            start: Start::now(),
            tree: Description::of(graph),
            tick_hz: tick_hz(),
            set_up,
            images,
            scenery: Vec::new(),
            topics: images.into(),
            monitor: None,
            part: None,
        }
    }

    /// Adds the data of a robot: the values of its parameters, and the schemas of its outputs and messages.
    #[must_use]
    pub fn of_robot<R: Recordable>(self, robot: &R) -> Self {
        Self { tree: self.tree.of_robot(robot), ..self }
    }

    /// Adds the actions of the world.
    #[must_use]
    pub fn with_actions(self, actions: &'static [Action]) -> Self {
        Self { tree: self.tree.with_actions(actions), ..self }
    }

    /// Adds the scenery of the world; `show` is its [`World::scenery`](bica::runner::World::scenery).
    #[must_use]
    pub fn with_scenery(self, show: impl FnOnce(&mut dyn Scene)) -> Self {
        Self { scenery: Scenery::of(show), ..self }
    }

    /// Returns whether the recorded world was a simulated one, which may run again.
    #[must_use]
    pub fn is_simulated(&self) -> bool {
        self.set_up.contains_key("world")
    }

    /// Returns the parameters at the start as assignments, `Component.name=value`.
    pub fn assignments(&self) -> impl Iterator<Item = String> {
        self.tree.components.iter().flat_map(|component| {
            let values = component.params.iter().filter_map(|param| Some((param, param.value?)));
            values.map(|(param, value)| format!("{}.{}={}", component.name, param.name, param.kind.text(value)))
        })
    }

    /// Sets parameters to the values of a request.
    pub(crate) fn apply(&mut self, request: &RequestRecord) {
        let RequestRecord::Tree(Change::Params(settings)) = request else { return };
        for setting in settings {
            let component = self.tree.components.get_mut(setting.component.index());
            if let Some(param) = component.and_then(|one| one.params.get_mut(usize::from(setting.index))) {
                param.value = Some(setting.value);
            }
        }
    }

    /// Returns the schemas of the recorded sensor values and commands; a monitor records none.
    pub(crate) fn messages(&self) -> Option<&Messages> {
        self.tree.messages.as_ref().filter(|_| self.monitor.is_none())
    }

    /// Returns the nominal time from one cycle to the next, ns.
    #[must_use]
    pub fn period(&self) -> u64 {
        (1e9 / f64::from(self.tree.cycle_hz)) as u64
    }

    /// Returns the time of an instant, ns since the start of the run's clock.
    #[must_use]
    pub fn nanoseconds(&self, ticks: u64) -> u64 {
        let nanoseconds = u128::from(ticks) * 1_000_000_000 / u128::from(self.tick_hz.max(1));
        nanoseconds.try_into().unwrap_or(u64::MAX)
    }

    /// Returns the time of an instant since another one, such as that of the first cycle, s; negative before it.
    #[must_use]
    pub fn seconds_since(&self, first: u64, ticks: u64) -> f64 {
        (i128::from(ticks) - i128::from(first)) as f64 / self.tick_hz.max(1) as f64
    }
}
