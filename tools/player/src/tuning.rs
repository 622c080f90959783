//! Layers of parameters of the command line.

use bica_console::Failure;
use bica_game::GRAPH;
use bica_tuning::Layers;

use crate::cli::TuningArgs;
use crate::colour_profile;

/// Reads the tune file of a kind of robot, a colour profile and the tune file of one robot, and adds the assignments.
pub(crate) fn layers(kind: &str, args: &TuningArgs) -> Result<Layers, Failure> {
    let mut layers = Layers::new(&GRAPH);
    let of_kind = args.tune.join(format!("{kind}.toml"));
    if of_kind.exists() {
        layers.read(&of_kind)?;
    }
    if let Some(profile) = &args.profile {
        colour_profile::assign(&mut layers, profile)?;
    }
    if let Some(robot) = &args.robot {
        layers.read(&args.tune.join(format!("{robot}.toml")))?;
    }
    for assignment in &args.set {
        layers.assign(assignment, "--set")?;
    }
    Ok(layers)
}
