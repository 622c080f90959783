//! Hostile input, and a server that is killed.

use std::fs;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::time::Duration;

use serde_json::json;

use crate::sessions::page::{Bench, Folder};
use crate::sources::view::{PLAYER, Sources, View, text_of};

#[test]
fn a_file_that_is_replaced_by_a_link_is_neither_read_nor_written_through_it() {
    let sources = Sources::player();
    let bench = sources.bench();
    let view = View::of(&bench, "player.rs");
    let secret = sources.0.0.join("secret.rs");
    fs::write(&secret, "// secret\n").unwrap();
    fs::remove_file(sources.path("player.rs")).unwrap();
    std::os::unix::fs::symlink(&secret, sources.path("player.rs")).unwrap();
    view.until("player.rs", "the problem", |shown| shown.state["problem"].as_str().unwrap().contains("outside"));
    view.type_behind("player.rs", "let _ = ", "2 + ").unwrap();
    assert!(text_of(view.ask(json!({ "type": "save_file", "file": "player.rs" }))).contains("outside"));
    assert_eq!(fs::read_to_string(&secret).unwrap(), "// secret\n");
    assert!(!view.shown("player.rs").text.contains("secret"));
    // The layout beside a source is no way out either.
    let sources = Sources::player();
    std::os::unix::fs::symlink(&secret, sources.path("player.vicode")).unwrap();
    let bench = sources.bench();
    let view = View::of(&bench, "player.rs");
    let shown = view.shown("player.rs");
    assert!(!shown.state["problem"].as_str().unwrap().contains("// secret"), "{}", shown.state);
    assert_ne!(shown.state["problem"], "");
}

#[test]
fn too_much_is_refused_and_nothing_is_lost() {
    let sources = Sources::player();
    let bench = sources.bench();
    let view = View::of(&bench, "player.rs");
    let large = "let _ = 1;\n".repeat(100_000);
    let body = json!([{ "edit": "set_body", "component": "Player", "function": "walk", "body": large }]);
    assert!(text_of(view.edit("player.rs", &body)).contains("bytes in the edits"));
    let many: Vec<_> =
        (0..300).map(|_| json!({ "edit": "set_initial", "component": "Player", "state": "walk" })).collect();
    assert!(text_of(view.edit("player.rs", &json!(many))).contains("number of edits"));
    let text = "x".repeat(2 << 20);
    text_of(view.ask(json!({ "type": "resolve_file", "file": "player.rs", "keep": { "text": text } })));
    assert_eq!(view.shown("player.rs").text, PLAYER);
    sources.write("large.rs", &"// x\n".repeat(300_000));
    assert!(text_of(view.ask(json!({ "type": "open_file", "file": "large.rs" }))).contains("bytes of the file"));
}

#[test]
fn open_files_are_limited_and_become_free_again() {
    let sources = Sources::player();
    for number in 0..70 {
        sources.write(&format!("f{number}.rs"), "fn f() {}\n");
    }
    let bench = sources.bench();
    let view = View::new(&bench);
    let open = |number: usize| view.ask(json!({ "type": "open_file", "file": format!("f{number}.rs") }));
    for number in 0..64 {
        open(number).unwrap();
    }
    assert!(text_of(open(64)).contains("64 files"));
    view.ask(json!({ "type": "close_file", "file": "f7.rs" })).unwrap();
    open(64).unwrap();
}

/// Where the killed server works.
const VICTIM: &str = "JMANAGER_TEST_VICTIM";

/// Texts between which the killed server changes; long, so that writing takes time.
fn versions() -> [String; 2] {
    let comment = "// nothing but a long comment that fills the file\n".repeat(8000);
    ["1", "2"].map(|number| PLAYER.replace("= 1", &format!("= {number}")) + &comment)
}

