//! What a page gets of a world that is paused.

use std::time::Duration;

use jmanager::protocol::{Request, Watch, WatchImages, WatchInfo};
use jmanager::sessions::Manager;
use serde_json::Value;

use crate::page::{Folder, Got, Page};
use crate::robot::{Robot, attached};
use crate::world::{find, running};

/// Watches images, the number of images and the truth; returns number and time (µs) of the first image, the number, and the truth.
fn watched(page: &Page<'_>, session: u32, (component, info): (usize, usize)) -> (u32, u64, u64, Value) {
    let watch = Watch {
        images: Some(WatchImages { max_hz: 30.0 }),
        info: vec![WatchInfo { component, info, every: 1 }],
        truth: true,
        ..Watch::default()
    };
    page.send(Request::Watch { session, watch });
    let (mut image, mut count, mut truth) = (None, None, None);
    page.wait("image, information and truth", |got| {
        match got {
            Got::Binary(frame) if frame[0] == 1 && frame[24..28] == [0; 4] => {
                let number = u32::from_le_bytes(frame[8..12].try_into().unwrap());
                image.get_or_insert((number, u64::from_le_bytes(frame[16..24].try_into().unwrap())));
            }
            Got::Message(message) if message["type"] == "info" => count = message["samples"][0][3].as_u64().or(count),
            Got::Message(message) if message["type"] == "truth" => truth = Some(message["truth"]["ball"].clone()),
            _ => {}
        }
        let ((number, time_us), count, truth) = (image?, count?, truth.clone()?);
        Some((number, time_us, count, truth))
    })
}

/// Time and number of images of the last cycle.
fn now(page: &Page<'_>, session: u32) -> (u64, u64) {
    // The last cycles before the pause are still under way.
    std::thread::sleep(Duration::from_millis(300));
    let moment = page.ask(Request::At { session, time_us: u64::MAX, info: vec![], image: false }).unwrap();
    (moment["time_us"].as_u64().unwrap(), moment["cycle"].as_u64().unwrap())
}

#[test]
fn a_page_that_comes_to_a_paused_world_gets_its_newest_image_at_once() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let (page, session, description) = running(&manager);
    let count = find(&description, "CameraInput", "info", "count");
    page.message("update", |update| (update["cycle"].as_u64()? > 50).then_some(()));
    page.ask(Request::Pause { session }).unwrap();
    let (time_us, cycle) = now(&page, session);
    let first = watched(&page, session, count);
    assert!(first.1 <= time_us && time_us - first.1 < 150_000, "{first:?} at {time_us}");
    assert!(u64::from(first.0) + 1 >= first.2, "{first:?}");
    // A page that is loaded again is another page.
    let reloaded = Page::new(&manager);
    assert_eq!(watched(&reloaded, session, count), first);
    assert_eq!(now(&page, session), (time_us, cycle), "the world has not gone on");
}

#[test]
fn a_page_that_comes_to_a_paused_world_behind_a_link_gets_its_newest_image_at_once() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let robot = Robot::start("127.0.0.1:0");
    let (page, session, description) = attached(&manager, &robot.address);
    let count = find(&description, "CameraInput", "info", "count");
    page.message("update", |update| (update["cycle"].as_u64()? > 50).then_some(()));
    page.ask(Request::Pause { session }).unwrap();
    let (time_us, cycle) = now(&page, session);
    // Nobody has watched images yet: the robot sends the newest one.
    let first = watched(&page, session, count);
    assert!(first.1 <= time_us && time_us - first.1 < 150_000, "{first:?} at {time_us}");
    let reloaded = Page::new(&manager);
    assert_eq!(watched(&reloaded, session, count), first);
    // Nobody watches any more, then somebody does again.
    drop(reloaded);
    page.ask(Request::Watch { session, watch: Watch::default() }).unwrap();
    assert_eq!(watched(&page, session, count), first);
    assert_eq!(now(&page, session), (time_us, cycle), "the world has not gone on");
    page.send(Request::Resume { session });
    let next = page.wait("the next image", |got| match got {
        Got::Binary(frame) => {
            let number = u32::from_le_bytes(frame[8..12].try_into().unwrap());
            (number != first.0).then_some(number)
        }
        Got::Message(_) => None,
    });
    assert!(next > first.0);
}
