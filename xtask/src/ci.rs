//! All checks of CI, in its order: checks that are fast and fail often come first.

use std::env;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Child, Command};
use std::thread;
use std::time::Instant;

use clap::ValueEnum;

use crate::cli::{Ci, Firmware};
use crate::install::{folder, packages};
use crate::process::{run, works};
use crate::python::SHORT;
use crate::{
    browser, build, deny, figures, firmware, league, miri, mujoco, no_std, peers, publish, python, robot, room, ros,
    slow_tests, spelling, viewers,
};

/// Step of CI, in its order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub(crate) enum Step {
    Format,
    Lints,
    /// References of the crates, and the spelling of all texts
    Docs,
    Tests,
    /// Packages each public crate and builds it from its package
    Publish,
    /// Licences, sources and duplicates of all dependencies
    Deny,
    /// Advisories about dependencies
    Advisories,
    Peers,
    Games,
    /// Reads recordings with the libraries of MCAP, of bags of ROS 2 and of Rerun
    Viewers,
    /// The Python package with a cluster, a database and its notebook
    Python,
    /// The program behind stand-ins for a NAO V6, and a Booster T1 and K1
    Robot,
    /// Robots as ROS 2 nodes, with rclpy and with another DDS
    Ros,
    /// Tests of the framework in Miri, which detects undefined behaviour
    Miri,
    /// Instructions of the benchmarks
    Budget,
    /// Builds of the robot's crates for a Cortex-M, without a heap
    NoStd,
    Mujoco,
    /// Plays in the server of the simulation league
    League,
    /// The image of the forward in QEMU, also watched in JManager's page
    Firmware,
    /// JManager's page in a browser
    Browser,
}

impl Step {
    fn name(self) -> String {
        self.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
    }

    /// Installs the tool that the step needs.
    fn install(self) -> Result<(), String> {
        match self {
            Self::Docs => spelling::install().map(drop),
            Self::Deny => deny::install().map(drop),
            Self::Advisories => deny::fetch_advisories(),
            Self::Viewers => viewers::install().map(drop),
            Self::Python => python::install().map(drop),
            Self::Robot => robot::install().map(drop),
            Self::Ros => ros::install().map(drop),
            Self::Miri => miri::install(),
            Self::Tests if !works("strace", &["--version"]) => packages(&["strace"]),
            Self::Budget if !works("valgrind", &["--version"]) => packages(&["valgrind"]),
            Self::Mujoco => mujoco::install(),
            Self::League => league::install(),
            Self::NoStd => no_std::Toolchain::get().map(drop),
            Self::Firmware => firmware::install_emulator().and_then(|()| browser::install()),
            Self::Browser => browser::install(),
            _ => Ok(()),
        }
    }

    fn check(self) -> Result<(), String> {
        match self {
            Self::Format => format(),
            Self::Lints => lints(),
            Self::Docs => docs(),
            Self::Tests => tests(),
            Self::Publish => publish::check(),
            Self::Deny => deny::check(),
            Self::Advisories => deny::check_advisories(),
            Self::Peers => peers::check(),
            Self::Games => games(),
            Self::Viewers => viewers::check(),
            Self::Python => python::check(&SHORT),
            Self::Robot => robot::check(),
            Self::Ros => ros::check(false),
            Self::Miri => miri::check(),
            Self::Budget => budget(),
            Self::Mujoco => mujoco::check(),
            Self::League => league::check(),
            Self::NoStd => no_std::check(),
            Self::Firmware => firmware::check(&Firmware::default()).and_then(|()| browser::watch_firmware()),
            Self::Browser => browser::test(),
        }
    }
}

/// Checks the format of all workspaces but that of `peers`, which its own step checks.
fn format() -> Result<(), String> {
    run("cargo", &["fmt", "--all", "--check"], &[])?;
    run("cargo", &["fmt", "--all", "--check", browser::MANIFEST[0], browser::MANIFEST[1]], &[])
}

