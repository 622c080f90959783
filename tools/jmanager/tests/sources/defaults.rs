//! A tuned value as the new default.

use std::collections::BTreeMap;
use std::path::Path;

use bica_link::{NamedRequest, NamedSetting, Plain};
use bica_monitor::protocol::{Open, Request};
use serde_json::Value;

use crate::sessions::world::find;
use crate::sources::view::{Sources, View, text_of};

#[test]
fn a_tuned_value_is_written_as_the_default_of_its_source() {
    let player = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../player/src");
    let face_ball = std::fs::read_to_string(player.join("behaviour/face_ball.rs")).unwrap();
    let profile = std::fs::read_to_string(player.join("input/robot_profile.rs")).unwrap();
    let sources = Sources::new(&[("face_ball.rs", &face_ball), ("robot_profile.rs", &profile)]);
    let bench = sources.bench();
    bench.manager.open(Open::World { world: "built-in".to_owned(), seed: 1, options: BTreeMap::new() }).unwrap();
    let view = View::new(&bench);
    let is_described = |message: &Value| (message["type"] == "described").then(|| message["description"].clone());
    let description = view.wait("the tree", is_described);
    let save = |(component, param): (usize, usize)| view.request(Request::SaveSource { component, param });
    let gain = find(&description, "FaceBall", "params", "gain");
    view.request(Request::Acquire {}).unwrap();
    let (component, param) = ("FaceBall".to_owned(), "gain".to_owned());
    let request = NamedRequest::Set { settings: vec![NamedSetting { component, param, value: Plain::Number(1.0) }] };
    view.request(Request::Operate { request }).unwrap();
    let saved = save(gain).unwrap();
    assert_eq!(saved["path"], "face_ball.rs");
    assert!(
        saved["diff"].as_str().unwrap().contains("+    #[param(default = 1.0, range = 0.05..=1.0, step = 0.05)]"),
        "{saved}"
    );
    assert_eq!(sources.read("face_ball.rs"), face_ball.replace("default = 0.7,", "default = 1.0,"));
    // Where it is declared and read, as the text is now.
    let uses = view.request(Request::ParamUses { component: gain.0, param: gain.1 }).unwrap();
    let lines = uses.as_array().unwrap().iter().map(|one| (one["file"].clone(), one["text"].clone()));
    let text = sources.read("face_ball.rs");
    let expected = text.lines().filter(|line| line.contains(".gain") || line.trim() == "pub gain: f32,");
    let expected = expected.map(|line| (Value::from("face_ball.rs"), Value::from(line.trim())));
    assert_eq!(lines.collect::<Vec<_>>(), expected.collect::<Vec<_>>());
    // A variant keeps the path of its enum.
    let body = find(&description, "RobotProfile", "params", "profile");
    save(body).unwrap();
    assert_eq!(sources.read("robot_profile.rs"), profile);
    // A parameter whose source is elsewhere.
    let other = description["components"].as_array().unwrap().iter().enumerate().find_map(|(component, one)| {
        let other = one["params"]
            .as_array()?
            .iter()
            .position(|param| param["group"] != "Facing" && one["name"] != "RobotProfile")?;
        Some((component, other))
    });
    assert!(text_of(save(other.unwrap())).contains("no file below"));
    let two = Sources::new(&[("a.rs", &face_ball), ("b.rs", &face_ball)]);
    let bench = two.bench();
    bench.manager.open(Open::World { world: "built-in".to_owned(), seed: 1, options: BTreeMap::new() }).unwrap();
    let view = View::new(&bench);
    view.wait("the tree", is_described);
    let request = Request::SaveSource { component: gain.0, param: gain.1 };
    assert!(text_of(view.request(request)).contains("several files"));
}
