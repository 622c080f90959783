//! Stand-ins for real robots: a NAO V6 behind LoLA's socket, and a Booster T1 and K1 behind their topics.

use std::fs;

use crate::build;
use crate::install::{folder, python};
use crate::process::run;

/// What the stand-ins need: a DDS for the Booster, dynamics, and another encoder of a NAO's maps.
const PACKAGES: [&str; 4] = ["cyclonedds==11.0.*", "msgpack==1.2.*", "mujoco==3.17.0", "numpy"];

/// Runs of the program with the stand-in of a NAO: in step, then in real time.
const NAOS: [&[&str]; 2] = [
    &["--seconds", "25", "--fault", "nan@4", "--fault", "short@5", "--fault", "long@6", "--fault", "malformed@7"],
    &["--seconds", "17", "--realtime", "--fault", "missing@4", "--fault", "restart@5"],
];

/// Socket of the images for a Booster's program.
const FRAMES: &str = "target/robot/frames";

/// Runs of the program with a Booster's stand-in: robot, domain of DDS, and the options of both.
const BOOSTERS: [(&str, &str, &[&str], &[&str]); 4] = [
    (
        "t1",
        "61",
        &["--seconds", "25", "--fault", "refuse@2", "--fault", "nan@3", "--fault", "deaf@5", "--fault", "leave@7"],
        &[],
    ),
    ("k1", "62", &["--seconds", "25", "--fault", "count@3", "--fault", "gap@4", "--fault", "silence@5"], &[]),
    (
        "k1",
        "63",
        &["--seconds", "20", "--fault", "fall@10", "--frames", FRAMES],
        &["--gait", "firmware", "--frames", FRAMES],
    ),
    ("t1", "64", &["--seconds", "12", "--kill"], &[]),
];

/// Installs the packages of the stand-ins, with pip; returns the interpreter of their environment.
///
/// # Errors
/// If an installation fails.
pub(crate) fn install() -> Result<String, String> {
    let venv = folder("robot").to_string_lossy().into_owned();
    python(&venv, "cyclonedds, msgpack, mujoco, numpy", &PACKAGES)
}

/// Runs the program with each stand-in, which checks what it gets, and compares the messages with those of Cyclone DDS and of msgpack.
///
/// # Errors
/// If an installation or a run fails.
pub(crate) fn check() -> Result<(), String> {
    build::programs()?;
    let python = install()?;
    let program = build::program("player");
    NAOS.iter().try_for_each(|arguments| nao(&python, &program, arguments))?;
    build::cargo("test", &["--test", "robot", "peer_"], &[("BICA_PEERS", &python)])?;
    for (robot, domain, arguments, options) in BOOSTERS {
        let stand_in = ["robots/booster/stand_in.py", robot, "--domain", domain];
        let player = ["--player", &program, "play", "--world", "booster", "--robot", robot, "--dds-domain", domain];
        let interface = ["--dds-interface", "127.0.0.1"];
        run(&python, &[&stand_in[..], arguments, &player, &interface, options].concat(), &[])?;
    }
    Ok(())
}

/// The NAO's run ends by its chest button, so that the program lets it sit down.
fn nao(python: &str, program: &str, arguments: &[&str]) -> Result<(), String> {
    let sockets = std::env::temp_dir().join(format!("bica-robot-{}", std::process::id()));
    fs::create_dir_all(&sockets).map_err(|error| format!("no folder for the sockets: {error}"))?;
    let path = |name: &str| sockets.join(name).to_string_lossy().into_owned();
    let (socket, frames) = (path("robocup"), path("frames"));
    let stand_in = ["robots/lola/stand_in.py", &socket, "--frames", &frames, "--fault", "chest@9"];
    let world = format!("lola:{socket}");
    let player = ["--player", program, "play", "--world", &world, "--frames", &frames];
    let ran = run(python, &[&stand_in[..], arguments, &player].concat(), &[]);
    _ = fs::remove_dir_all(&sockets);
    ran
}
