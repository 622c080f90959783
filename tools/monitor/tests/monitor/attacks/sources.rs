//! Attacks on the sources.

use std::fs;
use std::net::{TcpListener, TcpStream};
use std::sync::Arc;

use bica_monitor::program::Program;
use bica_monitor::sessions::{Manager, Options};
use bica_monitor::web::{Web, WebOptions};
use serde_json::{Value, json};
use tungstenite::{Message, WebSocket};

use crate::attacks::target::{TOKEN, closed, message, target_with};
use crate::page::Folder;

const TEXT: &str = "#[component]\nimpl A {\n    fn step(&mut self) {}\n}\n";

/// A folder with `src/a.rs` and a file outside of `src`, removed at the end.
struct Sources(Folder);

impl Sources {
    fn new() -> Self {
        let folder = Folder::new("attack");
        fs::create_dir_all(folder.0.join("src")).unwrap();
        fs::write(folder.0.join("src/a.rs"), TEXT).unwrap();
        fs::write(folder.0.join("secret.rs"), "// secret\n").unwrap();
        Self(folder)
    }

    fn options(&self) -> Options {
        Options { source: Some(self.0.0.join("src")), ..Options::default() }
    }

    fn secret(&self) -> String {
        fs::read_to_string(self.0.0.join("secret.rs")).unwrap()
    }
}

/// Sends a request about sources; returns its answer.
fn ask(page: &mut WebSocket<TcpStream>, id: u32, request: &Value) -> Value {
    page.send(Message::text(json!({ "id": id, "type": "source", "request": request }).to_string())).unwrap();
    loop {
        let got = message(page).unwrap();
        assert!(!got.to_string().contains("secret\\n"), "{got}");
        if got["type"] == "answer" && got["id"] == id {
            return got;
        }
    }
}

#[test]
fn no_request_leads_out_of_the_folder_of_sources() {
    let sources = Sources::new();
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("../secret.rs", sources.0.0.join("src/link.rs")).unwrap();
        std::os::unix::fs::symlink("..", sources.0.0.join("src/up")).unwrap();
    }
    let target = target_with(None, sources.options());
    let mut page = target.page();
    let mut id = 0;
    for file in [
        "../secret.rs",
        "link.rs",
        "up/secret.rs",
        "/etc/passwd",
        "src/../../secret.rs",
        "a.rs/../../secret.rs",
        "\u{0}",
        "..",
        ".",
        "up",
        "C:\\secret.rs",
        &"a/".repeat(5000),
    ] {
        let edit = json!([{ "edit": "replace", "span": [0, 0], "text": "evil" }]);
        let positions = json!([{ "component": "A", "state": "x", "x": 0, "y": 0 }]);
        for request in [
            json!({ "type": "open_file", "file": file }),
            json!({ "type": "edit_file", "file": file, "version": 0, "edits": edit }),
            json!({ "type": "save_file", "file": file }),
            json!({ "type": "move_states", "file": file, "positions": positions }),
            json!({ "type": "change_note", "file": file, "component": "A", "to": { "at": null, "text": "evil" } }),
            json!({ "type": "draw_file", "file": file, "component": "A", "format": "svg" }),
            json!({ "type": "uses", "file": file, "component": "A", "function": "step" }),
            json!({ "type": "new_component", "name": "Evil", "folder": file, "dry": false }),
            json!({ "type": "new_component", "name": "Evil", "folder": "", "tree": file, "dry": false }),
            json!({ "type": "rename_uses", "file": "a.rs", "component": "A", "function": "step", "to": "evil",
                "places": [{ "file": file, "span": [0, 4] }] }),
        ] {
            id += 1;
            let answer = ask(&mut page, id, &request);
            assert!(answer["error"]["help"].is_string(), "{request}: {answer}");
        }
    }
    assert_eq!(
        (sources.secret().as_str(), fs::read_to_string(sources.0.0.join("src/a.rs")).unwrap().as_str()),
        ("// secret\n", TEXT)
    );
    assert_eq!(sources.0.names(), ["secret.rs", "src"]);
}

#[test]
fn huge_text_is_answered_and_a_larger_ends_the_page() {
    let sources = Sources::new();
    let target = target_with(None, sources.options());
    let mut page = target.page();
    let edit = |length: usize| {
        json!({ "type": "edit_file", "file": "a.rs", "version": 0,
            "edits": [{ "edit": "set_body", "component": "A", "function": "step", "body": "x;\n".repeat(length / 3) }] })
    };
    let answer = ask(&mut page, 1, &edit(1 << 20));
    assert!(answer["error"]["text"].as_str().unwrap().contains("bytes"), "{answer}");
    assert!(ask(&mut page, 2, &json!({ "type": "open_file", "file": "a.rs" }))["error"].is_null());
    let text = json!({ "id": 3, "type": "source", "request": edit(5 << 20) }).to_string();
    // The server may close while this is being written.
    let _ = page.send(Message::text(text));
    closed(&mut page);
    assert_eq!(fs::read_to_string(sources.0.0.join("src/a.rs")).unwrap(), TEXT);
}

#[test]
fn unknown_requests_and_fields_are_refused() {
    let sources = Sources::new();
    let target = target_with(None, sources.options());
    let mut page = target.page();
    for (id, request) in [
        json!({ "type": "delete_file", "file": "a.rs" }),
        json!({ "type": "open_file", "file": "a.rs", "path": "/" }),
        json!({ "type": "edit_file", "file": "a.rs", "version": -1, "edits": [] }),
        json!({ "type": "edit_file", "file": "a.rs", "version": 0, "edits": [{ "edit": "run", "command": "sh" }] }),
        json!({ "type": "run", "seed": 0, "robots": 0, "program": "sh" }),
        json!("check"),
    ]
    .into_iter()
    .enumerate()
    {
        let answer = ask(&mut page, id as u32 + 1, &request);
        assert!(answer["error"]["text"].as_str().unwrap().contains("not understood"), "{request}: {answer}");
    }
}

#[test]
fn sources_are_for_no_other_computer() {
    let sources = Sources::new();
    let start = |options: Options| {
        let listener = TcpListener::bind("0.0.0.0:0").unwrap();
        let web = WebOptions { token: Some(TOKEN.to_owned()), ..WebOptions::default() };
        Web::start(listener, web, Arc::new(Manager::new(options, Program::default())))
    };
    assert!(start(Options::default()).is_ok());
    let error = start(sources.options()).err().unwrap().to_string();
    assert!(error.contains("this computer only"), "{error}");
}
