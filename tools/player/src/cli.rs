//! The command line.

use std::ffi::OsStr;
use std::net::Ipv4Addr;
use std::path::PathBuf;

use bica_app::{RecordArgs, ServeArgs, TuningArgs, seconds};
#[cfg(feature = "evaluation")]
use bica_evaluation::{
    calibrate::CalibrationOptions,
    detection::{DetectionOptions, SeeOptions},
    trial_options::TrialOptions,
};
use bica_sim::setup::{Frame, MAX_ROBOTS};
use clap::builder::{EnumValueParser, PossibleValue, TypedValueParser};
use clap::{Arg, Args, Subcommand, ValueEnum};

#[cfg(feature = "evaluation")]
use crate::calibrate_camera::CameraOptions;
use crate::colour_profile::ColourProfile;
#[cfg(feature = "referee")]
use crate::referee::RefereeCommand;

/// Port of a `GameController`'s control packets.
pub(crate) const CONTROL_PORT: u16 = 3838;
/// Port of a `GameController` for status messages.
pub(crate) const RETURN_PORT: u16 = 3939;
/// UDP port of the messages of the team with number 0, by the rules.
pub(crate) const TEAM_PORTS: u16 = 10_000;
/// Device files of a NAO V6, top and bottom camera. Source: rUNSWift 2019 `CameraDefinitions.hpp`.
const DEVICES: &str = "/dev/video-top,/dev/video-bottom";
/// Value of `--referee` without an address.
pub(crate) const ANYBODY: &str = "any";

pub(crate) const AFTER: &str = "\
Examples:
  player                                one game, with a line for each change of the activation tree
  player --seed 7 --realtime            another game, in real time
  player --world mujoco                 a game with rigid-body dynamics, in which the robot can fall
  player --pictures album               the same game, with a picture of each change of the tree (feature `evaluation`)
  player --film game.gif                the same game as a film (feature `evaluation`)
  player play --games 100               a series of games on all cores, with a summary
  player graph --format svg > tree.svg  a drawing of the activation tree
  player --record run.mcap              the same game, recorded
  player replay run.mcap                the code again on what was recorded, compared bit for bit
  player params FaceBall                the parameters of a component
  player --set FaceBall.gain=0.9        the same game with another value of a parameter
  player play --serve 127.0.0.1:7400    a game in real time that monitors can watch and operate
  player link 127.0.0.1:7400 watch      its states, from another terminal
  player watch frames --pictures out    detections in recorded images, with a summary (feature `evaluation`)
  player see frames --json              the same as one line of JSON for each image

Exit codes: 0 a goal (or the command is done), 1 no goal (or no image could be read, or a replay differs),
2 wrong arguments or files, 130 stopped by Ctrl-C, 141 the reader of the output is gone.
Without a terminal, or if NO_COLOR is set, the output has no colours.";

pub(crate) const ABOUT: &str = "\
The forward of RoboCup 2009: a NAO robot that finds the ball in its camera images,
walks to it, looks for the goal, lines up and kicks.

