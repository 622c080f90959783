//! Recordings of a match: one file for each robot, in a folder.

use std::fs;
use std::path::Path;

use bica::Tree;
use bica_app::{Failure, Images, RecordedFile};
use bica_field::GoalColour;
use bica_player::referee::{Identity, TeamForward};
use bica_recording::{Header, ImagePolicy, Recorder};

use super::entrants::is_dynamic;
use crate::attacked;
use crate::cli::Play;

/// Names of the world, without and with dynamics.
pub(in crate::referee) const WORLD: &str = "team";
pub(in crate::referee) const MUJOCO: &str = "team-mujoco";

/// Recording of a robot.
pub(super) type RobotRecording = (RecordedFile, Recorder);

/// Creates the folder of --record.
///
/// # Errors
/// If it cannot be created, or the recordings would have no sensor values.
pub(super) fn create_folder(args: &Play) -> Result<(), Failure> {
    let Some(folder) = &args.record.record else { return Ok(()) };
    if args.record.images == Images::None {
        let what = "the recording of a match without images has no sensor values, and a match cannot be run again";
        return Err(Failure::new(what, "leave out --images"));
    }
    fs::create_dir_all(folder)
        .map_err(|error| Failure::of_path("create", folder, &error, "name a folder with --record"))
}

/// Starts the recording of a robot, `TEAM-PLAYER.mcap`, in a folder.
///
/// # Errors
/// If the file exists and is not replaced, or cannot be written.
pub(super) fn start(
    args: &Play,
    folder: &Path,
    me: Identity,
    attacks: GoalColour,
    robot: &TeamForward,
) -> Result<RobotRecording, Failure> {
    let options = [attacked::option(attacks)];
    let world = if is_dynamic(args) { MUJOCO } else { WORLD };
    let set_up = [("world", world.into()), ("seed", args.seed.into()), ("options", options[..].into())];
    let set_up = set_up.into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
    let graph = const { &TeamForward::GRAPH };
    let header = Header { topics: args.record.topics(), ..Header::new(graph, set_up, ImagePolicy::All) };
    let path = folder.join(format!("{}-{}.mcap", me.team, me.player));
    // The match goes on slower rather than that a recording misses an image.
    let is_paced = false;
    let (file, recorder) =
        RecordedFile::start(&path, args.record.force, args.record.split, &header.of_robot(robot), is_paced)?;
    Ok((file, recorder.measuring(graph)))
}
