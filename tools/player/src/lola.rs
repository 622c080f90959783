//! `play --world lola`: a real NAO V6.

use std::io;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::{Arc, Mutex, PoisonError};

use bica::Tree;
use bica_app::{App, Failure, Outcome, WorldOptions, interrupt};
use bica_field::GoalColour;
use bica_lola::camera::{Origin, Setting, Settings};
use bica_lola::{LolaWorld, Options, PATIENCE, Standing};
use bica_motion::model::simulation::NAO;
use bica_motion::robot::{Buttons, Command, Light};
use bica_player::input::RobotProfile;
use bica_player::perception::GoalDetector;
use bica_player::tunable::Forward;
use bica_recording::{ReplayOptions, ReplayReport};

use crate::attacked::{self, ATTACKS, SKY_BLUE, YELLOW};
use crate::cli::Play;
use crate::colour_profile::ColourProfile;
use crate::lean::{Lean, Upright};

/// Name of the world in recordings and options.
const WORLD: &str = "lola";
/// Path of LoLA's socket on the robot.
const SOCKET: &str = "/tmp/robocup";
/// Name of the option with the lean of the body.
pub(crate) const BODY: &str = "body";
/// Exit code of a program that hangs: that of a panic.
const HUNG: i32 = 101;
/// Command that runs the guard.
pub(crate) const GUARD: &str = "lola-guard";

/// Plays on a real robot as the command line requests.
pub(crate) fn run(args: &Play) -> Result<Outcome, Failure> {
    refuse(args)?;
    interrupt::end_in_order();
    let attacks = attacked_goal(&args.option)?;
    let standing = Arc::<Mutex<Standing>>::default();
    let (limit, shared) = (args.seconds, Arc::clone(&standing));
    let socket = args.world.socket.clone().unwrap_or_else(|| SOCKET.into());
    let (frames, cameras) = (args.frames.clone(), args.cameras.clone());
    let open = move |options: &WorldOptions| {
        options.value(ATTACKS, String::new())?;
        let lean = options.value(BODY, Lean::default())?;
        let images = origin(frames.clone(), cameras.clone(), settings(options)?)?;
        let options = Options {
            socket: socket.clone(),
            images,
            guard: Some(guard_command),
            limit,
            stop: Box::new(interrupt::requested),
            patience: PATIENCE,
            abandon: || process::exit(HUNG),
            say,
            halt: end_motion,
            standing: Arc::clone(&shared),
        };
        let failed = |error: io::Error| Failure::new(error.to_string(), "is there memory left?");
        LolaWorld::open(options).map(|world| Upright { world, lean }).map_err(failed)
    };
    let app = App::<Forward, ColourProfile>::new("player").robot(maker(attacks)).pacing_device(WORLD, open);
    // Without a limit: the world itself ends the run, after the robot has sat down.
    app.play(&args.run_args(WORLD, args.option.clone()))?;
    let Standing { opened, is_low, .. } = *standing.lock().unwrap_or_else(PoisonError::into_inner);
    Ok(if is_low || opened == 0 { Outcome::Success } else { Outcome::Unsuccessful })
}

/// Settings of the cameras by the options of the world.
fn settings(options: &WorldOptions) -> Result<Settings, Failure> {
    let setting = |name| options.value(name, Setting::Auto);
    Ok(Settings { exposure: setting("exposure")?, gain: setting("gain")?, white_balance: setting("white-balance")? })
}

/// Where the images come from.
fn origin(
    frames: Option<PathBuf>,
    cameras: Option<[PathBuf; 2]>,
    settings: Settings,
) -> Result<Option<Origin>, Failure> {
    if cameras.is_none() && settings != Settings::default() {
        let what = "the options exposure, gain and white-balance are settings of cameras, and no cameras are read";
        return Err(Failure::new(what, "give --cameras, too, or leave them out"));
    }
    let cameras = cameras.map(|devices| Origin::Cameras(devices, settings));
    Ok(cameras.or_else(|| frames.map(Origin::Socket)))
}

/// Runs the guard of a socket: `player lola-guard SOCKET`. A run starts this command itself.
pub(crate) fn guard(socket: &Path) -> Result<Outcome, Failure> {
    interrupt::end_in_order();
    let ended = bica_lola::guard(socket.to_owned(), say);
    ended.map(|()| Outcome::Success).map_err(|error| {
        let what = format!("the guard of a real robot cannot relay: {error}");
        Failure::new(what, "leave its start to `player play --world lola`")
    })
}

fn guard_command(socket: &Path) -> process::Command {
    let program = std::env::current_exe().unwrap_or_else(|_| "player".into());
    let mut command = process::Command::new(program);
    command.arg(GUARD).arg(socket);
    command
}