/// The server that is killed: no test by itself.
#[test]
fn victim() {
    let Ok(folder) = std::env::var(VICTIM) else { return };
    let folder = std::path::Path::new(&folder);
    let options = bica_monitor::sessions::Options { source: Some(folder.to_owned()), ..Default::default() };
    let bench = Bench::of(&Arc::new(Folder(std::path::PathBuf::new())), options);
    let view = View::of(&bench, "player.rs");
    for number in 0_u32.. {
        let text = &view.shown("player.rs").text;
        let at = text.find("let _ = ").unwrap() + "let _ = ".len();
        let digit = if &text[at..=at] == "1" { "2" } else { "1" };
        view.edit("player.rs", &json!([{ "edit": "replace", "span": [at, at + 1], "text": digit }])).unwrap();
        view.ask(json!({ "type": "save_file", "file": "player.rs" })).unwrap();
        if number == 0 {
            println!("saves");
        }
    }
}

#[test]
fn a_server_that_is_killed_while_it_saves_leaves_the_file_whole() {
    use std::io::{BufRead, BufReader};
    let [one, two] = versions();
    for round in 0..8 {
        let sources = Sources::new(&[("player.rs", &one)]);
        let mut child = Command::new(std::env::current_exe().unwrap())
            .args(["sources::faults::victim", "--exact", "--nocapture", "--test-threads=1"])
            .env(VICTIM, sources.path(""))
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let output = BufReader::new(child.stdout.take().unwrap());
        let saves = output.lines().map_while(Result::ok).any(|line| line.contains("saves"));
        assert!(saves, "it saves");
        std::thread::sleep(Duration::from_millis(13 * round));
        child.kill().unwrap();
        child.wait().unwrap();
        let text = sources.read("player.rs");
        assert!(text == one || text == two, "{} bytes of {}", text.len(), one.len());
    }
}

/// Where the server with a full disk works.
const FULL: &str = "JMANAGER_TEST_FULL_DISK";
/// Size of a file that the disk has room for, in units of 1024 bytes.
const ROOM: usize = 64;

/// The server with a full disk: no test by itself.
#[test]
fn server_with_a_full_disk() {
    let Ok(folder) = std::env::var(FULL) else { return };
    let folder = std::path::Path::new(&folder);
    let options = bica_monitor::sessions::Options { source: Some(folder.to_owned()), ..Default::default() };
    let bench = Bench::of(&Arc::new(Folder(std::path::PathBuf::new())), options);
    let view = View::of(&bench, "player.rs");
    let before = view.shown("player.rs").text;
    let too_much = format!("//{}\n", "x".repeat(1024 * ROOM));
    view.edit("player.rs", &json!([{ "edit": "replace", "span": [0, 0], "text": too_much }])).unwrap();
    let failed = text_of(view.ask(json!({ "type": "save_file", "file": "player.rs" })));
    assert!(failed.contains("player.rs"), "{failed}");
    let on_disk = || std::fs::read_to_string(folder.join("player.rs")).unwrap();
    assert_eq!(on_disk(), before, "the file has its old text");
    let shown = view.shown("player.rs");
    assert_eq!(shown.text, too_much + &before, "the edit is not lost");
    assert_eq!(shown.state["saved"], false);
    assert!(!shown.state["problem"].as_str().unwrap().is_empty(), "the page shows what is wrong");
    // A smaller text fits again.
    view.ask(json!({ "type": "undo_file", "file": "player.rs" })).unwrap();
    view.type_behind("player.rs", "let _ = ", "2 + ").unwrap();
    view.ask(json!({ "type": "save_file", "file": "player.rs" })).unwrap();
    assert_eq!(on_disk(), before.replace("let _ = 1", "let _ = 2 + 1"));
    let left = std::fs::read_dir(folder).unwrap().count();
    assert_eq!(left, 1, "nothing lies beside the file");
    println!("the full disk was survived");
}

#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_file_whole_and_the_edit_in_memory() {
    let sources = Sources::player();
    // Larger files cannot be written, as on a full disk.
    let script = format!(
        "trap '' XFSZ; ulimit -f {ROOM}; exec \"$0\" sources::faults::server_with_a_full_disk --exact --nocapture"
    );
    let ran = Command::new("bash")
        .args(["-c", &script])
        .arg(std::env::current_exe().unwrap())
        .env(FULL, sources.path(""))
        .output()
        .unwrap();
    let out = String::from_utf8_lossy(&ran.stdout);
    assert!(
        ran.status.success() && out.contains("the full disk was survived"),
        "{out}\n{}",
        String::from_utf8_lossy(&ran.stderr)
    );
}
