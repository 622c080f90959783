//! The worlds of the forward.

use std::collections::BTreeMap;

use bica_monitor::protocol::Open;
use jmanager::ROBOTS;
use serde_json::Value;

use crate::page::{Bench, Page};

/// Opens the built-in world with one page, and waits until it runs.
pub(crate) fn running() -> (Page, Value) {
    let page = Page::new(&Bench::new());
    let options = BTreeMap::from([(ROBOTS.to_owned(), "1".to_owned())]);
    page.open(Open::World { world: "built-in".to_owned(), seed: 1, options });
    let description = page.message("described", |message| Some(message["description"].clone()));
    page.message("update", |update| (update["cycle"].as_u64()? > 5).then_some(()));
    (page, description)
}

#[test]
fn unknown_options_are_refused() {
    let bench = Bench::new();
    for (name, value) in [("walls", "1"), (ROBOTS, "99")] {
        let options = BTreeMap::from([(name.to_owned(), value.to_owned())]);
        let failed = bench.manager.open(Open::World { world: "built-in".to_owned(), seed: 1, options }).unwrap_err();
        assert!(!failed.help.is_empty(), "{failed:?}");
    }
}

#[cfg(feature = "mujoco")]
#[test]
fn a_game_in_mujoco_is_shown_with_its_images() {
    use bica_monitor::protocol::{Request, Watch, WatchImages};

    use crate::page::Got;

    let page = Page::new(&Bench::new());
    page.open(Open::World { world: "mujoco".to_owned(), seed: 1, options: BTreeMap::new() });
    page.message("described", |_| Some(()));
    let watch = Watch { images: Some(WatchImages { max_hz: 30.0 }), truth: true, ..Watch::default() };
    page.ask(Request::Watch { watch }).unwrap();
    page.message("update", |update| (update["cycle"].as_u64()? > 20).then_some(()));
    let truth = page.message("truth", |truth| Some(truth["truth"].clone()));
    let robot = truth.as_array().unwrap().iter().find(|one| one["name"] == "robot").unwrap();
    assert!(["x", "y", "heading"].iter().all(|key| robot["value"][key].is_f64()), "{truth}");
    page.wait("an image", |got| matches!(got, Got::Binary(_)).then_some(()));
}
