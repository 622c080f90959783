//! Breakpoints on states and transitions.

use bica_monitor::protocol::{Breakpoint, Request};
use serde_json::{Value, json};

use crate::lamp::CYCLE_US;
use crate::page::{Bench, Folder, Got, Page};
use crate::served::{Served, attached};
use crate::sessions::recorded::{opened, record};
use crate::sessions::world::{find, running};

fn state(component: usize, state: usize) -> Breakpoint {
    Breakpoint { component, state: Some(state), transition: None }
}

/// Breakpoint on the only transition from off to on, and the indices of both states.
fn lit(description: &Value) -> (Breakpoint, usize, usize) {
    let (component, transition) = find(description, "Lamp", "transitions", "is_lit");
    let state = |name: &str| find(description, "Lamp", "states", name).1;
    (Breakpoint { component, state: None, transition: Some(transition) }, state("off"), state("on"))
}

#[test]
fn step_of_many_cycles_stops_at_a_breakpoint() {
    let (page, description) = running();
    let (transition, _, to) = lit(&description);
    page.ask(Request::Breakpoints { list: vec![transition] }).unwrap();
    page.ask(Request::Pause {}).unwrap();
    page.ask(Request::Restart { seed: Some(2) }).unwrap();
    page.message("described", |_| Some(()));
    page.ask(Request::Step { cycles: 100_000 }).unwrap();
    let hit = page.message("hit", |hit| Some(hit.clone()));
    let time_us = hit["time_us"].as_u64().unwrap();
    let moment = page.stands();
    assert_eq!(moment["time_us"], time_us);
    assert_eq!(moment["components"][transition.component][2], to, "{moment}");
    assert_eq!(page.ask(Request::NextHit { from_us: 0 }).unwrap()["time_us"], time_us);
    assert!(page.ask(Request::NextHit { from_us: time_us }).unwrap().is_null());
    // The breakpoint is reached once: a step of one cycle continues from there.
    page.ask(Request::Step { cycles: 1 }).unwrap();
    page.cycle(moment["cycle"].as_u64().unwrap() + 1);
}

/// Waits until a robot reaches a breakpoint. Each state has one, so that one is reached soon.
fn hit_behind_a_link(robot: &Served, then: impl Fn(&Page, &Value)) {
    let (page, description) = attached(&robot.address);
    let (component, _) = find(&description, "Lamp", "states", "on");
    let states = description["components"][component]["states"].as_array().unwrap().len();
    let list: Vec<_> = (0..states).map(|one| state(component, one)).collect();
    page.ask(Request::Breakpoints { list }).unwrap();
    let hit = page.message("hit", |hit| Some(hit.clone()));
    then(&page, &hit);
    let lines = format!("{:?}", page.lines());
    assert!(lines.contains("breakpoint: `Lamp`"), "{lines}");
}

#[test]
fn a_robot_is_not_stopped_and_a_hit_is_sent() {
    let robot = Served::device();
    hit_behind_a_link(&robot, |page, hit| {
        assert_eq!(hit["paused"], false, "{hit}");
        let time_us = hit["time_us"].as_u64().unwrap();
        page.message("update", |update| (update["time_us"].as_u64()? > time_us + 200_000).then_some(()));
    });
}

#[test]
fn a_world_behind_a_link_pauses_at_the_cycle_of_a_hit() {
    let robot = Served::world();
    hit_behind_a_link(&robot, |page, hit| {
        assert_eq!(hit["paused"], true, "{hit}");
        assert_eq!(page.stands()["time_us"], hit["time_us"]);
        let time_us = hit["time_us"].as_u64().unwrap();
        let moment = page.ask(Request::At { time_us, outputs: vec![], image: false }).unwrap();
        assert_eq!(moment["components"][hit["component"].as_u64().unwrap() as usize][4], time_us);
        page.ask(Request::Breakpoints { list: Vec::new() }).unwrap();
        page.ask(Request::Resume {}).unwrap();
        page.message("update", |update| (update["time_us"].as_u64()? > time_us + 200_000).then_some(()));
    });
}

#[test]
fn the_next_hit_of_a_recording_is_found() {
    let folder = Folder::new("sessions");
    record(&folder, "one.mcap");
    let page = Page::new(&Bench::with(folder, |options| options));
    opened(&page, "one");
    let late = Page::new(&page.bench);
    let description = late.message("described", |message| Some(message["description"].clone()));
    let (transition, from, to) = lit(&description);
    page.ask(Request::Breakpoints { list: vec![transition] }).unwrap();
    late.message("breakpoints", |message| {
        (message["list"][0]["transition"] == json!(transition.transition)).then_some(())
    });
    let request = Request::Timeline { from_us: 0, until_us: u64::MAX, resolution_us: 0 };
    let rows = page.ask(request).unwrap();
    let bars = rows[transition.component]["bars"].as_array().unwrap().clone();
    let expected: Vec<u64> = bars
        .windows(2)
        .filter(|two| (&two[0][2], &two[1][2]) == (&json!(from), &json!(to)) && two[0][1] == two[1][0])
        .map(|two| two[1][0].as_u64().unwrap())
        .collect();
    assert!(!expected.is_empty(), "{bars:?}");
    let (mut found, mut cursor) = (Vec::new(), 0);
    while let Some(time) = page.ask(Request::NextHit { from_us: cursor }).unwrap()["time_us"].as_u64() {
        assert!(time > cursor);
        found.push(time);
        cursor = time;
    }
    assert_eq!(found, expected);
}

#[test]
fn breakpoints_that_do_not_fit_the_tree_are_refused() {
    let (page, description) = running();
    let (transition, ..) = lit(&description);
    let component = transition.component;
    for one in [
        state(1000, 0),
        state(component, 1000),
        Breakpoint { component, state: None, transition: Some(1000) },
        Breakpoint { component, state: None, transition: None },
        Breakpoint { component, state: Some(0), transition: Some(0) },
    ] {
        page.ask(Request::Breakpoints { list: vec![transition, one] }).unwrap_err();
    }
    page.ask(Request::Breakpoints { list: vec![state(component, 0); 501] }).unwrap_err();
    let late = Page::new(&page.bench);
    let list = late.wait("the list", |got| match got {
        Got::Message(message) if message["type"] == "breakpoints" => Some(message["list"].clone()),
        _ => None,
    });
    assert_eq!(list, json!([]));
}

/// The conditions depend on a counter that increases by one in each cycle.
#[test]
fn breakpoint_is_reached_by_its_transition_only() {
    let lamp = Served::device();
    let (page, description) = attached(&lamp.address);
    page.session(|one| one["connection"] == "connected");
    for (name, period, rest) in [("is_broken", 16, 13), ("is_kept", 8, 3)] {
        let (component, transition) = find(&description, "Lamp", "transitions", name);
        let place = Breakpoint { component, state: None, transition: Some(transition) };
        page.ask(Request::Breakpoints { list: vec![place] }).unwrap();
        let time = |hit: &Value| (hit["transition"] == transition).then(|| hit["time_us"].as_u64().unwrap());
        let hit = || page.message("hit", time);
        let times = [hit(), hit(), hit()];
        assert!(times.iter().all(|time| time / CYCLE_US % period == rest), "{name}: {times:?}");
        let next = page.ask(Request::NextHit { from_us: times[0] }).unwrap()["time_us"].as_u64().unwrap();
        assert_eq!(next, times[1]);
    }
}
