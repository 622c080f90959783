//! The command line of `jmanager`.

use std::path::PathBuf;

use bica_player_program::game::FirmwareImage;
use bica_sim::setup::Frame;
use clap::{Parser, Subcommand};

use bica_monitor::cli::Arguments;

const AFTER: &str = "\
Examples:
  jmanager                          the built-in forward, in real time
  jmanager --world mujoco           in MuJoCo (needs a build with the feature `mujoco`)
  jmanager tcp://192.168.1.20:7400  a robot, or `player play --serve`
  jmanager tcp://127.0.0.1:7400..7405  all players of a match, `player play --world team --serve`
  jmanager serial:/dev/ttyUSB0      a microcontroller
  jmanager run.mcap                 a recording
  jmanager good.mcap bad.mcap       two recordings, side by side
  jmanager tcp://nao:7400 --record day1.mcap  a robot, with all that it sends in a file
  jmanager --source . --build       the state machines of this folder can be edited, built and run
  jmanager vicode check FILE.rs     reads and edits state machines without a page

The program prints a URL that works once, and opens it if there is a desktop. More robots and recordings can be
opened on the page. Ctrl-C ends the program.

Exit codes: 0 ended with Ctrl-C, 2 wrong arguments or files.";

/// Arguments of the program.
#[derive(Debug, Parser)]
#[command(name = "jmanager", version, about = "A web page to inspect, tune, drive, record and replay robots.", after_help = AFTER)]
#[command(args_conflicts_with_subcommands = true, disable_help_subcommand = true)]
pub(crate) struct Cli {
    /// Something else than to serve the page
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
    #[command(flatten)]
    pub(crate) arguments: Arguments,
    /// Number of other robots in the world
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) robots: u64,
    /// Size of the camera images of simulated worlds: 160x120 (always that of the firmware), 320x240 or 640x480
    #[arg(long, value_name = "WxH", default_value = "160x120")]
    pub(crate) size: Frame,
    /// Firmware image for `--world firmware`; `cargo xtask firmware --build` builds it
    #[arg(long, value_name = "FILE", default_value = FirmwareImage::MONITOR)]
    pub(crate) image: PathBuf,
    /// Folder of labelled images, for the colour tuner
    #[arg(long, value_name = "FOLDER")]
    pub(crate) images: Option<PathBuf>,
}

/// Something else than to serve the page.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Reads and edits state machines in their Rust source
    Vicode {
        /// What to do.
        #[command(subcommand)]
        command: bica_vicode::cli::Command,
    },
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(arguments: &str) -> Result<Cli, clap::Error> {
        Cli::try_parse_from(["jmanager"].into_iter().chain(arguments.split_whitespace()))
    }

    #[test]
    fn sources_and_options_are_no_vicode_commands() {
        assert!(parse("").unwrap().command.is_none());
        assert_eq!(parse("run.mcap other.mcap").unwrap().arguments.sources, ["run.mcap", "other.mcap"]);
        for command in [
            "model a.rs --json",
            "apply a.rs --edits - --dry-run",
            "check a.rs",
            "draw a.rs --format dot",
            "new Keeper",
            "diff a.rs b.rs --svg d.svg --exit-code",
            "try a.rs --steps -",
            "coverage a.rs one.mcap two.mcap --summary",
        ] {
            assert!(parse(&format!("vicode {command}")).unwrap().command.is_some(), "{command}");
        }
        assert!(parse("vicode").is_err());
        assert!(
            parse("--seed 3 vicode check a.rs").unwrap().command.is_none(),
            "these are sources, which do not exist"
        );
    }

    #[test]
    fn every_command_of_the_documentation_is_accepted() {
        let texts = [include_str!("../../../docs/jmanager.md"), include_str!("../../../docs/vicode.md")];
        let shown = texts.iter().flat_map(|text| text.lines()).filter_map(|line| line.strip_prefix("$ jmanager"));
        let commands: Vec<_> = shown.map(|line| line.split('#').next().unwrap_or_default()).collect();
        assert!(commands.len() >= 5);
        for command in commands {
            let parsed = Cli::try_parse_from(["jmanager"].into_iter().chain(command.split_whitespace()));
            assert!(parsed.is_ok(), "jmanager{command}: {parsed:?}");
        }
    }
}
