//! Layers of parameters of the command line.

use std::path::Path;

use bica_console::Failure;
use bica_game::GRAPH;
use bica_tuning::Layers;

use crate::cli::TuningArgs;
use crate::colour_profile;

/// Folder of tune files without --tune.
const FOLDER: &str = "tune";

/// Reads the tune file of a kind of robot, a colour profile and the tune file of one robot, and adds the assignments.
pub(crate) fn layers(kind: &str, args: &TuningArgs) -> Result<Layers, Failure> {
    let mut layers = Layers::new(&GRAPH);
    let folder = args.tune.as_deref().unwrap_or(Path::new(FOLDER));
    let of_kind = folder.join(format!("{kind}.toml"));
    // A folder that was named for nothing is a mistake.
    if of_kind.exists() || (args.tune.is_some() && args.robot.is_none()) {
        layers.read(&of_kind)?;
    }
    if let Some(profile) = &args.profile {
        colour_profile::assign(&mut layers, profile)?;
    }
    if let Some(robot) = &args.robot {
        layers.read(&folder.join(format!("{robot}.toml")))?;
    }
    for assignment in &args.set {
        layers.assign(assignment, "--set")?;
    }
    Ok(layers)
}
