//! Data that a page receives of a paused world.

use bica_monitor::protocol::{Request, Watch, WatchImages, WatchOutput};
use serde_json::{Value, json};

use crate::lamp::{CYCLE_US, IMAGE_CYCLES};
use crate::page::{Got, Page};
use crate::sessions::world::{find, place_in, running};

/// Watches images, the number of images and the truth; returns number and time (µs) of the newest image, the number, and the truth.
fn watched(page: &Page, (component, info): (usize, usize)) -> (u32, u64, u64, Value) {
    let watch = Watch {
        images: Some(WatchImages { max_hz: 30.0 }),
        outputs: vec![WatchOutput { component, output: info, every: 1 }],
        truth: true,
        ..Watch::default()
    };
    page.send(Request::Watch { watch });
    let (mut image, mut count, mut truth) = (None, None, None);
    page.wait("image, outputs and truth", |got| {
        match got {
            Got::Binary(frame) if frame[0] == 1 && frame[24..28] == [0; 4] => {
                let number = u32::from_le_bytes(frame[8..12].try_into().unwrap());
                image = Some((number, u64::from_le_bytes(frame[16..24].try_into().unwrap())));
            }
            Got::Message(message) if message["type"] == "info" => count = message["samples"][0][3].as_u64().or(count),
            Got::Message(message) if message["type"] == "truth" => truth = Some(message["truth"].clone()),
            _ => {}
        }
        let ((number, time_us), count, truth) = (image?, count?, truth.clone()?);
        // On a busy computer an older image may come before the newest one.
        (u64::from(number) + 1 >= count).then_some((number, time_us, count, truth))
    })
}

#[test]
fn page_gets_the_newest_image_of_a_paused_world() {
    let (page, description) = running();
    let count = find(&description, "Eye", "info", "count");
    page.cycle(51);
    let paused = page.paused();
    let time_us = paused["time_us"].as_u64().unwrap();
    let first = watched(&page, count);
    assert!(first.1 <= time_us && time_us - first.1 < 3 * IMAGE_CYCLES * CYCLE_US, "{first:?} at {time_us}");
    let reloaded = Page::new(&page.bench);
    assert_eq!(watched(&reloaded, count), first);
    // No page watches the world any more, then one does again.
    drop(reloaded);
    page.ask(Request::Watch { watch: Watch::default() }).unwrap();
    assert_eq!(watched(&page, count), first);
    assert_eq!(page.stands()["cycle"], paused["cycle"], "the world has not gone on");
    page.send(Request::Resume {});
    page.wait("the next image", |got| match got {
        Got::Binary(frame) => (u32::from_le_bytes(frame[8..12].try_into().unwrap()) > first.0).then_some(()),
        Got::Message(_) => None,
    });
}

/// Data of a moment before the newest one.
#[test]
fn past_moment_has_its_conditions_costs_and_truth() {
    let (page, description) = running();
    let root = description["root"].as_u64().unwrap() as usize;
    page.ask(Request::Watch { watch: Watch { conditions: vec![root], costs: true, ..Watch::default() } }).unwrap();
    // Costs come every half second; the conditions of the first state differ from those of a later one.
    page.message("costs", |_| Some(()));
    let then = page.message("conditions", |message| Some(message.clone()));
    let time_us = then["time_us"].as_u64().unwrap();
    let is_other = |update: &Value| (update["time_us"].as_u64()? > time_us + 1_000_000).then_some(());
    page.message("update", is_other);
    let moment = page.ask(Request::At { time_us, outputs: vec![], image: false }).unwrap();
    assert_eq!(moment["conditions"][0]["component"], root, "{moment}");
    let holds = |of: &Value| -> Vec<Value> {
        let all = of["conditions"].as_array().unwrap().iter();
        all.map(|one| json!([one["holds"], one["since_us"], one["remaining_ms"]])).collect()
    };
    assert_eq!(holds(&moment["conditions"][0]), holds(&then));
    assert!(moment["costs"]["time_us"].as_u64().unwrap() <= time_us, "{moment}");
    assert_eq!(place_in(&moment["truth"]), 1.0, "{moment}");
}