/// Checks the spelling, and builds the references of all crates.
fn docs() -> Result<(), String> {
    spelling::check()?;
    run("cargo", &["doc", "--workspace", "--no-deps"], &[("RUSTDOCFLAGS", "-D warnings")])
}

/// Checks all targets as a user builds them, but with the self-test of the firmware, then with the features of the other steps.
fn lints() -> Result<(), String> {
    let self_test = ["clippy", "--workspace", "--all-targets", "--features", "bica-player-program/self-test"];
    run("cargo", &[&self_test[..], &["--", "-D", "warnings"]].concat(), &[])?;
    build::cargo("clippy", &["--all-targets", "--", "-D", "warnings"], &[])?;
    // The targets of the fuzzer are a workspace of their own, which only `cargo xtask fuzz` builds.
    run(
        "cargo",
        &["check", "--quiet", "--locked", "--manifest-path", "fuzz/Cargo.toml"],
        &[("RUSTFLAGS", "-D warnings")],
    )
}

/// Tests the scripts that judge times and instruction counts, then counts.
fn budget() -> Result<(), String> {
    ["test_budget.py", "budget.py"]
        .iter()
        .try_for_each(|script| run("python3", &[&format!("benches/scripts/{script}")], &[]))
}

/// Targets that have other tests, or test other code, with the features of all steps. The others were tested without these, as the
/// examples in the docs.
const FEATURED: &str = "--lib --bins --test behaviours --test jmanager --test league --test mujoco --test program --test replay \
    --test robot --test runner";

/// Runs all tests but those that need what a clone does not have, or an idle machine.
fn tests() -> Result<(), String> {
    let visits = folder("coverage");
    // Of an earlier run.
    let _ = fs::remove_dir_all(&visits);
    let visits = visits.display().to_string();
    // More random cases where a few hundred take seconds, and the same ones on each run: the result of CI is a property of the commit.
    let cases = [("BICA_TEST_CASES", "1000"), ("PROPTEST_CASES", "256"), ("PROPTEST_RNG_SEED", "1")];
    let variables = [&cases[..], &[("BICA_COVERAGE", &visits)]].concat();
    // The command of the README first: later steps need the programs with all features.
    run("cargo", &["test", "--workspace", "--quiet"], &variables)?;
    build::programs()?;
    build::cargo("test", &FEATURED.split(' ').collect::<Vec<_>>(), &variables)?;
    slow_tests::run(&variables)?;
    coverage(&visits)
}

/// Prints how much of the forward's machine the tests and their recorded games visit.
fn coverage(visits: &str) -> Result<(), String> {
    let games = ["game", "crowd", "images"].map(|name| format!("tools/player/tests/recordings/{name}.mcap"));
    let games = games.each_ref().map(String::as_str);
    let machine = ["coverage", "player/src/behaviour/player.rs"];
    run(&build::program("vicode"), &[&machine[..], &games, &[visits, "--summary"]].concat(), &[])
}

/// Installs MuJoCo if it is `wanted`, and returns the features of the packages with long tests that need it.
///
/// # Errors
/// If the installation fails.
pub(crate) fn with_mujoco(wanted: bool) -> Result<&'static [&'static str], String> {
    if wanted { mujoco::install().map(|()| &["bica-player-program/mujoco", "therapy/mujoco"][..]) } else { Ok(&[]) }
}

/// Plays games in the built-in world, and compares the figures in the docs.
fn games() -> Result<(), String> {
    let play = ["--", "play", "--games", "20", "--at-least", "19"];
    run("cargo", &[&["run", "--release"], build::release(), &play].concat(), &[])?;
    figures::figures(true)
}

