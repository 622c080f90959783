//! The command line.

use std::path::PathBuf;

use bica_evaluation::detection;
#[cfg(feature = "mujoco")]
use bica_evaluation::trial::Kind;
use bica_sim::setup::{Frame, MAX_ROBOTS};
#[cfg(feature = "mujoco")]
use clap::builder::PossibleValue;
use clap::{Args, Parser, Subcommand, ValueEnum};

const AFTER: &str = "\
Examples:
  player                                one game, told as it goes
  player --seed 7 --realtime            another game, at the speed of a clock
  player --world mujoco                 a game in which the robot can topple
  player --pictures album               the same, with a picture of every change of the tree
  player --film game.gif                the same as a film
  player play --games 100               many games on all cores, and a table
  player graph --format svg > tree.svg  the activation tree, drawn
  player watch frames --pictures seen   what the eyes see in recorded images
  player see frames --json              the same, one line of JSON for each image

Exit codes: 0 a goal (or what was asked is done), 1 no goal, 2 wrong arguments or files, 130 stopped by Ctrl-C.
Colours are left out if NO_COLOR is set or the output is no terminal.";

const ABOUT: &str = "\
A NAO that plays forward on the field of RoboCup 2009: finds the ball in its camera
images, walks to it, looks for the goal, lines up, kicks.

Without a command it plays one game in the built-in world. Every behaviour is a
component of an activation tree; the program tells how the tree changes, and measures
what each component costs.";

/// What the command line says.
#[derive(Debug, Parser)]
#[command(name = "player", version, about = ABOUT, after_help = AFTER, args_conflicts_with_subcommands = true)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
    #[command(flatten)]
    pub(crate) play: Play,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Play in the built-in world (this is what `player` alone does)
    Play(Play),
    /// Print the activation tree: its components, rates, links, states and transitions
    Graph(GraphArgs),
    #[cfg(feature = "mujoco")]
    #[command(
        about = "Try the body in MuJoCo: walking, pushes, odometry, kicks, getting up; print tables of what was reached"
    )]
    Trial(Trial),
    /// Look at a folder of camera images with the forward's eyes, and sum up
    Watch(Watch),
    /// Look at a folder of camera images: one line for each, as JSON if you like; or compare with labels
    See(See),
    /// Learn colour classes from labelled images, and write them as a profile
    Calibrate(Calibrate),
}

#[derive(Clone, Debug, Args)]
pub(crate) struct Play {
    /// Where the forward plays: `built-in`; `mujoco`, where forces are real (needs the feature `mujoco`); or `firmware`, the
    /// built-in world, where an emulated microcontroller thinks in its place
    #[arg(long, value_name = "WORLD", default_value = "built-in")]
    pub(crate) world: World,
    /// The image that the microcontroller runs; `cargo xtask firmware --build` makes it
    #[arg(long, value_name = "FILE", default_value = "firmware/target/thumbv7em-none-eabihf/release/forward-an500")]
    pub(crate) image: PathBuf,
    /// Decides where robot and ball start, the light, the noise: the same seed gives the same game, bit for bit
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) seed: u64,
    /// Play as fast as a clock instead of as fast as possible
    #[arg(long)]
    pub(crate) realtime: bool,
    /// Put N more robots in the way, besides the goalkeeper
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = robots)]
    pub(crate) robots: usize,
    /// The size of the camera images: 160x120 (all that the firmware takes, and its default), 320x240 or 640x480
    #[arg(long, value_name = "WxH", default_value_if("world", "firmware", "160x120"), default_value = "320x240", value_parser = size)]
    pub(crate) size: Frame,
    /// End a game without a goal after this time in the world
    #[arg(long, value_name = "S", default_value_t = 120.0, value_parser = seconds)]
    pub(crate) seconds: f64,
    /// Write a picture (PNG) at every change of the tree; several games get a folder each
    #[arg(long, value_name = "DIR")]
    pub(crate) pictures: Option<PathBuf>,
    /// Film the game: an animated picture (GIF) from outside, with the robot's own view beside it
    #[arg(long, value_name = "FILE", conflicts_with = "games")]
    pub(crate) film: Option<PathBuf>,
    /// Play N games, with the seeds from --seed on, and print a table
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) games: Option<u32>,
    /// Play this many games at once [default: one for each core]; the results are the same for any number
    #[arg(long, value_name = "N", requires = "games", value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub(crate) threads: Option<u32>,
    /// Exit with 0 if at least this many games ended in a goal [default: all]
    #[arg(long, value_name = "N", requires = "games")]
    pub(crate) at_least: Option<u32>,
    /// Print the results as JSON on stdout and nothing else there; what is said to people goes to stderr
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum World {
    BuiltIn,
    Mujoco,
    Firmware,
}

