//! Files on disk that other programs change, too.

use std::fs;

use serde_json::{Value, json};

use crate::sources::view::{PLAYER, Sources, View, text_of};

fn resolve(view: &View, keep: &Value) {
    view.ask(json!({ "type": "resolve_file", "file": "player.rs", "keep": keep })).unwrap();
}

#[test]
fn an_edit_is_saved_when_nobody_goes_on() {
    let (sources, view) = Sources::shown();
    view.type_behind("player.rs", "let _ = ", "2 + ").unwrap();
    assert_eq!(view.shown("player.rs").state["saved"], false);
    view.until_saved("player.rs");
    assert_eq!(sources.read("player.rs"), PLAYER.replace("let _ = 1", "let _ = 2 + 1"));
    view.type_behind("player.rs", "let _ = ", "3 + ").unwrap();
    view.ask(json!({ "type": "save_file", "file": "player.rs" })).unwrap();
    assert!(sources.read("player.rs").contains("3 + 2 + 1"));
}

#[test]
fn what_was_not_saved_is_saved_at_the_end() {
    let sources = Sources::player();
    let bench = sources.bench();
    let view = View::of(&bench, "player.rs");
    view.type_behind("player.rs", "let _ = ", "2 + ").unwrap();
    drop(view);
    drop(bench);
    assert!(sources.read("player.rs").contains("2 + 1"));
}

#[test]
fn foreign_edit_appears_and_can_be_undone() {
    let (sources, view) = Sources::shown();
    let theirs = PLAYER.replace("/// Looks.", "/// Looks far.");
    sources.write("player.rs", &theirs);
    let shown = view.until("player.rs", "the edit", |shown| shown.version == 1);
    assert_eq!((shown.text, &shown.state["by"], &shown.state["saved"]), (theirs, &json!("file"), &json!(true)));
    // A text of the same length, written within the resolution of the clock of some file systems.
    let same_length = PLAYER.replace("/// Looks.", "/// Leaps far.").replace("Leaps far", "Looks fat");
    sources.write("player.rs", &same_length);
    view.until("player.rs", "the second edit", |shown| shown.text == same_length);
    view.ask(json!({ "type": "undo_file", "file": "player.rs" })).unwrap();
    view.ask(json!({ "type": "undo_file", "file": "player.rs" })).unwrap();
    view.until_saved("player.rs");
    assert_eq!(sources.read("player.rs"), PLAYER);
}

/// Edits the same word on the page and in the file; returns the text of the file.
fn conflict(sources: &Sources, view: &View) -> String {
    view.type_behind("player.rs", "let _ = ", "2").unwrap();
    let theirs = PLAYER.replace("= 1", "= 3");
    sources.write("player.rs", &theirs);
    let shown = view.until("player.rs", "the conflict", |shown| shown.state["conflict"].is_object());
    let conflict = &shown.state["conflict"];
    assert_eq!((&conflict["base"], &conflict["theirs"]), (&json!(PLAYER), &json!(theirs)));
    assert_eq!(conflict["ours"], PLAYER.replace("= 1", "= 21"));
    assert!(!conflict["spans"].as_array().unwrap().is_empty());
    assert!(text_of(view.ask(json!({ "type": "save_file", "file": "player.rs" }))).contains("another program"));
    assert_eq!(sources.read("player.rs"), theirs, "nothing is overwritten");
    theirs
}

#[test]
fn a_conflict_is_shown_and_ends_as_it_was_chosen() {
    for (keep, expected) in [
        (json!("ours"), PLAYER.replace("= 1", "= 21")),
        (json!("theirs"), PLAYER.replace("= 1", "= 3")),
        (json!({ "text": "// both\n" }), "// both\n".to_owned()),
    ] {
        let sources = Sources::player();
        let bench = sources.bench();
        let view = View::of(&bench, "player.rs");
        conflict(&sources, &view);
        let late = View::of(&bench, "player.rs");
        assert!(late.shown("player.rs").state["conflict"].is_object(), "a page that comes later sees it");
        resolve(&view, &keep);
        view.until_saved("player.rs");
        assert_eq!((&sources.read("player.rs"), &view.shown("player.rs").text), (&expected, &expected));
        late.until("player.rs", "its end", |shown| shown.state["conflict"].is_null());
        text_of(view.ask(json!({ "type": "resolve_file", "file": "player.rs", "keep": "ours" })));
    }
}

