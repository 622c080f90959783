//! Arguments about parameters.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

/// Layers of parameters.
#[derive(Clone, Debug, Args)]
pub(crate) struct TuningArgs {
    /// Folder of tune files: `DIR/WORLD.toml`, and with --robot `DIR/NAME.toml` [default: tune, if it exists]
    #[arg(long, value_name = "DIR")]
    pub(crate) tune: Option<PathBuf>,
    /// Colour profile whose limits are the parameters of `Colours`, over the tune file of the world and below that of the robot:
    /// built-in, nao2009 or darwin2013, or a TOML file
    #[arg(long, value_name = "PROFILE")]
    pub(crate) profile: Option<String>,
    /// Name of the robot, for its tune file
    #[arg(long, value_name = "NAME")]
    pub(crate) robot: Option<String>,
    /// Set a parameter over all tune files; may be repeated. `player params` lists the parameters
    #[arg(long, value_name = "COMPONENT.NAME=VALUE")]
    pub(crate) set: Vec<String>,
}

#[derive(Clone, Debug, Args)]
pub(crate) struct Params {
    /// Components to list [default: all]
    #[arg(value_name = "COMPONENT")]
    pub(crate) components: Vec<String>,
    /// Kind of robot whose tune file `KIND.toml` is read: a world, or a name
    #[arg(long, value_name = "KIND", default_value = "built-in")]
    pub(crate) kind: String,
    #[command(flatten)]
    pub(crate) tuning: TuningArgs,
    /// List parameters only whose values are not the defaults
    #[arg(long)]
    pub(crate) changed: bool,
    /// Format: a table, a tune file (toml) or data (json)
    #[arg(long, value_name = "FORMAT", default_value = "table")]
    pub(crate) format: ParamsFormat,
    /// Short for --format json
    #[arg(long, conflicts_with = "format")]
    pub(crate) json: bool,
    /// Write all values that are not the defaults to a tune file
    #[arg(long, value_name = "FILE", conflicts_with_all = ["components", "format", "json", "changed"])]
    pub(crate) write: Option<PathBuf>,
    /// Replace the file of --write if it exists
    #[arg(long, requires = "write")]
    pub(crate) force: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ParamsFormat {
    Table,
    Toml,
    Json,
}
