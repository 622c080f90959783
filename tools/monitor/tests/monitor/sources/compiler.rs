//! Check, build and run.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::time::{Duration, Instant};

use bica_monitor::sessions::Options;
use serde_json::{Value, json};

use crate::page::{Bench, LONG};
use crate::sources::view::{Sources, View, text_of};

const MANIFEST: &str = "[package]\nname = \"tiny\"\nversion = \"0.1.0\"\nedition = \"2021\"\n\n[workspace]\n";
const LIBRARY: &str = "pub fn f() -> u32 {\n    1\n}\n";

/// A package without dependencies.
fn package(files: &[(&str, &str)]) -> Sources {
    let sources = Sources::new(&[("Cargo.toml", MANIFEST)]);
    for (name, text) in files {
        sources.write(name, text);
    }
    sources
}

fn bench(sources: &Sources) -> Arc<Bench> {
    let run = "--bin tiny -- {address} {seed}".to_owned();
    sources.bench_with(Options { build: true, run, ..sources.options() })
}

/// Waits for the end of a check.
fn checked(view: &View) -> Value {
    view.wait("a check", |message| {
        (message["type"] == "check" && message["state"] != "running").then(|| message.clone())
    })
}

fn replace(view: &View, file: &str, from: &str, to: &str) {
    let at = view.shown(file).text.find(from).unwrap();
    view.edit(file, &json!([{ "edit": "replace", "span": [at, at + from.len()], "text": to }])).unwrap();
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_messages_of_a_check_have_their_place() {
    let sources = package(&[("src/lib.rs", LIBRARY)]);
    let bench = bench(&sources);
    let view = View::of(&bench, "src/lib.rs");
    replace(&view, "src/lib.rs", "1", "true");
    let check = checked(&view);
    assert_eq!(check["state"], "done", "{check}");
    let error = &check["messages"][0];
    let text = view.shown("src/lib.rs").text;
    let at = text.find("true").unwrap();
    assert_eq!((&error["file"], &error["line"]), (&json!("src/lib.rs"), &json!(2)));
    assert_eq!((&error["span"], &error["version"]), (&json!([at, at + 4]), &json!(1)), "{error}");
    assert_eq!(error["level"], "error");
    assert!(error["text"].as_str().unwrap().contains("mismatched types"), "{error}");
    // A page that connects later receives the result, too.
    let late = View::new(&bench);
    assert_eq!(checked(&late)["messages"], check["messages"]);
    replace(&view, "src/lib.rs", "true", "let ä = 1;\n    2");
    let check = checked(&view);
    let warning = &check["messages"][0];
    let at = view.shown("src/lib.rs").text.find('ä').unwrap();
    assert_eq!((&warning["level"], &warning["span"]), (&json!("warning"), &json!([at, at + 2])), "{check}");
    assert!(warning["help"].as_str().unwrap().contains("_ä"), "{warning}");
    replace(&view, "src/lib.rs", "let ä = 1;\n    2", "2");
    assert_eq!(checked(&view)["messages"], json!([]));
    assert!(sources.path("target/vicode/debug").exists(), "a user's own builds do not wait");
    assert!(!sources.path("target/debug").exists());
}

#[test]
fn without_permission_nothing_is_built() {
    let sources = package(&[("src/lib.rs", LIBRARY)]);
    let bench = sources.bench();
    let view = View::of(&bench, "src/lib.rs");
    for request in
        [json!({ "type": "check" }), json!({ "type": "run", "seed": 0, "robots": 0 }), json!({ "type": "stop_run" })]
    {
        assert!(text_of(view.ask(request)).contains("does not build"));
    }
    replace(&view, "src/lib.rs", "1", "2");
    view.until_saved("src/lib.rs");
    std::thread::sleep(Duration::from_secs(1));
    assert!(!sources.path("target").exists());
}

#[test]
fn missing_package_and_broken_manifest_are_errors() {
    let sources = package(&[("src/lib.rs", LIBRARY)]);
    sources.write("Cargo.toml", "[package\n");
    let bench = bench(&sources);
    let view = View::of(&bench, "src/lib.rs");
    view.ask(json!({ "type": "check" })).unwrap();
    let check = checked(&view);
    assert_eq!((&check["state"], &check["messages"][0]["file"]), (&json!("failed"), &Value::Null), "{check}");
    view.ask(json!({ "type": "run", "seed": 0, "robots": 0 })).unwrap();
    assert!(!build(&view, "failed")["text"].as_str().unwrap().is_empty());
}

/// Returns whether a process exists.
fn is_alive(pid: &str) -> bool {
    let status = Command::new("kill").args(["-0", pid]).stderr(Stdio::null()).status().unwrap();
    status.success()
}

fn wait_until(what: &str, mut is: impl FnMut() -> bool) {
    let until = Instant::now() + LONG;
    while !is() {
        assert!(Instant::now() < until, "{what}");
        std::thread::sleep(Duration::from_millis(50));
    }
}

fn lines(path: &Path) -> Vec<String> {
    fs::read_to_string(path).unwrap_or_default().lines().map(str::to_owned).collect()
}

#[cfg(unix)]
#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_check_of_old_text_is_ended_with_its_processes() {
    let script = "use std::io::Write;\nfn main() {\n    let mut pids = std::fs::OpenOptions::new().create(true).append(true).open(\"pids\").unwrap();\n    \
                  writeln!(pids, \"{}\", std::process::id()).unwrap();\n    while std::path::Path::new(\"block\").exists() {\n        \
                  std::thread::sleep(std::time::Duration::from_millis(20));\n    }\n}\n";
    let sources = package(&[("src/lib.rs", LIBRARY), ("build.rs", script), ("block", "")]);
    let bench = bench(&sources);
    let view = View::of(&bench, "src/lib.rs");
    replace(&view, "src/lib.rs", "1", "2");
    wait_until("the build script starts", || lines(&sources.path("pids")).len() == 1);
    replace(&view, "src/lib.rs", "2", "true");
    wait_until("another one starts", || lines(&sources.path("pids")).len() == 2);
    let first = lines(&sources.path("pids")).remove(0);
    wait_until("the first one is ended", || !is_alive(&first));
    fs::remove_file(sources.path("block")).unwrap();
    assert_eq!(checked(&view)["messages"][0]["level"], "error", "the newer text was checked");
    // The end of the server ends a check.
    sources.write("block", "");
    sources.write("build.rs", &format!("{script}\n"));
    replace(&view, "src/lib.rs", "true", "3");
    wait_until("a third one starts", || lines(&sources.path("pids")).len() == 3);
    let third = lines(&sources.path("pids")).remove(2);
    drop(view);
    drop(bench);
    wait_until("the third one is ended", || !is_alive(&third));
}

