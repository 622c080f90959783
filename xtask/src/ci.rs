//! All checks of CI, in its order: checks that are fast and fail often come first.

use std::time::Instant;

use crate::cli::{Budget, Firmware, Viewers};
use crate::process::run;
use crate::{browser, deny, firmware, instructions, miri, mujoco, no_std, peers, publish, slow_tests, viewers};

type Step = (&'static str, fn() -> Result<(), String>);

const STEPS: [Step; 15] = [
    ("format", format),
    ("lints", || run("cargo", &["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"], &[])),
    ("docs", || run("cargo", &["doc", "--workspace", "--no-deps"], &[("RUSTDOCFLAGS", "-D warnings")])),
    ("tests", tests),
    ("publish", publish::check),
    ("deny", deny::check),
    ("peers", peers::check),
    ("games", games),
    ("viewers", || viewers::check(&Viewers::default(), features())),
    ("miri", miri::check_if_installable),
    ("budget", || instructions::check(&Budget::default())),
    ("mujoco", mujoco::check),
    ("no_std", no_std::check),
    ("firmware", || firmware::check(&Firmware::default())),
    // After the firmware, whose image one of the stories plays.
    ("browser", || browser::test(false)),
];

/// Checks the format of all workspaces but that of `peers`, which its own step checks.
fn format() -> Result<(), String> {
    run("cargo", &["fmt", "--all", "--check"], &[])?;
    run("cargo", &["fmt", "--all", "--check", browser::MANIFEST[0], browser::MANIFEST[1]], &[])
}

/// Runs all tests but those that need what a clone does not have, or an idle machine.
fn tests() -> Result<(), String> {
    // More random cases where a few hundred take seconds, and the same ones on each run: the result of CI is a property of the commit.
    let cases = [("BICA_TEST_CASES", "1000"), ("PROPTEST_CASES", "256"), ("PROPTEST_RNG_SEED", "1")];
    run("cargo", &["test", "--workspace"], &cases)?;
    slow_tests::run(&cases)
}

/// Features of the program: `mujoco` where that can be installed. The step `mujoco` needs it too, and so the program is built once.
fn features() -> &'static [&'static str] {
    with_mujoco(&["--features", "mujoco"])
}

/// Returns `features` where MuJoCo can be installed, else none.
pub(crate) fn with_mujoco<'a>(features: &'a [&'a str]) -> &'a [&'a str] {
    if mujoco::install().is_ok() { features } else { &[] }
}

/// Plays games in the built-in world.
fn games() -> Result<(), String> {
    let play = ["--", "play", "--games", "20", "--at-least", "19"];
    run("cargo", &[&["run", "--release"], features(), &play].concat(), &[])
}

/// Runs all steps and prints the time of each.
///
/// # Errors
/// If a check fails; later steps do not run.
pub(crate) fn check() -> Result<(), String> {
    let mut times = Vec::new();
    let result = STEPS.into_iter().try_for_each(|(name, step)| {
        let began = Instant::now();
        let result = step();
        times.push((name, began.elapsed().as_secs()));
        result.map_err(|error| format!("step `{name}`: {error}"))
    });
    eprintln!("xtask: wall-clock time of each step");
    for (name, seconds) in times {
        eprintln!("{name:10} {:3} min {:2} s", seconds / 60, seconds % 60);
    }
    result
}