#[cfg(feature = "mujoco")]
#[derive(Clone, Debug, Args)]
pub(crate) struct Trial {
    /// What to try [default: everything]
    #[arg(value_name = "NAME")]
    pub(crate) names: Vec<TrialName>,
    /// Try everything with N seeds
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) runs: u32,
    /// The first seed
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) seed: u64,
    /// Try this many at once [default: one for each core]; the results are the same for any number
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub(crate) threads: Option<u32>,
    /// How well the soles grip, 0.05 to 3 [default: 1]
    #[arg(long, value_name = "F")]
    pub(crate) friction: Option<f32>,
    /// A factor on the gain of the legs' motors, 0.1 to 5 [default: 1]
    #[arg(long, value_name = "F")]
    pub(crate) leg_gain: Option<f32>,
    /// The greatest torque of the legs' motors, Nm, 0.5 to 20 [default: 5]
    #[arg(long, value_name = "NM")]
    pub(crate) torque_limit: Option<f32>,
    /// From a command to its first effect, s, 0 to 0.2 [default: 0.03]
    #[arg(long, value_name = "S")]
    pub(crate) dead_time: Option<f32>,
    /// A factor on the noise of the sensors, 0 to 100 [default: 1]
    #[arg(long, value_name = "F")]
    pub(crate) noise: Option<f32>,
    /// Print the tables as JSON on stdout and nothing else there; what is said to people goes to stderr
    #[arg(long)]
    pub(crate) json: bool,
}

/// A trial by its name.
#[cfg(feature = "mujoco")]
#[derive(Clone, Copy, Debug)]
pub(crate) struct TrialName(pub(crate) Kind);

#[cfg(feature = "mujoco")]
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

#[derive(Clone, Debug, Args)]
pub(crate) struct GraphArgs {
    /// What to print: a drawing (svg), a text for Graphviz (dot) or for Markdown (mermaid), or data (json)
    #[arg(long, value_name = "FORMAT", default_value = "svg")]
    pub(crate) format: Format,
    /// The same as --format json
    #[arg(long, conflicts_with = "format")]
    pub(crate) json: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    Svg,
    Dot,
    Mermaid,
    Json,
}

/// What is looked at, and with which eyes.
#[derive(Clone, Debug, Args)]
pub(crate) struct DetectionArgs {
    /// The folder; its images (PNG, JPEG, raw `NAME_WxH.yuyv`) are looked at in the order of their names
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,
    /// Colours: a profile (TOML), a table (.bin), or the name of a profile: built-in, nao2009 or darwin2013
    #[arg(long, value_name = "FILE|NAME", default_value = "nao2009")]
    pub(crate) profile: String,
    /// Camera poses, without which nothing is known of distances [default: `DIR_pose.csv` beside DIR, if it is there]
    #[arg(long, value_name = "CSV")]
    pub(crate) poses: Option<PathBuf>,
    /// The radius of the ball, in millimetres
    #[arg(long, value_name = "MM", default_value_t = 43.0, value_parser = millimetres)]
    pub(crate) ball: f32,
    /// Write each image with what was recognised drawn in
    #[arg(long, value_name = "DIR")]
    pub(crate) pictures: Option<PathBuf>,
    /// Print what was seen as JSON on stdout and nothing else there; what is said to people goes to stderr
    #[arg(long)]
    pub(crate) json: bool,
}

impl DetectionArgs {
    /// What the library takes.
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
    /// Compare with labels, and print how much was right
    #[arg(long, value_name = "CSV")]
    pub(crate) score: Option<PathBuf>,
}

#[derive(Clone, Debug, Args)]
pub(crate) struct Calibrate {
    /// The folder with the images (PNG, JPEG, raw `NAME_WxH.yuyv`)
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,
    /// Rectangles of one class each: file, x0, y0, x1, y1, class; may be given several times
    #[arg(long, value_name = "CSV")]
    pub(crate) rectangles: Vec<PathBuf>,
    /// Labelled balls and goals, as `player see --score` takes them
    #[arg(long, value_name = "CSV")]
    pub(crate) labels: Option<PathBuf>,
    /// The profile, by name or file, that classes without labels are taken from
    #[arg(long, value_name = "FILE|NAME", default_value = "built-in")]
    pub(crate) base: String,
    /// Write the profile (TOML)
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Print what was learned as JSON on stdout and nothing else there; what is said to people goes to stderr
    #[arg(long)]
    pub(crate) json: bool,
}

fn millimetres(text: &str) -> Result<f32, String> {
    let fits = text.parse().ok().filter(|length: &f32| (1.0..=1000.0).contains(length));
    fits.ok_or_else(|| "a radius from 1 to 1000 millimetres is needed".to_owned())
}

fn robots(text: &str) -> Result<usize, String> {
    let fits = text.parse().ok().filter(|&count| count <= MAX_ROBOTS);
    fits.ok_or_else(|| format!("a number from 0 to {MAX_ROBOTS} is needed"))
}

fn size(text: &str) -> Result<Frame, String> {
    let known = text.split_once('x').and_then(|(w, h)| Frame::of_size(w.parse().ok()?, h.parse().ok()?));
    known.ok_or_else(|| "the cameras give 160x120, 320x240 or 640x480".to_owned())
}

fn seconds(text: &str) -> Result<f64, String> {
    let fits = text.parse().ok().filter(|time: &f64| (0.01..=86_400.0).contains(time));
    fits.ok_or_else(|| "a time from 0.01 to 86400 seconds is needed".to_owned())
}
