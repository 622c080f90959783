//! Recordings, read by the libraries of MCAP, Foxglove and Rerun, and recordings that MCAP's library has written again.

use std::fs;

use crate::build;
use crate::install::{folder, python};
use crate::process::{output, run};

/// Topics of a recording.
const TOPICS: [&str; 7] = ["blobs", "sensors", "command", "tree", "tick", "costs", "information"];
/// Topics for other programs in a game of the forward, and what is compared there: frames with the pose that follows from them,
/// and the ball in the image with the ball on the ground.
const FORWARD: &str = "/tf /camera/image /camera/calibration /states /parameters /log \
    /annotations/BallDetector/ball_in_image /annotations/CameraPose/horizon /annotations/FieldBoundary/corners \
    /annotations/GoalDetector/posts_in_image /scene/BallDetector/ball_position /points/BallDetector/ball_position \
    /scene/Localization/robot_pose /points/Localization/robot_pose /scene/GoalDetector/goal_position \
    /scene/lines /points/lines \
    --compose field robot Localization/robot_pose \
    --project BallDetector/ball_in_image BallDetector/ball_position 0.0325";
/// The same of the robot that follows walls.
const WALL_FOLLOWER: &str = "/tf /states /parameters /log /points/Lidar/scan /scene/WallDetector/wall";
/// Number of files that are written again: compressions, with chunks or not, with checksums or not.
const REWRITTEN: usize = 12;
/// Modules of the Python libraries, and the packages that contain them. Rerun's interface for reading is young.
const MODULES: &str = "mcap, lz4, zstandard, mcap_protobuf, foxglove_schemas_protobuf, rerun, PIL, pandas";
const PACKAGES: [&str; 8] = [
    "mcap",
    "lz4",
    "zstandard",
    "mcap-protobuf-support",
    "foxglove-schemas-protobuf==0.4.*",
    "rerun-sdk==0.41.*",
    "pillow",
    "pandas",
];

/// Records two robots and reads the files; replays what MCAP's library makes of the first one.
///
/// # Errors
/// If an installation fails or a file cannot be read.
pub(crate) fn check() -> Result<(), String> {
    let folder = folder("viewers");
    fs::create_dir_all(&folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    let path = |name: &str| folder.join(name).to_string_lossy().into_owned();
    let (game, walls) = (path("run.mcap"), path("walls.mcap"));
    let program = [&["run", "--release", "--quiet"], build::release(), &["--"]].concat();
    let play = ["play", "--seed", "1", "--size", "160x120", "--force", "--record", &game];
    output("cargo", &[&program[..], &play].concat(), &[])?;
    build::programs()?;
    output(&build::program("examples/wall_follower"), &["run", "--force", "--record", &walls], &[])?;
    let reader = install()?;
    run(&reader, &[&["tools/recording/tests/read_mcap.py", &game][..], &TOPICS].concat(), &[])?;
    for (file, words) in [(&game, FORWARD), (&walls, WALL_FOLLOWER)] {
        let words: Vec<_> = words.split_ascii_whitespace().collect();
        let script = ["tools/recording/tests/read_topics.py", file];
        run(&reader, &[&script[..], &words].concat(), &[("PYTHONPATH", "python")])?;
    }
    let written = output(&reader, &["tools/recording/tests/rewrite_mcap.py", &game, &path("")], &[])?;
    replay_all(&written, &program)
}

/// Replays files that another program wrote: equal, or refused if their chunks have a compression that ours cannot read.
fn replay_all(files: &str, program: &[&str]) -> Result<(), String> {
    for file in files.lines() {
        let replayed = output("cargo", &[program, &["replay", file]].concat(), &[]);
        match replayed {
            Err(_) if file.contains("zstd-chunks") => {}
            Ok(_) if file.contains("zstd-chunks") => return Err(format!("`{file}` was not refused")),
            result => _ = result?,
        }
    }
    let count = files.lines().count();
    if count == REWRITTEN { Ok(()) } else { Err(format!("{count} files were written again, not {REWRITTEN}")) }
}

/// Installs the Python libraries; returns the path of the interpreter that has them.
///
/// # Errors
/// If the installation fails.
pub(crate) fn install() -> Result<String, String> {
    python(&folder("viewers/venv").to_string_lossy(), MODULES, &PACKAGES)
}
