//! The command line.

use std::net::IpAddr;
use std::path::PathBuf;

use bica_game::FirmwareImage;
use bica_sim::setup::Frame;
use clap::{Parser, Subcommand};

use crate::options::RUN;

const AFTER: &str = "\
Examples:
  jmanager                          the built-in forward, in real time
  jmanager --world mujoco           in MuJoCo (needs a build with the feature `mujoco`)
  jmanager tcp://192.168.1.20:7400  a robot, or `player play --serve`
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
pub struct Cli {
    /// Something else than to serve the page
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Robots (tcp://HOST:PORT, serial:DEVICE or serial:DEVICE@BAUD) and recordings (FILE.mcap); none: the built-in world
    #[arg(value_name = "SOURCE")]
    pub sources: Vec<String>,
    /// World that is simulated in this program
    #[arg(long, value_name = "WORLD", value_parser = ["built-in", "mujoco", "firmware"])]
    pub world: Option<String>,
    /// Seed of the world
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    /// Number of other robots in the world
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub robots: usize,
    /// Size of the camera images of simulated worlds: 160x120 (always that of the firmware), 320x240 or 640x480
    #[arg(long, value_name = "WxH", default_value = "160x120")]
    pub size: Frame,
    /// Firmware image for `--world firmware`; `cargo xtask firmware --build` builds it
    #[arg(long, value_name = "FILE", default_value = FirmwareImage::MONITOR)]
    pub image: PathBuf,
    /// Port of the page; without it 7410, or any other if that is in use
    #[arg(long, value_name = "PORT")]
    pub port: Option<u16>,
    /// Do not open the page in a browser
    #[arg(long)]
    pub no_open: bool,
    /// Let other computers reach the page, at this address of this computer; needs --token-file
    #[arg(long, value_name = "ADDRESS", requires = "token_file")]
    pub listen: Option<IpAddr>,
    /// Name under which other computers reach the page
    #[arg(long, value_name = "NAME", requires = "listen")]
    pub host: Vec<String>,
    /// File with the secret with which the page is entered; made if it does not exist
    #[arg(long, value_name = "FILE")]
    pub token_file: Option<PathBuf>,
    /// Let pages watch only
    #[arg(long)]
    pub read_only: bool,
    /// Record the world or the robot in FILE.mcap from its beginning; what begins again is recorded in FILE-2.mcap and so on
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Folder of recordings
    #[arg(long, value_name = "FOLDER")]
    pub recordings: Option<PathBuf>,
    /// Folder of labelled images, for the colour tuner
    #[arg(long, value_name = "FOLDER")]
    pub images: Option<PathBuf>,
    /// Folder of Rust sources that the page may edit; only without --listen for other computers
    #[arg(long, value_name = "FOLDER")]
    pub source: Option<PathBuf>,
    /// Let the page check, build and run what is in that folder
    #[arg(long, requires = "source")]
    pub build: bool,
    /// What the page builds and runs: options of Cargo, `--`, arguments with {address}, {seed} and {robots}
    #[arg(long, value_name = "PROGRAM", requires = "build", allow_hyphen_values = true, default_value = RUN, hide_default_value = true)]
    pub run: String,
}

/// Something else than to serve the page.
#[derive(Debug, Subcommand)]
pub enum Command {
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
    fn sources_and_options_are_none_of_the_commands_of_vicode() {
        assert!(parse("").unwrap().command.is_none());
        assert_eq!(parse("run.mcap other.mcap").unwrap().sources, ["run.mcap", "other.mcap"]);
        for command in [
            "model a.rs --json",
            "apply a.rs --edits - --dry-run",
            "check a.rs",
            "draw a.rs --format dot",
            "new Keeper",
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
    fn other_computers_need_a_token() {
        assert!(parse("--listen 0.0.0.0").is_err());
        assert!(parse("--host bench.local --token-file t").is_err());
        assert!(parse("--listen 0.0.0.0 --token-file t --host bench.local").is_ok());
    }

    #[test]
    fn building_needs_a_folder_of_sources() {
        assert!(parse("--build").is_err());
        assert!(parse("--source . --run x").is_err());
        let cli = parse("--source . --build").unwrap();
        assert!(cli.build && cli.run.contains("{address}"));
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
