//! The command line.

use std::path::PathBuf;

use bica_app::{RecordArgs, ServeArgs, TuningArgs, seconds};
use bica_evaluation::detection;
use bica_evaluation::trial_kind::Kind;
use bica_sim::setup::{Frame, MAX_ROBOTS};
use clap::builder::PossibleValue;
use clap::{Args, Subcommand, ValueEnum};

use crate::colour_profile::ColourProfile;

pub(crate) const AFTER: &str = "\
Examples:
  player                                one game, with a line for each change of the activation tree
  player --seed 7 --realtime            another game, in real time
  player --world mujoco                 a game with rigid-body dynamics, in which the robot can fall
  player --pictures album               the same game, with a picture of each change of the tree
  player --film game.gif                the same game as a film
  player play --games 100               a series of games on all cores, with a summary
  player graph --format svg > tree.svg  a drawing of the activation tree
  player --record run.mcap              the same game, recorded
  player replay run.mcap                the code again on what was recorded, compared bit for bit
  player params FaceBall                the parameters of a component
  player --set FaceBall.gain=0.9        the same game with another value of a parameter
  player play --serve 127.0.0.1:7400    a game in real time that monitors can watch and operate
  player link 127.0.0.1:7400 watch      its states, from another terminal
  player watch frames --pictures out    detections in recorded images, with a summary
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
    Play(Play),
    #[command(
        about = "Run trials of the body in MuJoCo: walking, pushes, odometry, kicks, falls; print tables of results"
    )]
    Trial(Trial),
    /// Detect ball, goals, lines and robots in a folder of images; print a table and a summary
    Watch(Watch),
    /// Detect in a folder of images; print one line for each image, and a score against labels
    See(See),
    /// Fit the thresholds of the colour classes to labelled images and write them as a profile
    Calibrate(Calibrate),
}

#[derive(Clone, Debug, Args)]
pub(crate) struct Play {
    /// World of the game: `built-in` (kinematic), `mujoco` (rigid-body dynamics; needs the feature `mujoco`), or `firmware`
    /// (the built-in world, with the forward on an emulated microcontroller)
    #[arg(long, value_name = "WORLD", default_value = "built-in")]
    pub(crate) world: World,
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
    /// Longest duration of a game, in simulated seconds
    #[arg(long, value_name = "S", default_value_t = 120.0, value_parser = seconds, allow_negative_numbers = true)]
    pub(crate) seconds: f64,
    /// Write a picture (PNG) of every change of the tree; each game of a series has its own folder
    #[arg(long, value_name = "DIR")]
    pub(crate) pictures: Option<PathBuf>,
    /// Write a film (animated GIF): the world from outside and the robot's camera image
    #[arg(long, value_name = "FILE", conflicts_with = "games")]
    pub(crate) film: Option<PathBuf>,
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

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum World {
    BuiltIn,
    Mujoco,
    Firmware,
}

#[derive(Clone, Debug, Args)]
pub(crate) struct Trial {
    /// Trials to run [default: all]
    #[arg(value_name = "NAME")]
    pub(crate) names: Vec<TrialName>,
    /// Number of seeds of each trial
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) runs: u32,
    /// First seed
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) seed: u64,
    /// Number of threads [default: one for each core]; the results do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub(crate) threads: Option<u32>,
    /// Friction coefficient of the soles, 0.05 to 3 [default: 1]
    #[arg(long, value_name = "F")]
    pub(crate) friction: Option<f32>,
    /// Factor on the position gain of the leg motors, 0.1 to 5 [default: 1]
    #[arg(long, value_name = "F")]
    pub(crate) leg_gain: Option<f32>,
    /// Largest torque of the leg motors, Nm, 0.5 to 20 [default: 5]
    #[arg(long, value_name = "NM")]
    pub(crate) torque_limit: Option<f32>,
    /// Time from a command to its first effect, s, 0 to 0.2 [default: 0.03]
    #[arg(long, value_name = "S")]
    pub(crate) dead_time: Option<f32>,
    /// Factor on the noise of the sensors, 0 to 100 [default: 1]
    #[arg(long, value_name = "F")]
    pub(crate) noise: Option<f32>,
    /// Print the tables as JSON on stdout; all other output goes to stderr
    #[arg(long)]
    pub(crate) json: bool,
}