#[test]
fn a_conflict_ends_when_a_side_takes_its_edit_back() {
    let (sources, view) = Sources::shown();
    let theirs = conflict(&sources, &view);
    view.ask(json!({ "type": "undo_file", "file": "player.rs" })).unwrap();
    view.until("player.rs", "their text", |shown| shown.text == theirs && shown.state["conflict"].is_null());
    let (sources, view) = Sources::shown();
    conflict(&sources, &view);
    sources.write("player.rs", PLAYER);
    view.until("player.rs", "its end", |shown| shown.state["conflict"].is_null());
    view.until_saved("player.rs");
    assert!(sources.read("player.rs").contains("= 21"));
}

#[test]
fn both_texts_of_an_open_conflict_are_kept_at_the_end() {
    let sources = Sources::player();
    let bench = sources.bench();
    let view = View::of(&bench, "player.rs");
    let theirs = conflict(&sources, &view);
    drop(view);
    drop(bench);
    assert_eq!(sources.read("player.rs"), theirs);
    assert!(sources.read("player.rs.unsaved-1").contains("= 21"));
}

#[test]
fn deleted_file_keeps_its_text_and_can_return() {
    let (sources, view) = Sources::shown();
    fs::remove_file(sources.path("player.rs")).unwrap();
    let shown = view.until("player.rs", "deleted", |shown| shown.state["deleted"] == true);
    assert_eq!((shown.text.as_str(), &shown.state["saved"]), (PLAYER, &json!(false)));
    view.type_behind("player.rs", "let _ = ", "2 + ").unwrap();
    // An edit alone does not create the deleted file again.
    std::thread::sleep(std::time::Duration::from_millis(1200));
    assert!(!sources.path("player.rs").exists());
    view.ask(json!({ "type": "save_file", "file": "player.rs" })).unwrap();
    view.until("player.rs", "saved", |shown| shown.state["saved"] == true && shown.state["deleted"] == false);
    assert!(sources.read("player.rs").contains("2 + 1"));
    // Another program creates the file again.
    fs::remove_file(sources.path("player.rs")).unwrap();
    view.until("player.rs", "deleted again", |shown| shown.state["deleted"] == true);
    sources.write("player.rs", PLAYER);
    view.until("player.rs", "back", |shown| shown.state["deleted"] == false && shown.text == PLAYER);
}

#[cfg(unix)]
#[test]
fn read_only_file_is_reported_and_saved_later() {
    use std::os::unix::fs::PermissionsExt;
    let (sources, view) = Sources::shown();
    let allow = |mode| fs::set_permissions(sources.path("player.rs"), fs::Permissions::from_mode(mode)).unwrap();
    allow(0o444);
    view.until("player.rs", "read-only", |shown| shown.state["readonly"] == true);
    view.type_behind("player.rs", "let _ = ", "2 + ").unwrap();
    let shown = view.until("player.rs", "the problem", |shown| shown.state["problem"] != "");
    assert!(shown.state["problem"].as_str().unwrap().contains("read-only"), "{}", shown.state);
    assert!(text_of(view.ask(json!({ "type": "save_file", "file": "player.rs" }))).contains("read-only"));
    assert_eq!(sources.read("player.rs"), PLAYER);
    allow(0o644);
    view.until("player.rs", "saved", |shown| shown.state["saved"] == true && shown.state["problem"] == "");
    assert!(sources.read("player.rs").contains("2 + 1"));
}

#[test]
fn a_file_that_becomes_unreadable_keeps_its_text() {
    let (sources, view) = Sources::shown();
    fs::write(sources.path("player.rs"), b"\xff\xfe").unwrap();
    let shown = view.until("player.rs", "the problem", |shown| shown.state["problem"] != "");
    assert_eq!(shown.text, PLAYER);
    sources.write("player.rs", &"x".repeat(2 << 20));
    view.until("player.rs", "too long", |shown| shown.state["problem"].as_str().unwrap().contains("bytes"));
    assert_eq!(view.shown("player.rs").text, PLAYER);
    sources.write("player.rs", "// short\n");
    view.until("player.rs", "its text", |shown| shown.text == "// short\n" && shown.state["problem"] == "");
}
