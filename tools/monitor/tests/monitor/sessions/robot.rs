//! A robot behind a link.

use bica::Hold;
use bica_link::{Client, ClientOptions, Plain};
use bica_monitor::protocol::{Breakpoint, Open, Request, Watch, WatchImages};
use serde_json::json;

use crate::lamp::{CYCLE_US, IMAGE_BYTES};
use crate::page::{Bench, Got, Page};
use crate::served::{Served, attached};
use crate::sessions::world::{find, hold, place_in, set_gain};

#[test]
fn lost_robot_is_found_again_without_old_requests() {
    let robot = Served::world();
    let address = robot.address.clone();
    let (page, description) = attached(&format!("tcp://{address}"));
    page.session(|one| one["connection"] == "connected");
    page.ask(Request::Acquire {}).unwrap();
    let (component, param) = find(&description, "Lamp", "params", "gain");
    page.ask(hold("Lamp", Hold::Latent)).unwrap();
    drop(robot);
    page.session(|one| one["connection"] == "lost");
    let error = page.ask(set_gain(Plain::Number(0.9))).unwrap_err();
    assert!(!error["text"].as_str().unwrap().is_empty(), "{error}");

    let robot = Served::world_at(&address);
    let description = page.message("described", |message| Some(message["description"].clone()));
    page.session(|one| one["connection"] == "connected" && one["control"] == "free");
    assert_eq!(description["components"][component]["params"][param]["value"], json!(0.7), "nothing was kept");
    let held = page.message("update", |update| Some(update["components"][component][1].clone()));
    assert_eq!(held, "tree");
    let error = page.ask(hold("Lamp", Hold::Latent)).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("does not control"), "{error}");
    drop(robot);
}

#[test]
fn world_behind_a_link_shows_what_a_local_one_shows() {
    let robot = Served::world();
    let (page, description) = attached(&robot.address);
    let info = page.session(|one| one["connection"] == "connected");
    for capability in ["operate", "pause", "truth", "images", "costs", "conditions"] {
        assert_eq!(info["can"][capability], true, "{capability}");
    }
    let components = description["components"].as_array().unwrap();
    let root = description["root"].as_u64().unwrap() as usize;
    let images = Some(WatchImages { max_hz: 30.0 });
    let watch = Watch { conditions: vec![root], costs: true, truth: true, images, ..Watch::default() };
    page.ask(Request::Watch { watch }).unwrap();
    let frame = page.wait("an image", |got| match got {
        Got::Binary(frame) => Some(frame.clone()),
        Got::Message(_) => None,
    });
    assert_eq!((frame[0], frame.len()), (1, 32 + usize::from(frame[1]) + IMAGE_BYTES));
    let conditions = page.message("conditions", |message| {
        let conditions = message["conditions"].as_array()?;
        let is_known = conditions.iter().any(|one| one["holds"].is_boolean());
        is_known.then_some(conditions.len())
    });
    assert_eq!(conditions, components[root]["transitions"].as_array().unwrap().len());
    let truth = page.message("truth", |truth| Some(truth["truth"].clone()));
    assert_eq!(place_in(&truth), 1.0, "{truth}");
    let costs = page.message("costs", |costs| (costs["window_us"] == 50 * CYCLE_US).then(|| costs.clone()));
    let costs = costs["components"].as_array().unwrap();
    assert_eq!(costs.len(), components.len());
    assert!(costs.iter().any(|one| one[0] == 50 && one[1].as_f64().unwrap() > 0.0));
}

#[test]
fn world_is_paused_stepped_and_continued() {
    let robot = Served::world();
    let (page, _) = attached(&robot.address);
    page.cycle(6);
    page.send(Request::Pause {});
    page.session(|one| one["paused"] == true && one["control"] == "free");
    page.ask(Request::Acquire {}).unwrap();
    let next = page.ask(set_gain(Plain::Number(0.9))).unwrap()["cycle"].as_u64().unwrap();
    page.ask(Request::Step { cycles: 3 }).unwrap();
    let last = page.message("update", |update| update["cycle"].as_u64().filter(|&cycle| cycle >= next + 2));
    assert_eq!(last, next + 2, "three cycles");
    page.ask(Request::Step { cycles: 2 }).unwrap();
    let last = page.message("update", |update| update["cycle"].as_u64().filter(|&cycle| cycle > next + 3));
    assert_eq!(last, next + 4, "two more");
    page.ask(Request::Release {}).unwrap();
    let mut other = Client::connect(&robot.address.parse().unwrap(), ClientOptions::default()).unwrap();
    other.acquire(true).unwrap();
    let error = page.ask(Request::Resume {}).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("another monitor"), "{error}");
    other.release().unwrap();
    page.send(Request::Resume {});
    page.session(|one| one["paused"] == false);
    page.cycle(next + 21);
}

#[test]
fn address_is_tried_until_a_robot_answers() {
    let page = Page::new(&Bench::new());
    let first = Served::world();
    let address = first.address.clone();
    drop(first);
    page.open(Open::Robot { address: address.clone() });
    let info = page.session(|one| !one["note"].as_str().unwrap().is_empty());
    assert_eq!(info["connection"], "connecting");
    assert!(page.ask(Request::Acquire {}).is_err());
    let _robot = Served::world_at(&address);
    page.session(|one| one["connection"] == "connected");
    assert!(page.bench.manager.open(Open::Robot { address: "nowhere".to_owned() }).is_err());
}

/// Attack 15.
#[test]
fn another_robot_inherits_nothing_of_the_first() {
    let robot = Served::world();
    let address = robot.address.clone();
    let (page, description) = attached(&address);
    page.session(|one| one["connection"] == "connected");
    page.ask(Request::Acquire {}).unwrap();
    page.ask(hold("Eye", Hold::Latent)).unwrap();
    let place = Breakpoint { component: 0, state: Some(0), transition: None };
    page.ask(Request::Breakpoints { list: vec![place] }).unwrap();
    drop(robot);
    page.session(|one| one["connection"] == "lost");
    let _other = Served::other_at(&address);
    let other = page.message("described", |message| Some(message["description"].clone()));
    assert_eq!(other["name"], "EyeTree");
    assert_ne!((&other["name"], &other["hash"]), (&description["name"], &description["hash"]));
    page.message("breakpoints", |message| (message["list"] == json!([])).then_some(()));
    page.session(|one| one["connection"] == "connected" && one["control"] == "free");
    let held = page.message("update", |update| Some(update["components"].clone()));
    assert_eq!((held.as_array().unwrap().len(), &held[0][1]), (1, &json!("tree")));
    let error = page.ask(hold("Eye", Hold::Latent)).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("does not control"), "{error}");
    let request = Request::Timeline { from_us: 0, until_us: u64::MAX, resolution_us: 0 };
    assert_eq!(page.ask(request).unwrap().as_array().unwrap().len(), 1, "rows of the new tree only");
}