/// Name of a trial.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TrialName(pub(crate) Kind);

impl ValueEnum for TrialName {
    fn value_variants<'a>() -> &'a [Self] {
        const NAMES: [TrialName; Kind::ALL.len()] = {
            let mut names = [TrialName(Kind::Walk); Kind::ALL.len()];
            let mut index = 0;
            while index < names.len() {
                names[index] = TrialName(Kind::ALL[index]);
                index += 1;
            }
            names
        };
        &NAMES
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.0.name()).help(self.0.about()))
    }
}

/// Images and parameters of the detectors.
#[derive(Clone, Debug, Args)]
pub(crate) struct DetectionArgs {
    /// Folder with images (PNG, JPEG, raw `NAME_WxH.yuyv`), processed in the order of their names
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,
    /// Colour profile: built-in, nao2009 or darwin2013; or a file: a profile (TOML) or a table (.bin)
    #[arg(long, value_name = "FILE|NAME", default_value = "nao2009")]
    pub(crate) profile: String,
    /// Camera poses, needed for distances [default: `DIR_pose.csv` beside DIR, if it exists]
    #[arg(long, value_name = "CSV")]
    pub(crate) poses: Option<PathBuf>,
    /// Radius of the ball, mm
    #[arg(long, value_name = "MM", default_value_t = 43.0, value_parser = millimetres)]
    pub(crate) ball: f32,
    /// Write each image with its detections drawn in
    #[arg(long, value_name = "DIR")]
    pub(crate) pictures: Option<PathBuf>,
    /// Print the detections as JSON on stdout; all other output goes to stderr
    #[arg(long)]
    pub(crate) json: bool,
}

impl DetectionArgs {
    /// Returns the options of the library.
    pub(crate) fn options(&self) -> detection::DetectionOptions {
        let Self { folder, profile, poses, pictures, .. } = self.clone();
        detection::DetectionOptions { folder, profile, poses, radius: 1e-3 * self.ball, pictures }
    }
}

#[derive(Clone, Debug, Args)]
pub(crate) struct Watch {
    #[command(flatten)]
    pub(crate) detection: DetectionArgs,
}

#[derive(Clone, Debug, Args)]
pub(crate) struct See {
    #[command(flatten)]
    pub(crate) detection: DetectionArgs,
    /// Labels; print a score of the detections against them
    #[arg(long, value_name = "CSV")]
    pub(crate) score: Option<PathBuf>,
}

#[derive(Clone, Debug, Args)]
pub(crate) struct Calibrate {
    /// Folder with images (PNG, JPEG, raw `NAME_WxH.yuyv`)
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,
    /// Rectangles of one class each, with the columns file, x0, y0, x1, y1, class; may be repeated
    #[arg(long, value_name = "CSV")]
    pub(crate) rectangles: Vec<PathBuf>,
    /// Labelled balls and goals, as for `player see --score`
    #[arg(long, value_name = "CSV")]
    pub(crate) labels: Option<PathBuf>,
    /// Profile, by name or file, whose classes are kept where there are no labels
    #[arg(long, value_name = "FILE|NAME", default_value = "built-in")]
    pub(crate) base: String,
    /// File to write the profile to (TOML)
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Print the result as JSON on stdout; all other output goes to stderr
    #[arg(long)]
    pub(crate) json: bool,
}

fn millimetres(text: &str) -> Result<f32, String> {
    let fits = text.parse().ok().filter(|length: &f32| (1.0..=1000.0).contains(length));
    fits.ok_or_else(|| "give a radius from 1 to 1000 millimetres".to_owned())
}

fn robots(text: &str) -> Result<usize, String> {
    let fits = text.parse().ok().filter(|&count| count <= MAX_ROBOTS);
    fits.ok_or_else(|| format!("give a number from 0 to {MAX_ROBOTS}"))
}