/// Runs the selected steps, and prints the time of each and what was left out.
///
/// # Errors
/// If a tool cannot be installed, or a check fails; later steps of its lane do not run.
pub(crate) fn check(options: &Ci) -> Result<(), String> {
    let (steps, left_out) = select(options);
    if options.lane {
        return perform(&steps);
    }
    if options.only.is_empty() {
        room::check()?;
    }
    // Before the tests, which build this program again: then its first file is deleted, and another one has the same path.
    let program = env::current_exe().map_err(|error| error.to_string())?;
    let (alone, [waiting, computing]) = lanes(&steps);
    let (fast, alone) = alone.split_at(alone.partition_point(|step| *step < Step::Tests));
    begin(fast, &steps)?;
    perform(alone)?;
    let beside =
        (!waiting.is_empty() && !computing.is_empty()).then(|| Lane::start(&program, &computing)).transpose()?;
    let result = perform(if waiting.is_empty() { &computing } else { &waiting });
    let beside = beside.map_or(Ok(()), |lane| lane.wait(result.is_ok()));
    result.and(beside)?;
    eprintln!("xtask: {}", summary(&left_out));
    Ok(())
}

/// Runs the first checks, and installs the tools of all steps while these compute.
fn begin(fast: &[Step], all: &[Step]) -> Result<(), String> {
    // With MuJoCo, the first checks include more features.
    let (needed, others): (Vec<_>, Vec<_>) = all.iter().partition(|step| matches!(step, Step::Docs | Step::Mujoco));
    install(&needed, Step::install)?;
    thread::scope(|scope| {
        let installed = scope.spawn(|| install(&others, Step::install));
        let checked = perform(fast);
        let installed = installed.join().map_err(|_| "the installation of tools panicked".to_owned()).flatten();
        match (checked, installed) {
            (Err(one), Err(other)) => Err(format!("{one}\nxtask: {other}")),
            (checked, installed) => checked.and(installed),
        }
    })
}

/// Runs steps one after the other, and prints the time of each.
fn perform(steps: &[Step]) -> Result<(), String> {
    if steps.is_empty() {
        return Ok(());
    }
    let mut times = Vec::new();
    let result = steps.iter().try_for_each(|step| {
        let began = Instant::now();
        let result = step.check();
        times.push((step, began.elapsed().as_secs()));
        result.map_err(|error| format!("step `{}`: {error}", step.name()))
    });
    eprintln!("xtask: wall-clock time of each step");
    for (step, seconds) in times {
        eprintln!("{:10} {:3} min {:2} s", step.name(), seconds / 60, seconds % 60);
    }
    result
}

/// Steps that run alone, because the others use what they build, and two lanes that take about the same time: of steps that wait for
/// browsers, networks and other programs, and of those that keep a processor busy.
fn lanes(steps: &[Step]) -> (Vec<Step>, [Vec<Step>; 2]) {
    let (alone, rest): (Vec<_>, Vec<_>) = steps.iter().partition(|step| **step <= Step::Tests);
    let waits = |step: &Step| {
        use Step::{Advisories, Browser, Deny, Robot, Ros, Viewers};
        matches!(step, Deny | Advisories | Viewers | Robot | Ros | Browser)
    };
    let (waiting, computing) = rest.into_iter().partition(waits);
    (alone, [waiting, computing])
}

/// Steps that run beside others, in a process of their own whose output is kept until it ends.
struct Lane {
    process: Child,
    log: PathBuf,
}

impl Lane {
    fn start(program: &Path, steps: &[Step]) -> Result<Self, String> {
        let log = folder("ci.log");
        let failed = |error| format!("cannot start the steps {}: {error}", names(steps, ", "));
        let output = File::create(&log).map_err(failed)?;
        // The other steps wait for worlds and pages in real time; most of these only compute.
        let mut command = Command::new("nice");
        command.arg("-n5").arg(program);
        command.args(["ci", "--lane", "--only", &names(steps, ",")]).stdout(output.try_clone().map_err(failed)?);
        let process = command.stderr(output).spawn().map_err(failed)?;
        Ok(Self { process, log })
    }