/// Waits for a state of the build.
fn build(view: &View, state: &str) -> Value {
    view.wait(state, |message| (message["type"] == "build" && message["state"] == state).then(|| message.clone()))
}

#[cfg(unix)]
#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_failed_build_leaves_the_last_program_running() {
    let program = "use std::time::Duration;\nfn main() {\n    let words: Vec<String> = std::env::args().collect();\n    \
                   let listener = std::net::TcpListener::bind(&words[1]).unwrap();\n    \
                   std::fs::write(\"pid\", std::process::id().to_string()).unwrap();\n    \
                   println!(\"seed {}\\nmonitors attach at {}\", words[2], listener.local_addr().unwrap());\n    \
                   std::thread::sleep(Duration::from_secs(1000));\n}\n";
    let sources = package(&[("src/main.rs", program)]);
    let bench = bench(&sources);
    let view = View::of(&bench, "src/main.rs");
    let run = || view.ask(json!({ "type": "run", "seed": 5, "robots": 0 })).unwrap();
    run();
    build(&view, "building");
    let first = build(&view, "running");
    let pid = fs::read_to_string(sources.path("pid")).unwrap();
    assert!(first["session"].is_u64() && is_alive(&pid), "{first}");

    replace(&view, "src/main.rs", "1000", "true");
    run();
    let failed = build(&view, "failed");
    assert_eq!(failed["session"], first["session"]);
    assert_eq!(failed["messages"][0]["file"], "src/main.rs", "{failed}");
    assert!(is_alive(&pid));

    // A program that does not start leaves the previous one running, too.
    replace(&view, "src/main.rs", "from_secs(true)", "from_secs(std::process::exit(3))");
    replace(&view, "src/main.rs", "println!", "eprintln!(\"no link\"); if false { println!");
    replace(&view, "src/main.rs", "unwrap());\n    std::thread", "unwrap()); }\n    std::thread");
    run();
    let failed = build(&view, "failed");
    assert!(failed["text"].as_str().unwrap().contains("no link"), "{failed}");
    assert_eq!(failed["session"], first["session"]);
    assert!(is_alive(&pid));

    for _ in 0..3 {
        view.ask(json!({ "type": "undo_file", "file": "src/main.rs" })).unwrap();
    }
    replace(&view, "src/main.rs", "true", "2000");
    run();
    let closed =
        view.wait("the old session ends", |message| (message["type"] == "closed").then(|| message["session"].clone()));
    assert_eq!(closed, first["session"]);
    let second = build(&view, "running");
    assert_ne!(second["session"], first["session"]);
    wait_until("the old program is ended", || !is_alive(&pid));
    let pid = fs::read_to_string(sources.path("pid")).unwrap();

    view.ask(json!({ "type": "stop_run" })).unwrap();
    assert_eq!(build(&View::new(&bench), "ended")["session"], Value::Null);
    wait_until("the program is ended", || !is_alive(&pid));

    run();
    build(&view, "running");
    let pid = fs::read_to_string(sources.path("pid")).unwrap();
    assert!(is_alive(&pid));
    drop(view);
    drop(bench);
    wait_until("the program ends with the server", || !is_alive(&pid));
}