Without a command, the program plays one game in the built-in world. Every behaviour of
the robot is a component of an activation tree. The program prints each change of the
tree, and the cost of each component.";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Play one game or a series (the default command)
    Play(Box<Play>),
    #[cfg(feature = "evaluation")]
    #[command(
        about = "Run trials of the body in MuJoCo: walking, pushes, odometry, kicks, falls; print tables of results"
    )]
    Trial(TrialOptions),
    #[cfg(feature = "evaluation")]
    /// Detect ball, goals, lines and robots in a folder of images; print a table and a summary
    Watch(DetectionOptions),
    #[cfg(feature = "evaluation")]
    /// Detect in a folder of images; print one line for each image, and a score against labels
    See(SeeOptions),
    #[cfg(feature = "evaluation")]
    /// Fit the thresholds of the colour classes to labelled images and write them as a profile
    Calibrate(CalibrationOptions),
    #[cfg(feature = "evaluation")]
    /// Estimate the angles of a NAO's cameras, and the lean of its body, from the field lines in a recording
    CalibrateCamera(CameraOptions),
    #[cfg(feature = "referee")]
    /// Command robots as a small `GameController` does: packets at 2 Hz, states and penalties from the terminal or a script
    Referee(RefereeCommand),
    #[cfg(all(feature = "lola", unix))]
    #[command(name = crate::lola::GUARD, hide = true)]
    Guard {
        #[arg(value_name = "SOCKET")]
        socket: PathBuf,
    },
    #[cfg(feature = "booster")]
    #[command(name = crate::booster::GUARD, hide = true)]
    BoosterGuard {
        #[arg(value_name = "ROBOT")]
        robot: String,
        #[command(flatten)]
        args: BoosterArgs,
    },
    /// A small `GameController`: with the feature `referee` of Cargo
    #[cfg(not(feature = "referee"))]
    #[command(disable_help_flag = true)]
    Referee {
        #[arg(hide = true, trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<std::ffi::OsString>,
    },
    /// Detections in recorded images, calibration, trials in MuJoCo: with the feature `evaluation` of Cargo
    #[cfg(not(feature = "evaluation"))]
    #[command(name = "watch", visible_aliases = ["see", "calibrate", "calibrate-camera", "trial"], disable_help_flag = true)]
    Evaluation {
        #[arg(hide = true, trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<std::ffi::OsString>,
    },
}

#[derive(Clone, Debug, Args)]
pub(crate) struct Play {
    /// World of the game: `built-in` (kinematic), `mujoco` (rigid-body dynamics; needs the feature `mujoco`), `firmware`
    /// (the built-in world, with the forward on an emulated microcontroller), or `league` (the simulation league's server, which
    /// `cargo xtask league` installs; needs `--robot t1` or `--robot k1`), `team` (the built-in world with the robots of two teams in
    /// real time; needs `--teams` and the feature `referee`), or `lola` (a real NAO V6 through its socket, `lola:SOCKET` or
    /// `/tmp/robocup`; needs the feature `lola`), or `booster` (a real T1 or K1 through DDS; needs the feature `booster` and `--robot`)
    #[arg(long, value_name = "WORLD", default_value = "built-in", value_parser = WorldParser)]
    pub(crate) world: WorldArg,
    /// With `--world lola` or `booster`, socket with the camera images
    #[arg(long, value_name = "SOCKET")]
    pub(crate) frames: Option<PathBuf>,
    /// With `--world lola`, read the cameras of the robot: device files of the top and the bottom one
    /// [without a value: /dev/video-top,/dev/video-bottom]
    #[arg(
        long, value_name = "TOP,BOTTOM", num_args = 0..=1, default_missing_value = DEVICES, value_parser = devices,
        conflicts_with = "frames"
    )]
    pub(crate) cameras: Option<[PathBuf; 2]>,
    /// Firmware image for `--world firmware`; `cargo xtask firmware --build` builds the default ones: one for each size, and for
    /// 160x120 one with the server for monitors, which is used with --serve
    #[arg(long, value_name = "FILE")]
    pub(crate) image: Option<PathBuf>,
    /// Seed of start positions, light and noise; the same seed gives the same game, bit for bit
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) seed: u64,
    /// Play in real time instead of as fast as possible
    #[arg(long)]
    pub(crate) realtime: bool,
    /// Number of other robots on the field, besides the goalkeeper
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = robots)]
    pub(crate) robots: usize,
    /// Size of the camera images: 160x120 (the default with `--world firmware`), 320x240 or, not with firmware, 640x480
    #[arg(long, value_name = "WxH", default_value_if("world", "firmware", "160x120"), default_value = "320x240")]
    pub(crate) size: Frame,
    #[arg(long, value_name = "NAME=VALUE", help = crate::game::OPTIONS)]
    pub(crate) option: Vec<String>,
    /// Longest duration of a game, in seconds of the world [default: 120; with `--world lola` or `booster` until the end is requested]
    #[arg(long, value_name = "S", value_parser = seconds, allow_negative_numbers = true)]
    pub(crate) seconds: Option<f64>,
    /// Write a picture (PNG) of every change of the tree; each game of a series has its own folder
    #[arg(long, value_name = "DIR")]
    pub(crate) pictures: Option<PathBuf>,
    /// Write a film (animated GIF): the world from outside and the robot's camera image
    #[arg(long, value_name = "FILE", conflicts_with = "games")]
    pub(crate) film: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) booster: BoosterArgs,
    #[command(flatten)]
    pub(crate) league: LeagueArgs,
    #[command(flatten)]
    pub(crate) referee: RefereeArgs,
    #[command(flatten)]
    pub(crate) record: RecordArgs,
    #[command(flatten)]
    pub(crate) link: ServeArgs,
    /// Play a series of N games with consecutive seeds from --seed on, and print a summary
    #[arg(long, value_name = "N", conflicts_with_all = ["record", "serve"], value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) games: Option<u32>,
    /// Number of threads [default: one for each core]; the results do not depend on it
    #[arg(long, value_name = "N", requires = "games", value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub(crate) threads: Option<u32>,
    /// Number of games with a goal for exit code 0 [default: all]
    #[arg(long, value_name = "N", requires = "games")]
    pub(crate) at_least: Option<u32>,
    #[command(flatten)]
    pub(crate) tuning: TuningArgs<ColourProfile>,
    /// Print the results as JSON on stdout; all other output goes to stderr
    #[arg(long)]
    pub(crate) json: bool,
}

