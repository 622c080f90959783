//! Edits, drawings, searches.

use bica_monitor::sessions::Options;
use serde_json::{Value, json};

use crate::page::options;
use crate::sources::view::{PLAYER, Sources, View, text_of};

#[test]
fn all_pages_share_one_text_and_history() {
    let sources = Sources::player();
    let bench = sources.bench();
    let (one, other) = (View::of(&bench, "player.rs"), View::of(&bench, "player.rs"));
    let shown = one.shown("player.rs");
    assert_eq!((shown.version, shown.text.as_str()), (0, PLAYER));
    assert_eq!(shown.state["model"]["components"][0]["name"]["text"], "Player");
    assert_eq!(shown.state["saved"], true);
    let answer =
        one.edit("player.rs", &json!([{ "edit": "add_state", "component": "Player", "name": "wait" }])).unwrap();
    assert_eq!(answer, json!({ "version": 1 }));
    other.until("player.rs", "the edit", |shown| shown.version == 1);
    assert_eq!(other.shown("player.rs").state["page"], one.id());
    assert_eq!(other.shown("player.rs").state["by"], "page");
    other.type_behind("player.rs", "let _ = 1;", " // typed").unwrap();
    one.until("player.rs", "typing", |shown| shown.text.contains("// typed") && shown.text.contains("fn wait"));
    // Undo reverts the last step, of any page.
    one.ask(json!({ "type": "undo_file", "file": "player.rs" })).unwrap();
    assert!(!one.shown("player.rs").text.contains("// typed"));
    one.ask(json!({ "type": "undo_file", "file": "player.rs" })).unwrap();
    assert_eq!(one.shown("player.rs").text, PLAYER);
    assert_eq!(
        (&one.shown("player.rs").state["undo"], &one.shown("player.rs").state["redo"]),
        (&json!(false), &json!(true))
    );
    assert!(text_of(one.ask(json!({ "type": "undo_file", "file": "player.rs" }))).contains("no step to undo"));
    one.ask(json!({ "type": "redo_file", "file": "player.rs" })).unwrap();
    assert!(one.shown("player.rs").text.contains("fn wait"));
    one.until_saved("player.rs");
    assert_eq!(sources.read("player.rs"), one.shown("player.rs").text);
}

#[test]
fn edit_by_old_offsets_is_refused_but_not_by_name() {
    let (_sources, view) = Sources::shown();
    let edit = |version: u64, edit: Value| {
        view.ask(json!({ "type": "edit_file", "file": "player.rs", "version": version, "edits": [edit] }))
    };
    edit(0, json!({ "edit": "set_docs", "component": "Player", "function": "look", "docs": "Looks around." })).unwrap();
    let typed = json!({ "edit": "replace", "span": [0, 0], "text": "// " });
    assert_eq!(edit(0, typed.clone()).unwrap_err()["stale"], true);
    edit(0, json!({ "edit": "set_initial", "component": "Player", "state": "walk" })).unwrap();
    edit(2, typed).unwrap();
    assert!(view.shown("player.rs").text.starts_with("// //! A player."));
}

#[test]
fn refused_edits_say_why_and_change_nothing() {
    let (_sources, view) = Sources::shown();
    let add = |name: &str| json!([{ "edit": "add_state", "component": "Player", "name": name }]);
    let body = |body: &str| json!([{ "edit": "set_body", "component": "Player", "function": "walk", "body": body }]);
    for (edits, why) in [
        (add("fn"), "keyword"),
        (add("look"), "look"),
        (add("a b"), "a b"),
        (add("x\nstruct Evil"), "name"),
        (add(""), "name"),
        (body("}"), "Rust"),
        (json!([{ "edit": "delete", "component": "Player", "function": "nothing" }]), "nothing"),
        (json!([{ "edit": "replace", "span": [5, 2], "text": "" }]), "does not exist"),
        (json!([{ "edit": "replace", "span": [0, 1_000_000], "text": "" }]), "does not exist"),
    ] {
        let text = text_of(view.edit("player.rs", &edits));
        assert!(text.to_lowercase().contains(&why.to_lowercase()), "{edits}: {text}");
    }
    // The second of two edits is refused: the first one is not applied.
    let both = json!([add("good")[0], add("fn")[0]]);
    text_of(view.edit("player.rs", &both));
    assert_eq!((view.shown("player.rs").version, view.shown("player.rs").text.as_str()), (0, PLAYER));
}

