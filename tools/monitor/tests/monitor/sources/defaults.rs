//! A tuned value as the new default.

use std::sync::Arc;

use bica_link::Plain;
use bica_monitor::protocol::Request;
use serde_json::Value;

use crate::page::Bench;
use crate::sessions::world::{find, room, set_gain};
use crate::sources::view::{Sources, View, text_of};

/// The source of the lamp.
const LAMP: &str = include_str!("../lamp.rs");

/// Shows the world of the lamp on a page; returns the page and the description.
fn shown(bench: &Arc<Bench>) -> (View, Value) {
    bench.manager.open(room()).unwrap();
    let view = View::new(bench);
    let description =
        view.wait("the tree", |message| (message["type"] == "described").then(|| message["description"].clone()));
    (view, description)
}

#[test]
fn tuned_value_becomes_the_default_of_its_source() {
    let sources = Sources::new(&[("lamp.rs", LAMP)]);
    let (view, description) = shown(&sources.bench());
    let save = |(component, param): (usize, usize)| view.request(Request::SaveSource { component, param });
    let gain = find(&description, "Lamp", "params", "gain");
    view.request(Request::Acquire {}).unwrap();
    view.request(set_gain(Plain::Number(1.0))).unwrap();
    let saved = save(gain).unwrap();
    assert_eq!(saved["path"], "lamp.rs");
    let line = "+    #[param(default = 1.0, range = 0.05..=1.0, step = 0.05)]";
    assert!(saved["diff"].as_str().unwrap().contains(line), "{saved}");
    let text = LAMP.replace("default = 0.7,", "default = 1.0,");
    assert_eq!(sources.read("lamp.rs"), text);
    // The places of declaration and reads, in the current text.
    let uses = view.request(Request::ParamUses { component: gain.0, param: gain.1 }).unwrap();
    let lines = uses.as_array().unwrap().iter().map(|one| (one["file"].clone(), one["text"].clone()));
    let expected = text.lines().filter(|line| line.contains(".gain") || line.trim() == "gain: f32,");
    let expected = expected.map(|line| (Value::from("lamp.rs"), Value::from(line.trim())));
    assert_eq!(lines.collect::<Vec<_>>(), expected.collect::<Vec<_>>());
    // A variant keeps the path of its enum.
    save(find(&description, "Lamp", "params", "colour")).unwrap();
    assert_eq!(sources.read("lamp.rs"), text);
}

#[test]
fn default_without_a_unique_source_is_refused() {
    for (files, why) in [(&[("a.rs", "")][..], "no file below"), (&[("a.rs", LAMP), ("b.rs", LAMP)], "several files")] {
        let sources = Sources::new(files);
        let (view, description) = shown(&sources.bench());
        let (component, param) = find(&description, "Lamp", "params", "gain");
        assert!(text_of(view.request(Request::SaveSource { component, param })).contains(why));
    }
}
