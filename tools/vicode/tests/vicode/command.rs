//! The command line.

use std::fs;
use std::process::Command;

use bica_test_data::process::{Folder, Ran};

use crate::sources;

/// Runs the program in a folder.
pub(crate) fn vicode(arguments: &[&str], folder: &Folder) -> Ran {
    let mut program = Command::new(env!("CARGO_BIN_EXE_vicode"));
    // The folder may lie within a repository.
    program.args(arguments).current_dir(folder.path()).env("GIT_CEILING_DIRECTORIES", folder.path().parent().unwrap());
    Ran::of(program)
}

const MACHINE: &str = r"//! A.

use bica::prelude::*;

pub struct A;

#[component]
impl A {
    pub const fn new() -> Self {
        Self
    }

    #[state(initial)]
    fn one(&mut self) {}

    #[transition(one -> two)]
    fn go(&self) -> bool {
        true
    }

    #[state(last)]
    fn two(&mut self) {}
}
";

#[test]
fn dry_run_prints_what_a_run_applies() {
    let folder = Folder::new("command");
    fs::write(folder.file("a.rs"), MACHINE).unwrap();
    let edits = r#"[{"edit": "rename", "component": "A", "function": "two", "to": "end"},
        {"edit": "add_child", "component": "A", "function": "one", "child": "Head", "kind": "modulation", "import": "crate::motion"}]"#;
    fs::write(folder.file("edits.json"), edits).unwrap();
    let dry = vicode(&["apply", "a.rs", "--edits", "edits.json", "--dry-run"], &folder);
    let expected = "--- a/a.rs\n+++ b/a.rs\n@@ -2,6 +2,8 @@\n \n use bica::prelude::*;\n \n+use crate::motion::Head;\n+\n pub struct A;\n";
    assert!(dry.stdout.starts_with(expected), "{}", dry.stdout);
    assert!(dry.stdout.contains("-    fn one(&mut self) {}\n+    fn one(&mut self, head: &mut Head) {}\n"));
    assert_eq!(fs::read_to_string(folder.file("a.rs")).unwrap(), MACHINE);
    assert!(vicode(&["apply", "a.rs", "--edits", "edits.json"], &folder).code == Some(0));
    let after = fs::read_to_string(folder.file("a.rs")).unwrap();
    assert!(after.contains("#[transition(one -> end)]") && after.contains("fn end(&mut self) {}"));
    let again = vicode(&["apply", "a.rs", "--edits", "edits.json"], &folder);
    again.refused(&["edit 1 is refused, nothing was changed: `A` has no function `two`"]);
    assert_eq!(fs::read_to_string(folder.file("a.rs")).unwrap(), after);
}

#[test]
fn check_prints_places_and_sets_the_exit_code() {
    let folder = Folder::new("command");
    fs::write(folder.file("a.rs"), MACHINE).unwrap();
    assert!(vicode(&["check", "a.rs"], &folder).code == Some(0));
    fs::write(folder.file("a.rs"), MACHINE.replace("one -> two", "one -> tow")).unwrap();
    let bad = vicode(&["check", "a.rs"], &folder);
    assert_eq!(bad.code, Some(1));
    assert_eq!(bad.stdout, "a.rs:16:25: no state is called `tow`: did you mean `two`?\n");
    assert_eq!(vicode(&["check", "none.rs"], &folder).code, Some(2));
}

#[test]
fn model_is_json_and_drawings_show_all_states() {
    let folder = Folder::new("command");
    let player = sources::root().join("player/src/behaviour/player.rs").canonicalize().unwrap();
    let player = player.to_str().unwrap();
    let model = vicode(&["model", player, "--json"], &folder).json();
    let states = model["components"][0]["states"].as_array().unwrap();
    assert_eq!(states.len(), 9);
    assert_eq!(states[0]["function"]["name"]["text"], "look_for_ball");
    for format in ["svg", "mermaid", "dot"] {
        let drawing = vicode(&["draw", player, "--format", format], &folder).stdout;
        let again = vicode(&["draw", player, "--format", format], &folder).stdout;
        assert_eq!(drawing, again);
        for state in states {
            assert!(drawing.contains(state["function"]["name"]["text"].as_str().unwrap()), "{format}");
        }
    }
    assert!(vicode(&["draw", player, "--format", "png", "--output", "p.png"], &folder).code == Some(0));
    assert!(fs::read(folder.file("p.png")).unwrap().starts_with(b"\x89PNG"));
}

#[test]
fn new_component_gets_file_mod_line_and_tree_entry() {
    let folder = Folder::new("command");
    fs::create_dir(folder.file("src")).unwrap();
    let lib = r"//! Lib.

mod a;
mod z;

pub use a::A;

activation_tree! {
    pub struct T {
        root: A,
        cycle_hz: 100,
        components: [A],
    }
}
";
    fs::write(folder.file("src/lib.rs"), lib).unwrap();
    let made = vicode(&["new", "BallKeeper", "--tree", "src/lib.rs"], &folder);
    assert!(made.code == Some(0), "{}", made.stderr);
    let expected = lib
        .replace("mod z;", "mod ball_keeper;\nmod z;")
        .replace("pub use a::A;", "pub use a::A;\npub use ball_keeper::BallKeeper;")
        .replace("[A]", "[A, BallKeeper]");
    assert_eq!(fs::read_to_string(folder.file("src/lib.rs")).unwrap(), expected);
    let text = fs::read_to_string(folder.file("src/ball_keeper.rs")).unwrap();
    assert_eq!(bica_vicode::read(&text).problems, []);
    for (name, why) in [
        ("BallKeeper", "exists already"),
        ("Loop", "is a keyword"),
        ("ball", "called like a type"),
        ("Rate", "means something else"),
    ] {
        vicode(&["new", name], &folder).refused(&[why]);
    }
    assert_eq!(fs::read_dir(folder.file("src")).unwrap().count(), 2);
}

/// Saves an edit with a limit of 1024 bytes for written files, which the new text exceeds. `limit` is shell code before the command.
#[cfg(unix)]
fn save_with_limit(limit: &str) -> Ran {
    let folder = Folder::new("command");
    let text = MACHINE.to_owned() + &"// a comment\n".repeat(400);
    fs::write(folder.file("a.rs"), &text).unwrap();
    fs::write(folder.file("e.json"), r#"[{"edit": "delete", "component": "A", "function": "go"}]"#).unwrap();
    let script = format!("{limit}; ulimit -c 0; ulimit -f 1; exec \"$0\" apply a.rs --edits e.json");
    let mut limited = Command::new("bash");
    limited.args(["-c", &script, env!("CARGO_BIN_EXE_vicode")]).current_dir(folder.path());
    let ran = Ran::of(limited);
    assert_eq!(fs::read_to_string(folder.file("a.rs")).unwrap(), text, "the file is whole");
    ran
}

#[cfg(unix)]
#[test]
fn full_disk_keeps_the_file() {
    save_with_limit("trap '' XFSZ").refused(&["`a.rs` was not changed: File too large"]);
}

#[cfg(unix)]
#[test]
fn kill_while_saving_keeps_the_file() {
    assert_eq!(save_with_limit("true").code, None, "a signal ended it");
}
