//! Operators: control, values, actions, read-only servers, saved values and layouts.

use bica::Hold;
use bica_link::{NamedRequest, Plain};
use bica_monitor::protocol::{Breakpoint, Open, Request, Watch};
use bica_monitor::sessions::Options;
use serde_json::{Value, json};

use crate::page::{Bench, Folder, Page};
use crate::served::{Served, attached};
use crate::sessions::world::{find, hold, place, place_in, running, running_on, set_gain};

#[test]
fn one_page_operates_and_gets_values_in_force() {
    let (page, description) = running();
    let (component, param) = find(&description, "Lamp", "params", "gain");
    let error = page.ask(set_gain(Plain::Number(0.9))).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("does not control"), "{error}");
    page.ask(Request::Acquire {}).unwrap();
    let answer = page.ask(set_gain(Plain::Number(0.9))).unwrap();
    assert_eq!(answer["values"], json!([0.9]));
    let error = page.ask(set_gain(Plain::Number(1000.0))).unwrap_err();
    assert_eq!(error["entry"], 0, "{error}");
    let error = page.ask(set_gain(Plain::Name("text".to_owned()))).unwrap_err();
    assert_eq!(error["entry"], 0, "{error}");
    for hz in [-1e30, 0.0, 1e6, f32::NAN, f32::INFINITY] {
        let error = page
            .ask(Request::Operate { request: NamedRequest::Rate { component: "Lamp".to_owned(), hz: Some(hz) } })
            .unwrap_err();
        assert!(error["help"].as_str().unwrap().contains("at most"), "{hz}: {error}");
    }

    let other = Page::new(&page.bench);
    let gain = other.message("described", |message| {
        Some(message["description"]["components"][component]["params"][param]["value"].clone())
    });
    assert_eq!(gain, json!(0.9), "a page that comes later gets the values in force");
    assert_eq!(other.ask(Request::Acquire {}).unwrap_err()["text"], "another page controls the robot");
    other.ask(Request::Take {}).unwrap();
    page.session(|session| session["control"] == "other_page");
    assert!(page.ask(set_gain(Plain::Number(0.8))).is_err());
    assert_eq!(other.ask(set_gain(Plain::Number(0.8))).unwrap()["values"], json!([0.8]));
    drop(other);
    page.message("log", |log| {
        log["lines"][0]["text"].as_str()?.contains("was closed: control has ended").then_some(())
    });
    page.session(|session| session["control"] == "free");
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_a_hold_ends_when_the_page_is_silent() {
    let (page, description) = running();
    let component = description["root"].as_u64().unwrap() as usize;
    page.ask(Request::Acquire {}).unwrap();
    page.ask(hold(description["components"][component]["name"].as_str().unwrap(), Hold::Latent)).unwrap();
    let is = |hold: &'static str| move |update: &Value| (update["components"][component][1] == hold).then_some(());
    page.message("update", is("latent"));
    page.message("update", is("tree"));
    page.session(|session| session["control"] == "free");
}

/// Waits until the true state has the lamp at a place.
fn lies_at(page: &Page, x: f64) {
    page.state("truth", |message| (place_in(&message["truth"]) == x).then_some(()));
}

#[test]
fn actions_apply_to_a_running_and_a_paused_world() {
    let (page, _) = running();
    page.ask(Request::Watch { watch: Watch { truth: true, ..Watch::default() } }).unwrap();
    page.ask(Request::Acquire {}).unwrap();
    page.ask(place(2.5)).unwrap();
    lies_at(&page, 2.5);
    for (x, reason) in [(3.25, "3.25 is outside -3..=3"), (-1.0, "a wall is there")] {
        let error = page.ask(place(x)).unwrap_err();
        assert!(error["text"].as_str().unwrap().contains(reason), "{error}");
    }
    page.paused();
    let answer = page.ask(place(0.5)).unwrap();
    lies_at(&page, 0.5);
    assert_eq!(place_in(&page.now()["truth"]), 0.5, "the lamp is there before the next cycle");
    page.ask(Request::Step { cycles: 1 }).unwrap();
    page.message("update", |update| (update["cycle"] == answer["cycle"]).then_some(()));
    page.ask(Request::Release {}).unwrap();
    page.session(|session| session["control"] == "free");
    assert!(page.ask(place(1.0)).is_err());
}

