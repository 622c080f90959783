//! A simulated page that shows files, and applies received changes to its copies.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::sync::Arc;

use bica_monitor::protocol::{Request, SourceRequest};
use bica_monitor::sessions::Options;
use serde_json::{Value, json};

use crate::page::{self, Bench, Folder, Got, Page, answer};

/// A file with a machine.
pub(crate) const PLAYER: &str = "\
//! A player.

use bica::prelude::*;

/// Plays.
pub struct Player;

#[component(hz = 20)]
impl Player {
    /// Looks.
    #[state(initial)]
    fn look(&mut self) {}

    /// Walks.
    #[state]
    fn walk(&mut self) {
        let _ = 1;
    }

    #[transition(look -> walk)]
    fn seen(&self) -> bool {
        true
    }

    #[transition(walk -> look)]
    fn lost(&self) -> bool {
        false
    }

    /// Steps.
    #[output]
    pub fn steps(&self) -> u32 {
        0
    }
}
";

/// A folder of sources, removed at the end.
pub(crate) struct Sources(pub(crate) Arc<Folder>);

impl Sources {
    pub(crate) fn new(files: &[(&str, &str)]) -> Self {
        let sources = Self(Arc::new(Folder::new("sources")));
        for (name, text) in files {
            sources.write(name, text);
        }
        sources
    }

    /// One file `player.rs`.
    pub(crate) fn player() -> Self {
        Self::new(&[("player.rs", PLAYER)])
    }

    /// One file `player.rs`, opened by a page.
    pub(crate) fn shown() -> (Self, View) {
        let sources = Self::player();
        let view = View::of(&sources.bench(), "player.rs");
        (sources, view)
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.0.join("src").join(name)
    }

    pub(crate) fn write(&self, name: &str, text: &str) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    pub(crate) fn options(&self) -> Options {
        fs::create_dir_all(self.path("")).unwrap();
        Options { source: Some(self.path("")), ..page::options(&self.0) }
    }

    pub(crate) fn bench(&self) -> Arc<Bench> {
        self.bench_with(self.options())
    }

    pub(crate) fn bench_with(&self, options: Options) -> Arc<Bench> {
        Bench::of(&self.0, options)
    }
}

/// The page's copy of a file.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    pub(crate) version: u64,
    pub(crate) text: String,
    /// The last message about the file.
    pub(crate) state: Value,
}

/// A page with copies of the files that it has opened.
pub(crate) struct View {
    page: Page,
    files: RefCell<BTreeMap<String, Shown>>,
}

impl View {
    pub(crate) fn new(bench: &Arc<Bench>) -> Self {
        Self { page: Page::new(bench), files: RefCell::default() }
    }

    /// A page that has opened a file.
    pub(crate) fn of(bench: &Arc<Bench>, file: &str) -> Self {
        let view = Self::new(bench);
        view.ask(json!({ "type": "open_file", "file": file })).unwrap();
        view
    }

    pub(crate) fn id(&self) -> u64 {
        self.page.id
    }

    pub(crate) fn shown(&self, file: &str) -> Shown {
        self.files.borrow()[file].clone()
    }

    /// Waits for a message, and applies the received changes of files.
    pub(crate) fn wait<T>(&self, what: &str, mut found: impl FnMut(&Value) -> Option<T>) -> T {
        self.page.wait(what, |got| {
            let Got::Message(message) = got else { return None };
            self.take(message);
            found(message)
        })
    }

    fn take(&self, message: &Value) {
        let mut files = self.files.borrow_mut();
        let Some(file) = message["file"].as_str().map(str::to_owned) else { return };
        let version = message["version"].as_u64().unwrap();
        if message["type"] == "source" {
            let text = message["text"].as_str().unwrap().to_owned();
            files.insert(file, Shown { version, text, state: message.clone() });
        } else if message["type"] == "source_changed" {
            let shown = files.get_mut(&file).expect("only files that were opened");
            assert_eq!(message["from_version"], shown.version, "no change is lost");
            for step in message["splices"].as_array().unwrap() {
                for splice in step.as_array().unwrap().iter().rev() {
                    let place = |index: usize| splice["span"][index].as_u64().unwrap() as usize;
                    shown.text.replace_range(place(0)..place(1), splice["text"].as_str().unwrap());
                }
            }
            assert_eq!(message.get("model").is_some(), version != shown.version, "a model for each new text");
            shown.version = version;
            shown.state = message.clone();
        }
    }

    /// Sends a request about sources, as JSON, and waits for its answer.
    pub(crate) fn ask(&self, request: Value) -> Result<Value, Value> {
        let request: SourceRequest = serde_json::from_value(request).expect("a request");
        self.request(Request::Source { request })
    }

    pub(crate) fn request(&self, request: Request) -> Result<Value, Value> {
        let id = self.page.send(request);
        self.wait("answer", |message| answer(message, id))
    }

    /// Applies edits by name.
    pub(crate) fn edit(&self, file: &str, edits: &Value) -> Result<Value, Value> {
        let version = self.shown(file).version;
        self.ask(json!({ "type": "edit_file", "file": file, "version": version, "edits": edits }))
    }

    /// Inserts a text after another one.
    pub(crate) fn type_behind(&self, file: &str, before: &str, text: &str) -> Result<Value, Value> {
        let at = self.shown(file).text.find(before).expect("the text is there") + before.len();
        self.edit(file, &json!([{ "edit": "replace", "span": [at, at], "text": text }]))
    }

    /// Waits until `is` returns true for a file; returns the file.
    pub(crate) fn until(&self, file: &str, what: &str, is: impl Fn(&Shown) -> bool) -> Shown {
        if !is(&self.shown(file)) {
            self.wait(what, |message| {
                (message["file"] == file && message["version"].is_u64() && is(&self.shown(file))).then_some(())
            });
        }
        self.shown(file)
    }

    /// Waits until the file is saved.
    pub(crate) fn until_saved(&self, file: &str) {
        self.until(file, "saved", |shown| shown.state["saved"] == true);
    }
}

/// Returns the text of an error; panics if there is none.
pub(crate) fn text_of(result: Result<Value, Value>) -> String {
    let error = result.expect_err("it is refused");
    assert!(!error["help"].as_str().unwrap().is_empty(), "{error}");
    error["text"].as_str().unwrap().to_owned()
}
