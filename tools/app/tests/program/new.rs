//! `bica new`: the crate of a new robot.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::process::{Folder, Ran};

/// Packages that only a humanoid or a soccer robot uses.
const FOREIGN: [&str; 9] = [
    "bica-body",
    "bica-motion",
    "bica-field",
    "bica-vision",
    "bica-sim",
    "bica-player",
    "bica-player-program",
    "bica-evaluation",
    "jmanager",
];

/// Maximum number of packages of a new crate, without build scripts and the dependencies of macros. Each package
/// lengthens the first build.
const MOST_PACKAGES: usize = 66;

/// Runs `bica new` in a folder.
fn new(folder: &Path, args: &[&str]) -> Ran {
    let mut program = Command::new(env!("CARGO_BIN_EXE_bica"));
    program.arg("new").args(args).current_dir(folder);
    Ran::of(program)
}

/// Creates a crate with the lock file of the repository, so that cargo needs no network.
fn made(folder: &Folder, name: &str, kind: &[&str]) -> PathBuf {
    let ran = new(folder.path(), &[&[name], kind].concat());
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert!(ran.stdout.contains("cargo run"), "{}", ran.stdout);
    let made = folder.path().join(name);
    let lock = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../Cargo.lock");
    fs::copy(lock, made.join("Cargo.lock")).expect("a lock file");
    made
}

fn change(file: &Path, old: &str, new: &str) {
    let text = fs::read_to_string(file).expect("a file");
    assert!(text.contains(old), "`{old}` is not in {}", file.display());
    fs::write(file, text.replace(old, new)).expect("a file");
}

fn cargo(folder: &Path, args: &[&str]) -> Ran {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(args).current_dir(folder).env("CARGO_NET_OFFLINE", "true");
    // The dependencies are built once for all runs of this test.
    cargo.env("CARGO_TARGET_DIR", Path::new(env!("CARGO_TARGET_TMPDIR")).join("new"));
    Ran::of(cargo)
}

#[test]
fn new_crate_needs_no_package_of_another_robot() {
    let folder = Folder::new("new-tree");
    let ran = cargo(&made(&folder, "my-cart", &[]), &["tree", "--edges", "normal", "--prefix", "none"]);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let packages: BTreeSet<_> = ran.stdout.lines().filter_map(|line| line.split(' ').next()).collect();
    assert!(["my-cart", "bica-link", "bica-recording"].iter().all(|name| packages.contains(name)), "{packages:?}");
    assert!(packages.len() <= MOST_PACKAGES, "{} packages: {packages:?}", packages.len());
    let found: Vec<_> = FOREIGN.iter().filter(|name| packages.contains(*name)).collect();
    assert!(found.is_empty(), "the program of a cart needs {found:?}");
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_new_crate_runs_records_replays_and_benches() {
    let folder = Folder::new("new-robot");
    let made = made(&folder, "my-cart", &[]);
    let passes = |args: &[&str], words: &[&str]| {
        let ran = cargo(&made, args);
        assert_eq!(ran.code, Some(0), "{args:?}: {}{}", ran.stdout, ran.stderr);
        assert!(words.iter().all(|word| ran.stdout.contains(word)), "{words:?} not in {}", ran.stdout);
    };
    passes(&["run"], &["done after 4.22 s, 211 cycles in road, seed 0"]);
    passes(&["run", "--", "run", "--record", "run.mcap"], &["recording"]);
    passes(&["run", "--", "replay", "run.mcap"], &["equal, bit for bit"]);
    // The same profile as in the runs, so that nothing is built twice.
    let bench = ["bench", "--profile", "dev", "--", "--json"];
    passes(&bench, &["\"schema\":\"bica/bench/1\"", "\"name\":\"Driver\"", "\"exceeded\":[]"]);
    let slow = "wheels.drive((sonar.distance";
    change(&made.join("src/lib.rs"), slow, &format!("std::thread::sleep(std::time::Duration::from_millis(1));{slow}"));
    let ran = cargo(&made, &bench);
    assert_ne!(ran.code, Some(0), "{}", ran.stdout);
    assert!(
        ran.stderr.contains("exceeded") && ran.stdout.contains("[\"Driver takes 1"),
        "{}{}",
        ran.stdout,
        ran.stderr
    );
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_new_humanoid_walks_and_replays() {
    let folder = Folder::new("new-humanoid");
    let made = made(&folder, "my-walker", &["--humanoid"]);
    let mut output = String::new();
    for args in [&["run"][..], &["run", "--", "run", "--record", "run.mcap"], &["run", "--", "replay", "run.mcap"]] {
        let ran = cargo(&made, args);
        assert_eq!(ran.code, Some(0), "{args:?}: {}{}", ran.stdout, ran.stderr);
        assert!(!ran.stderr.contains("warning"), "{}", ran.stderr);
        output += &ran.stdout;
    }
    for words in ["Patrol:turn_round", "done after 20.95 s, 2095 cycles in floor", "equal, bit for bit"] {
        assert!(output.contains(words), "{words} not in {output}");
    }
}

#[test]
fn humanoid_is_written_with_its_body() {
    let folder = Folder::new("new-biped");
    assert_eq!(new(folder.path(), &["--humanoid", "tall-one"]).code, Some(0));
    let read = |file: &str| fs::read_to_string(folder.path().join("tall-one").join(file)).expect("a file");
    assert!(read("Cargo.toml").contains("name = \"tall-one\"") && read("src/main.rs").contains("tall_one::app()"));
    assert!(read("src/model.rs").contains("id: \"tall-one\"") && read("robot.xml").contains("<mujoco"));
    new(folder.path(), &["--humanoid", "--embassy", "both"]).refused(&["cannot be used with"]);
}

#[test]
fn firmware_is_written_with_the_files_of_its_board() {
    let folder = Folder::new("new-firmware");
    assert_eq!(new(folder.path(), &["--embassy", "feet"]).code, Some(0));
    let read = |file: &str| fs::read_to_string(folder.path().join("feet").join(file)).expect("a file");
    assert!(read("Cargo.toml").contains("name = \"feet\""));
    assert!(read("memory.x").contains("FLASH") && read("src/clock.rs").contains("time_driver_impl!"));
    assert!(read("src/main.rs").contains("#![no_std]") && read(".cargo/config.toml").contains("shift=5"));
}

#[test]
fn wrong_names_and_folders_are_refused_with_a_remedy() {
    let folder = Folder::new("new-refused");
    fs::create_dir(folder.path().join("here")).expect("a folder");
    for (name, words) in [
        ("here", &["cannot create the folder", "exists", "choose another name"][..]),
        ("none/cart", &["cannot create a folder in `none`", "create this folder first"]),
        ("3cart", &["`3cart` is not the name of a crate", "first a letter"]),
        ("größe", &["`größe` is not", "a to z"]),
        ("Cart", &["`Cart` is not", "a to z"]),
        ("my cart", &["`my cart` is not"]),
        ("..", &["is not the name of a crate"]),
        ("match", &["Rust keeps the name `match`"]),
        ("core", &["Rust keeps the name `core`"]),
        ("proc-macro", &["Rust keeps"]),
        ("bica_app", &["needs the crate `bica_app`", "choose another name"]),
    ] {
        new(folder.path(), &[name]).refused(words);
    }
    let left: Vec<_> = fs::read_dir(folder.path()).expect("the folder").collect();
    assert_eq!(left.len(), 1, "{left:?}");
}
