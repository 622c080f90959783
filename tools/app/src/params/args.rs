//! Arguments of `params`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::{Layer, TuningArgs};

#[derive(Clone, Debug, Args)]
pub(crate) struct Params<L: Layer> {
    /// Components to list [default: all]
    #[arg(value_name = "COMPONENT")]
    pub(super) components: Vec<String>,
    /// Kind of robot whose tune file `KIND.toml` is read: a world, or a name [default: the first world]
    #[arg(long, value_name = "KIND")]
    pub(super) kind: Option<String>,
    #[command(flatten)]
    pub(super) tuning: TuningArgs<L>,
    /// List parameters only whose values are not the defaults
    #[arg(long)]
    pub(super) changed: bool,
    /// Format: a table, a tune file (toml) or data (json)
    #[arg(long, value_name = "FORMAT", default_value = "table")]
    pub(super) format: ParamsFormat,
    /// Short for --format json
    #[arg(long, conflicts_with = "format")]
    pub(super) json: bool,
    /// Write all values that are not the defaults to a tune file
    #[arg(long, value_name = "FILE", conflicts_with_all = ["components", "format", "json", "changed"])]
    pub(super) write: Option<PathBuf>,
    /// Replace the file of --write if it exists
    #[arg(long, requires = "write")]
    pub(super) force: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum ParamsFormat {
    Table,
    Toml,
    Json,
}
