//! Robots as ROS 2 nodes, seen by two other implementations of DDS: Fast DDS with rclpy, and Cyclone DDS.

use crate::build;
use crate::install::{folder, python};
use crate::process::run;

/// A real ROS 2, as its packages are published on `PyPI`, with the messages that are received.
const FAST: [&str; 9] = [
    "ros-rclpy[fastrtps]==9.1.*",
    "ros-sensor-msgs",
    "ros-nav-msgs",
    "ros-geometry-msgs",
    "ros-visualization-msgs",
    "ros-diagnostic-msgs",
    "ros-rosgraph-msgs",
    "ros-std-srvs",
    "pytest",
];
/// Another DDS with the types of ROS, and the reader of bags.
const CYCLONE: [&str; 4] = ["cyclonedds==11.0.*", "ros2-pyterfaces[cyclone]==0.3.*", "rosbags==0.11.*", "pytest"];
/// Number of messages that are compared with the link's: in CI, and all.
const MESSAGES: [&str; 2] = ["500", "10000"];

/// Installs the two environments; returns their interpreters.
///
/// # Errors
/// If an installation fails.
pub(crate) fn install() -> Result<[String; 2], String> {
    let venv = |name: &str| folder("ros").join(name).to_string_lossy().into_owned();
    Ok([
        python(&venv("fast"), "rclpy, pytest, std_srvs.srv", &FAST)?,
        python(&venv("cyclone"), "cyclonedds, ros2_pyterfaces.cyclone.all_msgs, rosbags, pytest", &CYCLONE)?,
    ])
}

/// Runs the tests: of the wall follower and, if `all`, of the forward and with more messages.
///
/// # Errors
/// If an installation or a test fails.
pub(crate) fn check(all: bool) -> Result<(), String> {
    build::programs()?;
    if all {
        run("cargo", &["build", "--quiet", "--release", "--features", "ros"], &[])?;
    }
    let [fast, cyclone] = install()?;
    let path = |name: &str| folder(name).to_string_lossy().into_owned();
    let (walls, program, here) = (build::program("examples/wall_follower"), path("release/player"), path("ros"));
    let mut variables =
        vec![("BICA_WALL_FOLLOWER", &*walls), ("BICA_FOLDER", &here), ("BICA_MESSAGES", MESSAGES[usize::from(all)])];
    if all {
        variables.push(("BICA_PROGRAM", &program));
    }
    for (python, test) in [(&fast, "rclpy"), (&cyclone, "cyclone")] {
        let test = format!("tools/ros/tests/test_{test}.py");
        run(python, &["-m", "pytest", "--quiet", "-p", "no:cacheprovider", &test], &variables)?;
    }
    Ok(())
}