    /// Waits for the end, and prints the output. That of a success is left out if other steps failed, because their errors shall be
    /// the last lines.
    fn wait(mut self, others_passed: bool) -> Result<(), String> {
        let status = self.process.wait().map_err(|error| error.to_string())?;
        if status.success() && !others_passed {
            return Ok(());
        }
        let log = fs::read(&self.log).map_err(|error| format!("cannot read {}: {error}", self.log.display()))?;
        eprintln!("xtask: output of the steps beside the others\n{}", String::from_utf8_lossy(&log));
        if status.success() { Ok(()) } else { Err("a step beside the others failed; its output is above".to_owned()) }
    }
}

/// Steps to run and steps left out, in their order.
fn select(options: &Ci) -> (Vec<Step>, Vec<Step>) {
    let wanted =
        |step: &Step| !options.without.contains(step) && (options.only.is_empty() || options.only.contains(step));
    Step::value_variants().iter().copied().partition(wanted)
}

/// Installs the tools of steps, and names all that are missing.
fn install(steps: &[Step], install: impl Fn(Step) -> Result<(), String>) -> Result<(), String> {
    let failed = steps.iter().filter_map(|step| Some((*step, install(*step).err()?)));
    let (failed, errors): (Vec<_>, Vec<_>) = failed
        .map(|(step, error)| (step, format!("the tool of step `{}` cannot be installed: {error}", step.name())))
        .unzip();
    if failed.is_empty() {
        return Ok(());
    }
    Err(format!("{}\n  help: `--without {}` leaves these steps out", errors.join("\nxtask: "), names(&failed, ",")))
}

fn summary(left_out: &[Step]) -> String {
    if left_out.is_empty() { "all steps passed".to_owned() } else { format!("LEFT OUT: {}", names(left_out, ", ")) }
}

fn names(steps: &[Step], separator: &str) -> String {
    steps.iter().map(|step| step.name()).collect::<Vec<_>>().join(separator)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::process::output;

    #[test]
    fn steps_left_out_are_named() {
        let (steps, left_out) = select(&Ci { without: vec![Step::Browser, Step::Miri], ..Ci::default() });
        assert_eq!((steps.len(), summary(&left_out)), (18, "LEFT OUT: miri, browser".to_owned()));
        let (steps, left_out) = select(&Ci { only: vec![Step::NoStd], ..Ci::default() });
        assert_eq!((steps, left_out.len()), (vec![Step::NoStd], 19));
        assert_eq!(summary(&select(&Ci::default()).1), "all steps passed");
    }

    #[test]
    fn targets_with_features_are_tested_with_them() {
        let files =
            output("git", &["grep", "--files-with-matches", "feature = \"", "--", "*.rs"], &[]).expect("a clone");
        let targets = files.lines().filter_map(|file| file.split_once("/tests/"));
        let targets = targets.filter(|(package, _)| !package.contains("/src"));
        let targets: BTreeSet<_> = targets.filter_map(|(_, rest)| rest.split(['/', '.']).next()).collect();
        let tested: BTreeSet<_> = FEATURED.split(' ').filter(|word| !word.starts_with("--")).collect();
        assert!(targets.is_subset(&tested) && targets.len() > 5, "{targets:?} {tested:?}");
    }

    #[test]
    fn each_step_is_in_one_lane() {
        let (alone, [waiting, computing]) = lanes(Step::value_variants());
        assert!(waiting.contains(&Step::Browser) && computing.contains(&Step::Firmware));
        let mut all = [alone, computing, waiting].concat();
        all.sort();
        assert_eq!(all, Step::value_variants());
    }

    #[test]
    fn a_missing_tool_fails_and_names_the_option() {
        let broken = |step| if matches!(step, Step::Miri | Step::Browser) { Err("offline".to_owned()) } else { Ok(()) };
        let error = install(&[Step::Format, Step::Miri, Step::Browser], broken).expect_err("two tools are missing");
        assert!(error.contains("step `miri`") && error.contains("--without miri,browser"), "{error}");
        assert_eq!(install(&[Step::Format], broken), Ok(()));
    }
}