#[test]
fn moved_states_follow_a_new_name() {
    let (sources, view) = Sources::shown();
    let moved = |state: &str, x: i32| {
        let positions = json!([{ "component": "Player", "state": state, "x": x, "y": 80 }]);
        view.ask(json!({ "type": "move_states", "file": "player.rs", "positions": positions }))
    };
    moved("walk", 320).unwrap();
    assert_eq!(sources.read("player.vicode"), "Player walk 320 80\n");
    let position = |view: &View, state: &str| {
        let all = view.shown("player.rs").state["positions"].clone();
        all.as_array().unwrap().iter().find(|one| one["state"] == state).cloned()
    };
    assert_eq!(position(&view, "walk").unwrap()["placed"], true);
    assert_eq!(position(&view, "look").unwrap()["placed"], false);
    let rename = json!([{ "edit": "rename", "component": "Player", "function": "walk", "to": "run" }]);
    view.edit("player.rs", &rename).unwrap();
    assert_eq!(position(&view, "run").unwrap()["x"], 320);
    view.ask(json!({ "type": "save_file", "file": "player.rs" })).unwrap();
    assert_eq!(sources.read("player.vicode"), "Player run 320 80\n");
    view.ask(json!({ "type": "undo_file", "file": "player.rs" })).unwrap();
    assert_eq!(position(&view, "walk").unwrap()["x"], 320);
    view.ask(json!({ "type": "save_file", "file": "player.rs" })).unwrap();
    assert_eq!(sources.read("player.vicode"), "Player walk 320 80\n");
    // A comment that is not closed hides `walk` while a visible state is moved.
    view.type_behind("player.rs", "fn look(&mut self) {", " /* ").unwrap();
    assert!(position(&view, "walk").is_none(), "the state is hidden");
    moved("look", 40).unwrap();
    assert_eq!(sources.read("player.vicode"), "Player look 40 80\nPlayer walk 320 80\n");
    view.ask(json!({ "type": "undo_file", "file": "player.rs" })).unwrap();
    assert_eq!(position(&view, "walk").unwrap()["x"], 320);
    // Only names in the model are accepted: no line can be injected.
    text_of(moved("walk 1 1\nEvil state", 1));
    text_of(moved("walk", i32::MIN + 1));
    // Another program moves a state.
    sources.write("player.vicode", "Player walk 5 6\nOther state 1 2\n");
    view.wait("the layout", |_| (position(&view, "walk").unwrap()["x"] == 5).then_some(()));
    let answer = view.ask(json!({ "type": "arrange_states", "file": "player.rs", "component": "Player" })).unwrap();
    assert!(answer["positions"].as_array().unwrap().iter().all(|one| one["placed"] == false));
    assert_eq!(sources.read("player.vicode"), "Other state 1 2\n", "lines of other components stay");
    // A layout file with an unresolved merge conflict is not overwritten.
    sources.write("player.vicode", "<<<<<<< ours\n");
    view.until("player.rs", "the mistake", |shown| shown.state["problem"].as_str().unwrap().contains("<<<<"));
    assert!(text_of(moved("walk", 7)).contains("line 1"));
    assert_eq!(sources.read("player.vicode"), "<<<<<<< ours\n");
}

#[test]
fn notes_stay_while_the_text_is_broken() {
    let (sources, view) = Sources::shown();
    let change = |from: &Value, to: &Value| {
        view.ask(json!({ "type": "change_note", "file": "player.rs", "component": "Player", "from": from, "to": to }))
    };
    let note = |text: &str| json!({ "at": null, "text": text });
    let (smuggled, placed) = (note("one\nEvil state 1 2"), json!({ "at": { "x": -8, "y": 16 }, "text": "two" }));
    change(&Value::Null, &smuggled).unwrap();
    change(&Value::Null, &placed).unwrap();
    let both = "Player * - - \"one\\nEvil state 1 2\"\nPlayer * -8 16 \"two\"\n";
    assert_eq!(sources.read("player.vicode"), both);
    let drawing = view.ask(json!({ "type": "draw_file", "file": "player.rs", "component": "Player", "format": "svg" }));
    assert!(drawing.unwrap()["text"].as_str().unwrap().contains(">Evil state 1 2<"));
    // A comment that is not closed hides states and components.
    view.type_behind("player.rs", "fn look(&mut self) {", " /* ").unwrap();
    view.ask(json!({ "type": "save_file", "file": "player.rs" })).unwrap();
    assert_eq!(sources.read("player.vicode"), both);
    view.ask(json!({ "type": "undo_file", "file": "player.rs" })).unwrap();
    change(&placed, &Value::Null).unwrap();
    assert_eq!(view.shown("player.rs").state["notes"][0]["text"], "one\nEvil state 1 2");
    assert!(text_of(change(&placed, &note("late"))).contains("not as it was"));
    for wrong in
        [note(" "), note("\u{7}"), note(&"x".repeat(1001)), json!({ "at": { "x": i32::MIN, "y": 0 }, "text": "x" })]
    {
        text_of(change(&Value::Null, &wrong));
    }
    change(&smuggled, &Value::Null).unwrap();
    assert!(!sources.path("player.vicode").exists());
}

