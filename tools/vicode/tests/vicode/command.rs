//! The command line.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use crate::files::scratch;
use crate::sources;

fn vicode(arguments: &[&str], folder: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_vicode")).args(arguments).current_dir(folder).output().unwrap()
}

fn out(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

const MACHINE: &str = "//! A.\n\nuse bica::prelude::*;\n\npub struct A;\n\n#[component]\nimpl A {\n    pub const fn new() -> Self {\n        Self\n    }\n\n    #[state(initial)]\n    fn one(&mut self) {}\n\n    #[transition(one -> two)]\n    fn go(&self) -> bool {\n        true\n    }\n\n    #[state(last)]\n    fn two(&mut self) {}\n}\n";

#[test]
fn dry_run_prints_what_a_run_applies() {
    let folder = scratch();
    fs::write(folder.join("a.rs"), MACHINE).unwrap();
    let edits = r#"[{"edit": "rename", "component": "A", "function": "two", "to": "end"},
        {"edit": "add_child", "component": "A", "function": "one", "child": "Head", "kind": "modulation", "import": "crate::motion"}]"#;
    fs::write(folder.join("edits.json"), edits).unwrap();
    let dry = vicode(&["apply", "a.rs", "--edits", "edits.json", "--dry-run"], &folder);
    let expected = "--- a/a.rs\n+++ b/a.rs\n@@ -2,6 +2,8 @@\n \n use bica::prelude::*;\n \n+use crate::motion::Head;\n+\n pub struct A;\n";
    assert!(out(&dry).starts_with(expected), "{}", out(&dry));
    assert!(out(&dry).contains("-    fn one(&mut self) {}\n+    fn one(&mut self, head: &mut Head) {}\n"));
    assert_eq!(fs::read_to_string(folder.join("a.rs")).unwrap(), MACHINE);
    assert!(vicode(&["apply", "a.rs", "--edits", "edits.json"], &folder).status.success());
    let after = fs::read_to_string(folder.join("a.rs")).unwrap();
    assert!(after.contains("#[transition(one -> end)]") && after.contains("fn end(&mut self) {}"));
    let again = vicode(&["apply", "a.rs", "--edits", "edits.json"], &folder);
    assert_eq!(again.status.code(), Some(2));
    assert!(
        String::from_utf8_lossy(&again.stderr)
            .contains("edit 1 is refused, nothing was changed: `A` has no function `two`")
    );
    assert_eq!(fs::read_to_string(folder.join("a.rs")).unwrap(), after);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn check_prints_places_and_sets_the_exit_code() {
    let folder = scratch();
    fs::write(folder.join("a.rs"), MACHINE).unwrap();
    assert!(vicode(&["check", "a.rs"], &folder).status.success());
    fs::write(folder.join("a.rs"), MACHINE.replace("one -> two", "one -> tow")).unwrap();
    let bad = vicode(&["check", "a.rs"], &folder);
    assert_eq!(bad.status.code(), Some(1));
    assert_eq!(out(&bad), "a.rs:16:25: no state is called `tow`: did you mean `two`?\n");
    assert_eq!(vicode(&["check", "none.rs"], &folder).status.code(), Some(2));
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn model_is_json_and_drawings_show_all_states() {
    let folder = scratch();
    let player = sources::root().join("player/src/behaviour/player.rs").canonicalize().unwrap();
    let player = player.to_str().unwrap();
    let model: serde_json::Value = serde_json::from_str(&out(&vicode(&["model", player, "--json"], &folder))).unwrap();
    let states = model["components"][0]["states"].as_array().unwrap();
    assert_eq!(states.len(), 8);
    assert_eq!(states[0]["function"]["name"]["text"], "look_for_ball");
    for format in ["svg", "mermaid", "dot"] {
        let drawing = out(&vicode(&["draw", player, "--format", format], &folder));
        let again = out(&vicode(&["draw", player, "--format", format], &folder));
        assert_eq!(drawing, again);
        for state in states {
            assert!(drawing.contains(state["function"]["name"]["text"].as_str().unwrap()), "{format}");
        }
    }
    assert!(vicode(&["draw", player, "--format", "png", "--output", "p.png"], &folder).status.success());
    assert!(fs::read(folder.join("p.png")).unwrap().starts_with(b"\x89PNG"));
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn new_component_gets_file_mod_line_and_tree_entry() {
    let folder = scratch();
    fs::create_dir(folder.join("src")).unwrap();
    let lib = "//! Lib.\n\nmod a;\nmod z;\n\npub use a::A;\n\nactivation_tree! {\n    pub struct T {\n        root: A,\n        cycle_hz: 100,\n        components: [A],\n    }\n}\n";
    fs::write(folder.join("src/lib.rs"), lib).unwrap();
    let made = vicode(&["new", "BallKeeper", "--tree", "src/lib.rs"], &folder);
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let expected = lib
        .replace("mod z;", "mod ball_keeper;\nmod z;")
        .replace("pub use a::A;", "pub use a::A;\npub use ball_keeper::BallKeeper;")
        .replace("[A]", "[A, BallKeeper]");
    assert_eq!(fs::read_to_string(folder.join("src/lib.rs")).unwrap(), expected);
    let text = fs::read_to_string(folder.join("src/ball_keeper.rs")).unwrap();
    assert_eq!(bica_vicode::read(&text).problems, []);
    for (name, why) in [
        ("BallKeeper", "exists already"),
        ("Loop", "is a keyword"),
        ("ball", "called like a type"),
        ("Rate", "means something else"),
    ] {
        let refused = vicode(&["new", name], &folder);
        assert_eq!(refused.status.code(), Some(2), "{name}");
        assert!(String::from_utf8_lossy(&refused.stderr).contains(why), "{name}");
    }
    assert_eq!(fs::read_dir(folder.join("src")).unwrap().count(), 2);
    fs::remove_dir_all(folder).unwrap();
}

/// `limit` stands before the command; a limit of the file size of 1024 bytes takes effect while the new text is written.
#[cfg(unix)]
fn save_with_limit(limit: &str) -> (Option<i32>, String) {
    let folder = scratch();
    let text = MACHINE.to_owned() + &"// a comment\n".repeat(400);
    fs::write(folder.join("a.rs"), &text).unwrap();
    fs::write(folder.join("e.json"), r#"[{"edit": "delete", "component": "A", "function": "go"}]"#).unwrap();
    let script = format!("{limit}; ulimit -c 0; ulimit -f 1; exec \"$0\" apply a.rs --edits e.json");
    let output =
        Command::new("bash").args(["-c", &script, env!("CARGO_BIN_EXE_vicode")]).current_dir(&folder).output().unwrap();
    assert_eq!(fs::read_to_string(folder.join("a.rs")).unwrap(), text, "the file is whole");
    fs::remove_dir_all(folder).unwrap();
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[cfg(unix)]
#[test]
fn full_disk_keeps_the_file() {
    let (code, error) = save_with_limit("trap '' XFSZ");
    assert_eq!(code, Some(2));
    assert!(error.contains("`a.rs` was not changed: File too large"), "{error}");
}

#[cfg(unix)]
#[test]
fn kill_while_saving_keeps_the_file() {
    let (code, _) = save_with_limit("true");
    assert_eq!(code, None, "a signal ended it");
}