fn say(text: &str) {
    eprintln!("lola: {text}");
}

/// Replays the recording of a game; `None` if the recording is not of this world.
pub(crate) fn replay(options: &ReplayOptions<'_>) -> Option<Result<ReplayReport, Failure>> {
    attacked::replay(options, WORLD, maker)
}

/// Refuses options that a real robot does not support, and paths that cannot be a socket.
fn refuse(args: &Play) -> Result<(), Failure> {
    let simulated = args.pictures.is_some() || args.film.is_some() || args.games.is_some() || args.robots > 0;
    if simulated || args.image.is_some() || args.league.server.is_some() || args.league.against {
        let what = "a real robot has no pictures, films, series, other robots, firmware images and servers";
        return Err(Failure::new(
            what,
            "leave out --pictures, --film, --games, --robots, --image, --server and --against",
        ));
    }
    let sockets = args.world.socket.iter().chain(&args.frames);
    for path in sockets {
        if path.as_os_str().is_empty() {
            return Err(Failure::new(
                "no path follows `lola:`, or --frames is empty",
                "write --world lola:/tmp/robocup",
            ));
        }
        if path.is_file() || path.is_dir() {
            let what = format!("`{}` is no socket", path.display());
            return Err(Failure::new(what, "give the path of LoLA's socket, as in --world lola:/tmp/robocup"));
        }
    }
    let folder = args.world.socket.as_deref().and_then(Path::parent).filter(|folder| !folder.as_os_str().is_empty());
    match folder {
        Some(folder) if !folder.is_dir() => {
            let what = format!("there is no folder `{}` for the socket", folder.display());
            Err(Failure::new(what, "give the path of LoLA's socket, which is /tmp/robocup on the robot"))
        }
        _ => Ok(()),
    }
}

/// Parses the goal in `--option attacks=COLOUR`.
fn attacked_goal(options: &[String]) -> Result<GoalColour, Failure> {
    let colour = options.iter().filter_map(|option| option.split_once('=')).find(|(name, _)| name.trim() == ATTACKS);
    match colour.map(|(_, colour)| colour.trim()) {
        None | Some(YELLOW) => Ok(GoalColour::Yellow),
        Some(SKY_BLUE) => Ok(GoalColour::SkyBlue),
        Some(other) => {
            let what = format!("--option {ATTACKS}={other}: no goal has this colour");
            Err(Failure::new(what, format!("give {YELLOW} or {SKY_BLUE}")))
        }
    }
}

fn maker(attacks: GoalColour) -> fn() -> Box<Forward> {
    match attacks {
        GoalColour::Yellow => || forward(GoalColour::Yellow),
        GoalColour::SkyBlue => || forward(GoalColour::SkyBlue),
    }
}

/// Returns the forward with the motion profile for a body with dynamics.
fn forward(attacks: GoalColour) -> Box<Forward> {
    let mut forward = Box::new(Forward::new());
    forward.get_mut::<RobotProfile>().set(NAO.dynamic_profile);
    forward.get_mut::<GoalDetector>().attack(attacks);
    forward
}

/// Presses the chest button, as a referee does, while its light shows that the robot plays: the robot ends its step and stands.
const fn end_motion(cycle: u32, buttons: &mut Buttons, command: &Command) {
    let Light(red, green, _) = command.lights.chest;
    // A press must follow a release, so every second cycle releases the button.
    buttons.chest = green > red && cycle % 2 == 1;
}

#[cfg(test)]
mod tests {
    use bica_motion::joints::Joints;

    use super::*;

    #[test]
    fn attacked_goal_is_an_option() {
        let attacked = |options: &[&str]| attacked_goal(&options.iter().map(ToString::to_string).collect::<Vec<_>>());
        assert_eq!(attacked(&[]).ok(), Some(GoalColour::Yellow));
        assert_eq!(attacked(&["attacks=sky-blue"]).ok(), Some(GoalColour::SkyBlue));
        assert!(attacked(&["attacks=red"]).is_err());
    }

    #[test]
    fn playing_robot_is_sent_off_once() {
        let mut command = Command::new(Joints::all(0.0), 0.0);
        let mut pressed = |cycle, light| {
            let mut buttons = Buttons { chest: true, ..Buttons::default() };
            command.lights.chest = light;
            end_motion(cycle, &mut buttons, &command);
            buttons.chest
        };
        let (red, green) = (Light(1.0, 0.0, 0.0), Light(0.0, 1.0, 0.0));
        assert_eq!(
            [pressed(0, green), pressed(1, green), pressed(2, red), pressed(3, red)],
            [false, true, false, false]
        );
    }
}