#[test]
fn a_read_only_server_refuses_every_change() {
    let bench = Bench::with(Folder::new("sessions"), |options| Options { read_only: true, ..options });
    let (page, description) = running_on(&bench);
    let address = "tcp://127.0.0.1:1".to_owned();
    for request in [
        Request::Open { source: Open::Robot { address } },
        Request::Note { text: "a".to_owned() },
        Request::Acquire {},
        Request::Pause {},
        Request::Restart { seed: None },
        Request::KeepRecording { name: "a".to_owned() },
        Request::SaveTune { params: vec![(0, 0)], name: "a".to_owned() },
        Request::SaveLayout { name: "a".to_owned(), layout: json!({}) },
        Request::Close {},
    ] {
        let error = page.ask(request.clone()).unwrap_err();
        assert!(error["text"].as_str().unwrap().contains("only watch"), "{request:?}: {error}");
    }
    let (component, state) = find(&description, "Lamp", "states", "off");
    let list = vec![Breakpoint { component, state: Some(state), transition: None }];
    page.ask(Request::Breakpoints { list }).unwrap();
    assert_eq!(page.message("hit", |hit| Some(hit["paused"].clone())), false);
}

#[test]
fn saved_values_are_in_force_in_the_next_world() {
    let (page, description) = running();
    let (component, param) = find(&description, "Lamp", "params", "gain");
    page.ask(Request::Acquire {}).unwrap();
    page.ask(set_gain(Plain::Number(0.9))).unwrap();
    let save = |name: &str| Request::SaveTune { params: vec![(component, param)], name: name.to_owned() };
    assert!(page.ask(save("../room")).is_err());
    let saved = page.ask(save("room")).unwrap();
    let text = std::fs::read_to_string(saved["path"].as_str().unwrap()).unwrap();
    assert!(text.contains("[Lamp]\ngain = 0.9"), "{text}");
    page.ask(Request::Restart { seed: None }).unwrap();
    let gain = page.message("described", |message| {
        Some(message["description"]["components"][component]["params"][param]["value"].clone())
    });
    assert_eq!(gain, json!(0.9));
}

#[test]
fn too_long_texts_are_refused_with_their_limit() {
    let (page, _) = running();
    let (name, layout) = ("x".repeat(101), json!({}));
    for (request, text, help) in [
        (Request::SaveLayout { name, layout }, "the name of the layout has 101 characters", "write at most 100"),
        (Request::Note { text: "ö".repeat(501) }, "the note has 501 characters", "write at most 500"),
    ] {
        let error = page.ask(request).unwrap_err();
        assert_eq!((&error["text"], &error["help"]), (&json!(text), &json!(help)));
    }
}

#[test]
fn layouts_are_kept() {
    let page = Page::new(&Bench::new());
    let save = |layout| Request::SaveLayout { name: "mine".to_owned(), layout };
    assert_eq!(page.ask(Request::Layouts {}).unwrap(), json!({}));
    page.ask(save(json!({ "panels": [1, 2] }))).unwrap();
    assert_eq!(page.ask(Request::Layouts {}).unwrap(), json!({ "mine": { "panels": [1, 2] } }));
    page.ask(save(json!(null))).unwrap();
    assert_eq!(page.ask(Request::Layouts {}).unwrap(), json!({}));
}

#[test]
fn each_page_stops_and_none_starts_without_control() {
    let lamp = Served::device();
    let (operator, _) = attached(&lamp.address);
    let beside = Page::new(&operator.bench);
    beside.session.set(operator.session.get());
    let of_reader = Bench::with(Folder::new("sessions"), |options| Options { read_only: true, ..options });
    let reader = Page::new(&of_reader);
    reader.open(Open::Robot { address: lamp.address.clone() });
    reader.message("described", |_| Some(()));
    let (component, modulation, arguments) = ("Lamp".to_owned(), "start".to_owned(), vec![]);
    let start = Request::Operate { request: NamedRequest::Modulate { component, modulation, arguments } };
    operator.session(|session| session["connection"] == "connected");
    for other in [&beside, &reader] {
        operator.ask(Request::Acquire {}).unwrap();
        operator.ask(hold("Lamp", Hold::Latent)).unwrap();
        assert!(other.ask(start.clone()).is_err());
        other.ask(Request::Stop {}).unwrap();
        operator.session(|session| session["control"] == "free");
        operator.message("update", |update| (update["components"][0][1] == "tree").then_some(()));
        assert!([other, &operator].iter().all(|page| page.ask(start.clone()).is_err()));
    }
}