/// Arguments of a run on a real Booster.
#[derive(Clone, Debug, Args)]
pub(crate) struct BoosterArgs {
    /// With `--world booster`, domain of DDS
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=232))]
    pub(crate) dds_domain: u16,
    /// With `--world booster`, name or IPv4 address of the network interface to the robot [default: all]
    #[arg(long, value_name = "NAME|ADDRESS")]
    pub(crate) dds_interface: Option<String>,
    /// With `--world booster`, whose gait walks: `own` by joint commands, or the maker's by requests
    #[arg(long, value_name = "GAIT", default_value = "own")]
    pub(crate) gait: GaitArg,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum GaitArg {
    Own,
    Firmware,
}

/// Arguments of a game in the league's server.
#[derive(Clone, Debug, Args)]
pub(crate) struct LeagueArgs {
    /// With `--world league`, join the game of a running server: HOST:PORT of its players [default: start one]
    #[arg(long, value_name = "ADDR")]
    pub(crate) server: Option<String>,
    /// With `--world league`, name of the team; with --referee, its number, 0 to 254
    #[arg(long, value_name = "NAME", default_value = "BICA")]
    pub(crate) team: String,
    /// With `--world league`, number of the player, 0 to 99
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) number: u32,
    /// With `--world league`, play against a second team: the same forward from the other side
    #[arg(long)]
    pub(crate) against: bool,
}

/// Arguments of a game that a `GameController` commands.
#[derive(Clone, Debug, Args)]
pub(crate) struct RefereeArgs {
    /// Follow a `GameController`, in real time until the end is requested; with an address, only the one there. Needs --team, and the
    /// feature `referee`
    #[arg(
        long, value_name = "ADDRESS", num_args = 0..=1, require_equals = true, default_missing_value = ANYBODY, group = "commanded"
    )]
    pub(crate) referee: Option<String>,
    /// With --referee, number of the player, 1 to 20
    #[arg(long, value_name = "N", default_value_t = 1, requires = "referee")]
    pub(crate) player: u32,
    /// With --referee or --teams, UDP port of the control packets
    #[arg(long, value_name = "PORT", default_value_t = CONTROL_PORT, requires = "commanded")]
    pub(crate) control_port: u16,
    /// With --referee or --teams, UDP port of the `GameController` for status messages
    #[arg(long, value_name = "PORT", default_value_t = RETURN_PORT, requires = "commanded")]
    pub(crate) return_port: u16,
    /// With --referee or --teams, UDP port of the messages of the team with number 0; the other teams have those that follow
    #[arg(long, value_name = "PORT", default_value_t = TEAM_PORTS, requires = "commanded")]
    pub(crate) team_ports: u16,
    /// With --referee or --teams, IPv4 address to which messages to the team are sent
    #[arg(long, value_name = "ADDRESS", default_value = "255.255.255.255", requires = "commanded")]
    pub(crate) broadcast: Ipv4Addr,
    /// With --referee or --teams, use no network but that of the rules: no link and no ROS
    #[arg(long = "match", requires = "commanded")]
    pub(crate) is_match: bool,
    /// With `--world team` or `--world mujoco`, numbers of the two teams of a match; --record then names a folder. Needs the feature
    /// `referee`
    #[arg(long, value_name = "TEAM,TEAM", value_parser = teams, group = "commanded")]
    pub(crate) teams: Option<[u8; 2]>,
    /// With --teams, number of players of each team
    #[arg(long, value_name = "N", default_value_t = 3, requires = "teams", value_parser = clap::value_parser!(u8).range(1..=5))]
    pub(crate) players: u8,
    /// With --teams and --games, the second team stands before its goal
    #[arg(long, requires = "teams")]
    pub(crate) idle: bool,
    /// With --teams and --games, number of messages that each team may send
    #[arg(long, value_name = "N", requires_all = ["teams", "games"])]
    pub(crate) budget: Option<u16>,
    /// With --teams, Unix socket to which the world writes the true state, 20 lines of JSON a second
    #[arg(long, value_name = "PATH", requires = "teams")]
    pub(crate) truth: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum World {
    BuiltIn,
    Mujoco,
    Firmware,
    League,
    Team,
    Lola,
    Booster,
}