#[test]
fn opening_and_closing_changes_no_byte() {
    let hostile =
        "\u{feff}//! Text\r\n#[component]\r\nimpl A {\r\n  fn step(&mut self){ /* ä */ }\r\n}\r\nfn broken( {";
    let sources = Sources::new(&[("a.rs", hostile), ("player.rs", PLAYER)]);
    {
        let bench = sources.bench();
        let view = View::of(&bench, "a.rs");
        view.ask(json!({ "type": "open_file", "file": "player.rs" })).unwrap();
        assert_eq!(view.shown("a.rs").text, hostile);
        view.ask(json!({ "type": "save_file", "file": "a.rs" })).unwrap();
        view.ask(json!({ "type": "close_file", "file": "a.rs" })).unwrap();
    }
    assert_eq!((sources.read("a.rs").as_str(), sources.read("player.rs").as_str()), (hostile, PLAYER));
    let names: Vec<_> = std::fs::read_dir(sources.path("")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(names.len(), 2, "{names:?}");
}

#[test]
fn sources_are_listed_and_uses_are_found_and_renamed() {
    let user = "use super::Player;\n\n\
        fn f(player: &Player, other: &Other) -> u32 {\n    Player::steps(player) + other.steps() + any().steps()\n}\n";
    let tree = "bica::activation_tree! {\n    struct Robot { root: Player, cycle_hz: 10, components: [Player] }\n}\n";
    let broken = "#[component]\nimpl Half {\n    fn step(&mut self";
    let sources = Sources::new(&[
        ("player.rs", PLAYER),
        ("deep/user.rs", user),
        ("tree.rs", tree),
        ("broken.rs", broken),
        ("target/built.rs", PLAYER),
        (".hidden/hidden.rs", PLAYER),
        ("plain.rs", "fn main() {}"),
    ]);
    std::fs::write(sources.path("latin.rs"), b"#[component] \xff").unwrap();
    let bench = sources.bench();
    let view = View::of(&bench, "player.rs");
    let list = view.ask(json!({ "type": "sources" })).unwrap();
    let names: Vec<_> = list.as_array().unwrap().iter().map(|one| one["file"].as_str().unwrap()).collect();
    assert_eq!(names, ["broken.rs", "latin.rs", "player.rs", "tree.rs"]);
    assert_eq!(list[2]["components"], json!([{ "key": "Player", "name": "Player", "machine": true }]));
    assert_eq!(list[3]["trees"], json!(["Robot"]));
    assert!(list[1]["problem"].as_str().unwrap().contains("UTF-8"));

    let uses = json!({ "type": "uses", "file": "player.rs", "component": "Player", "function": "steps" });
    let uses = view.ask(uses).unwrap();
    assert_eq!(uses.as_array().unwrap().len(), 2, "{uses}");
    assert_eq!((&uses[0]["file"], &uses[0]["line"]), (&json!("deep/user.rs"), &json!(4)));
    assert_eq!((&uses[0]["certain"], &uses[1]["certain"]), (&json!(true), &json!(false)));
    let rename = |span: &Value| {
        view.ask(json!({ "type": "rename_uses", "file": "player.rs", "component": "Player", "function": "steps",
            "to": "paces", "places": [{ "file": "deep/user.rs", "span": span }] }))
    };
    let alone = json!([{ "edit": "rename", "component": "Player", "function": "steps", "to": "paces" }]);
    for incomplete in [rename(&json!([0, 3])), view.edit("player.rs", &alone)] {
        assert!(text_of(incomplete).contains("is also used in deep/user.rs:4"));
    }
    let files = rename(&uses[0]["span"]).unwrap();
    assert_eq!(files["files"].as_array().unwrap().len(), 2, "{files}");
    view.ask(json!({ "type": "save_file", "file": "deep/user.rs" })).unwrap();
    view.ask(json!({ "type": "save_file", "file": "player.rs" })).unwrap();
    assert!(sources.read("deep/user.rs").contains("Player::paces(player) + other.steps()"));
    assert!(sources.read("player.rs").contains("pub fn paces(&self)"));
    for (request, file, name) in [("undo_file", "player.rs", "steps"), ("redo_file", "deep/user.rs", "paces")] {
        view.ask(json!({ "type": request, "file": file })).unwrap();
        for file in ["player.rs", "deep/user.rs"] {
            view.ask(json!({ "type": "save_file", "file": file })).unwrap();
            assert!(sources.read(file).contains(&format!("{name}(")), "{request} {file}");
        }
    }
    let typed = json!([{ "edit": "replace", "span": [0, 0], "text": " " }]);
    let version = files["files"][1]["version"].as_u64().unwrap() + 2;
    view.ask(json!({ "type": "edit_file", "file": "deep/user.rs", "version": version, "edits": typed })).unwrap();
    let refused = text_of(view.ask(json!({ "type": "undo_file", "file": "player.rs" })));
    assert!(refused.contains("`deep/user.rs` was changed since"), "{refused}");
}

#[test]
fn a_new_component_is_made_as_it_was_shown() {
    let library = "mod behaviour;\n\nbica::activation_tree! {\n    struct Robot { root: Player, cycle_hz: 10, components: [Player] }\n}\n";
    let files = [
        ("lib.rs", library),
        ("behaviour/mod.rs", "mod player;\n\npub use self::player::Player;\n"),
        ("behaviour/player.rs", PLAYER),
    ];
    let sources = Sources::new(&files);
    let bench = sources.bench();
    let view = View::of(&bench, "lib.rs");
    let make = |name: &str, folder: &str, dry: bool| {
        view.ask(json!({ "type": "new_component", "name": name, "folder": folder, "tree": "lib.rs",
            "import": "crate::behaviour", "dry": dry }))
    };
    let shown = make("BallKeeper", "behaviour", true).unwrap();
    assert!(!sources.path("behaviour/ball_keeper.rs").exists());
    assert_eq!(sources.read("lib.rs"), library);
    let made = make("BallKeeper", "behaviour", false).unwrap();
    assert_eq!(shown, made);
    assert_eq!(made["file"], "behaviour/ball_keeper.rs");
    assert!(sources.read("behaviour/mod.rs").contains("mod ball_keeper;"));
    assert!(sources.read("lib.rs").contains("components: [Player, BallKeeper]"));
    assert!(view.shown("lib.rs").text.contains("BallKeeper"), "the open file shows it");
    view.ask(json!({ "type": "open_file", "file": "behaviour/ball_keeper.rs" })).unwrap();
    for (name, folder) in [
        ("BallKeeper", "behaviour"),
        ("fn", "behaviour"),
        ("Self", "behaviour"),
        ("../Evil", "behaviour"),
        ("Evil", ".."),
        ("Evil", "/tmp"),
        ("Evil", "behaviour/../.."),
        ("Evil", "nowhere"),
    ] {
        text_of(make(name, folder, false));
    }
}

#[test]
fn machines_are_drawn() {
    let sources = Sources::player();
    let bench = sources.bench();
    let view = View::new(&bench);
    let draw = |format: &str, component: &str| {
        view.ask(json!({ "type": "draw_file", "file": "player.rs", "component": component, "format": format }))
    };
    assert!(draw("svg", "Player").unwrap()["text"].as_str().unwrap().contains("<svg"));
    assert!(draw("mermaid", "Player").unwrap()["text"].as_str().unwrap().contains("look --> walk"));
    assert!(draw("dot", "Player").unwrap()["text"].as_str().unwrap().contains("digraph"));
    assert!(draw("png", "Player").unwrap()["base64"].as_str().unwrap().starts_with("iVBORw0KGgo"));
    text_of(draw("svg", "Nobody"));
}

#[test]
fn without_a_folder_and_read_only_nothing_is_edited() {
    let sources = Sources::player();
    let none = sources.bench_with(options(&sources.0));
    assert!(text_of(View::new(&none).ask(json!({ "type": "sources" }))).contains("no folder of sources"));
    let missing = sources.bench_with(Options { source: Some(sources.path("nowhere")), ..options(&sources.0) });
    text_of(View::new(&missing).ask(json!({ "type": "sources" })));
    let bench = sources.bench_with(Options { read_only: true, build: true, ..sources.options() });
    let view = View::of(&bench, "player.rs");
    view.ask(json!({ "type": "sources" })).unwrap();
    for request in [
        json!({ "type": "edit_file", "file": "player.rs", "version": 0, "edits": [] }),
        json!({ "type": "undo_file", "file": "player.rs" }),
        json!({ "type": "redo_file", "file": "player.rs" }),
        json!({ "type": "save_file", "file": "player.rs" }),
        json!({ "type": "resolve_file", "file": "player.rs", "keep": "ours" }),
        json!({ "type": "move_states", "file": "player.rs", "positions": [] }),
        json!({ "type": "arrange_states", "file": "player.rs", "component": "Player" }),
        json!({ "type": "change_note", "file": "player.rs", "component": "Player", "to": { "at": null, "text": "x" } }),
        json!({ "type": "new_component", "name": "New", "folder": "", "dry": true }),
        json!({ "type": "rename_uses", "file": "player.rs", "component": "Player", "function": "steps", "to": "x", "places": [] }),
        json!({ "type": "check" }),
        json!({ "type": "run", "seed": 0, "robots": 0 }),
        json!({ "type": "stop_run" }),
    ] {
        assert!(text_of(view.ask(request.clone())).contains("only watch"), "{request}");
    }
}
