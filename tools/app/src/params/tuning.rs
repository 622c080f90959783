//! Layers of parameters on the command line.

use std::fmt;
use std::path::{Path, PathBuf};

use bica::Graph;
use bica_tuning::Layers;
use clap::Args;
use serde::Serialize;

use crate::console::{Console, Failure};

/// Folder of tune files without `--tune`.
const FOLDER: &str = "tune";
/// Number of values of one source that a line shows.
const SHOWN: usize = 3;

/// Arguments of a program's own layer of parameters, between the tune file of the world and that of the robot. `()` adds none.
pub trait Layer: Args + Clone + fmt::Debug + Send + 'static {
    /// Adds the values of the layer.
    ///
    /// # Errors
    /// If the values cannot be read or are refused.
    fn assign(&self, layers: &mut Layers) -> Result<(), Failure>;
}

impl Layer for () {
    fn assign(&self, _layers: &mut Layers) -> Result<(), Failure> {
        Ok(())
    }
}

/// Source of parameter values that are in force (a tune file, a profile, or `--set`), with the values.
#[derive(Clone, Debug, Serialize)]
pub struct InForce {
    source: String,
    /// Assignments `Component.name=value`.
    values: Vec<String>,
}

/// Returns the sources of the parameters of a run.
#[must_use]
pub fn in_force(layers: &Layers) -> Vec<InForce> {
    layers.in_force().into_iter().map(|(source, values)| InForce { source, values }).collect()
}

/// Prints the sources of the parameters of a run, one line for each.
///
/// # Errors
/// If stdout cannot be written.
pub fn print_in_force(console: Console, layers: &[InForce]) -> Result<(), Failure> {
    for InForce { source, values } in layers {
        let (few, more) = values.split_at(values.len().min(SHOWN));
        let more = if more.is_empty() { String::new() } else { format!(" and {} more", more.len()) };
        console.print_row("parameters", &format!("{source}: {}{more}", few.join(", ")))?;
    }
    Ok(())
}

/// Arguments that select the values of parameters.
#[derive(Clone, Debug, Args)]
pub struct TuningArgs<L: Layer = ()> {
    /// Tune file, or a folder of tune files: `DIR/WORLD.toml`, and with --robot `DIR/NAME.toml` [default: the folder tune, if it
    /// exists]
    #[arg(long, value_name = "PATH")]
    tune: Option<PathBuf>,
    #[command(flatten)]
    layer: L,
    /// Name of the robot, for its tune file
    #[arg(long, value_name = "NAME")]
    robot: Option<String>,
    /// Set a parameter over all tune files; may be repeated. The command `params` lists the parameters
    #[arg(long, value_name = "COMPONENT.NAME=VALUE")]
    set: Vec<String>,
    /// Whether the program knows the robot without its tune file.
    #[arg(skip)]
    is_robot_known: bool,
}

impl<L: Layer> TuningArgs<L> {
    /// Reads the tune file of a kind of robot, the program's own layer and the tune file of one robot, and adds the assignments.
    ///
    /// # Errors
    /// If a file cannot be read, or a name or a value is wrong.
    pub fn layers(&self, graph: &'static Graph, kind: &str) -> Result<Layers, Failure> {
        let mut layers = Layers::new(graph);
        let path = self.tune.as_deref().unwrap_or(Path::new(FOLDER));
        if self.tune.is_some() && !path.exists() {
            // The error names the given path, not a file in it.
            layers.read(path)?;
        }
        let (folder, of_kind) = match path.parent().filter(|_| path.is_file()) {
            Some(folder) => (folder, path.to_owned()),
            None => (path, path.join(format!("{kind}.toml"))),
        };
        // A given path that is not used is a mistake.
        if of_kind.exists() || (self.tune.is_some() && self.robot.is_none()) {
            layers.read(&of_kind)?;
        }
        self.layer.assign(&mut layers)?;
        if let Some(robot) = &self.robot {
            let of_robot = folder.join(format!("{robot}.toml"));
            if !self.is_robot_known || of_robot.exists() {
                layers.read(&of_robot)?;
            }
        }
        for assignment in &self.set {
            layers.assign(assignment, "--set")?;
        }
        Ok(layers)
    }

    /// Returns the same arguments for a robot that the program knows: its tune file may be missing.
    #[must_use]
    pub fn of_known_robot(&self) -> Self {
        Self { is_robot_known: true, ..self.clone() }
    }

    /// Name of the robot.
    pub fn robot(&self) -> Option<&str> {
        self.robot.as_deref()
    }
}