/// Parses the numbers of two teams.
pub(crate) fn teams(text: &str) -> Result<[u8; 2], String> {
    let numbers = text.split_once(',').map(|(one, other)| [one, other].map(|team| team.trim().parse().ok()));
    match numbers {
        Some([Some(one), Some(other)]) if one != other && one < u8::MAX && other < u8::MAX => Ok([one, other]),
        _ => Err("give two different numbers from 0 to 254, as 5,23".to_owned()),
    }
}

/// World with the socket of a real robot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct WorldArg {
    pub(crate) kind: World,
    /// Path after `lola:`.
    pub(crate) socket: Option<PathBuf>,
}

/// Parser of the name of a world, which may end with a socket.
#[derive(Clone)]
struct WorldParser;

impl TypedValueParser for WorldParser {
    type Value = WorldArg;

    fn parse_ref(&self, command: &clap::Command, arg: Option<&Arg>, value: &OsStr) -> Result<WorldArg, clap::Error> {
        if let Some(path) = value.to_str().and_then(|text| text.strip_prefix("lola:")) {
            return Ok(WorldArg { kind: World::Lola, socket: Some(path.into()) });
        }
        let kind = EnumValueParser::<World>::new().parse_ref(command, arg, value)?;
        Ok(WorldArg { kind, socket: None })
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let values = World::value_variants().iter().filter_map(ValueEnum::to_possible_value);
        Some(Box::new(values))
    }
}

impl Play {
    /// Longest duration of a simulated game, s.
    pub(crate) fn game_seconds(&self) -> f64 {
        self.seconds.unwrap_or(120.0)
    }

    /// Arguments of a run in a world with these options, without a time limit.
    #[cfg(any(feature = "booster", feature = "league", all(feature = "lola", unix), feature = "referee"))]
    pub(crate) fn run_args(&self, world: &str, option: Vec<String>) -> bica_app::RunArgs<ColourProfile> {
        bica_app::RunArgs {
            world: world.to_owned(),
            seed: self.seed,
            option,
            realtime: false,
            seconds: None,
            record: self.record.clone(),
            link: self.link.clone(),
            tuning: self.tuning.clone(),
            log: None,
            json: self.json,
        }
    }
}

/// Parses the device files of two cameras.
fn devices(text: &str) -> Result<[PathBuf; 2], String> {
    match text.split_once(',') {
        Some((top, bottom)) if top != bottom && !top.is_empty() && !bottom.is_empty() => {
            Ok([top.into(), bottom.into()])
        }
        _ => Err(format!("give two different device files, as {DEVICES}")),
    }
}

fn robots(text: &str) -> Result<usize, String> {
    let fits = text.parse().ok().filter(|&count| count <= MAX_ROBOTS);
    fits.ok_or_else(|| format!("give a number from 0 to {MAX_ROBOTS}"))
}
