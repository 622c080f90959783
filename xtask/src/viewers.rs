//! Recordings, read by the libraries of MCAP, of bags of ROS 2 and of Rerun, and recordings that MCAP's library has written again.

use std::fs;

use crate::build;
use crate::install::{folder, python};
use crate::process::{output, run};

/// Topics of a recording.
const TOPICS: [&str; 7] =
    ["/bica/blobs", "/bica/sensors", "/bica/command", "/bica/tree", "/bica/tick", "/bica/costs", "/bica/information"];
/// Topics for other programs in a game of the forward, and what is compared there: frames with the pose that follows from them,
/// and the ball in the image with the ball on the ground.
const FORWARD: &str = "/tf /tf_static /rosout /parameter_events /camera/image_raw/compressed /camera/camera_info \
    /forward/states /forward/scenery /forward/scenery/lines/points \
    /forward/ball_detector/ball_in_image /forward/camera_pose/horizon /forward/field_boundary/corners \
    /forward/goal_detector/posts_in_image /forward/ball_detector/ball_position/points \
    /forward/localization/robot_pose /forward/goal_detector/goal_position \
    --compose map base_link Localization/robot_pose \
    --project BallDetector/ball_in_image BallDetector/ball_position 0.0325";
/// The same of the robot that follows walls.
const WALL_FOLLOWER: &str = "/tf /rosout /parameter_events /scan /odom /wall_follower/states /wall_follower/scenery \
    /wall_follower/lidar/scan/points /wall_follower/wall_detector/wall";
/// Number of files that are written again: compressions, with chunks or not, with checksums or not.
const REWRITTEN: usize = 12;
/// Modules of the Python libraries, and the packages that contain them. Rerun's interface for reading is young.
const MODULES: &str = "mcap, lz4, zstandard, mcap_ros2, rosbags, rerun, PIL, pandas";
const PACKAGES: [&str; 8] =
    ["mcap", "lz4", "zstandard", "mcap-ros2-support", "rosbags==0.11.*", "rerun-sdk==0.41.*", "pillow", "pandas"];

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
