//! Processes of the examples.

use std::env;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

pub(crate) use bica_test_data::process::{Folder, Ran, Served};

/// Returns the program of an example, which `cargo test -p bica-app` builds.
pub(crate) fn example(name: &str) -> Command {
    let test = env::current_exe().expect("the path of this test");
    let built = test.parent().and_then(Path::parent).expect("the folder of the profile").join("examples");
    let program = built.join(name).with_extension(env::consts::EXE_EXTENSION);
    assert!(program.exists(), "{} is missing: run `cargo build -p bica-app --examples`", program.display());
    Command::new(program)
}

/// Runs the wall follower to its end.
pub(crate) fn run(args: &[&str]) -> Ran {
    let mut program = example("wall_follower");
    program.args(args);
    Ran::of(program)
}

/// Runs the wall follower. It must end with exit code 2, print nothing on stdout and these words on stderr.
pub(crate) fn refused(args: &[&str], words: &[&str]) {
    let ran = run(args);
    ran.refused(words);
    assert_eq!(ran.stdout, "", "{args:?}");
}

/// Runs `link` on a served wall follower; it must succeed. Returns its output lines.
pub(crate) fn link(served: &Served, args: &[&str]) -> Vec<Value> {
    let ran = run(&[&["link", &served.address, "--json"][..], args].concat());
    assert_eq!(ran.code, Some(0), "{args:?}: {}", ran.stderr);
    ran.lines()
}
