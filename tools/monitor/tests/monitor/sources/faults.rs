//! Hostile input.

use std::fs;

use serde_json::json;

use crate::sources::view::{PLAYER, Sources, View, text_of};

#[test]
fn no_file_is_read_or_written_through_a_link() {
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
    // The layout file beside a source is not read through a symbolic link either.
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
    let (sources, view) = Sources::shown();
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
