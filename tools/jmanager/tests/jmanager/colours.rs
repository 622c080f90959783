//! The colour tuner.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use bica_evaluation::frame_io::{list, stem};
use bica_evaluation::labels::{Ball, Labels};
use bica_monitor::protocol::{Open, Request, Watch, WatchImages};
use jmanager::SoccerOptions;
use serde_json::{Value, json};

use crate::page::{Bench, Folder, Got, Page, options};
use crate::world::running;

/// Class of the ball.
const ORANGE: usize = 0;
/// Largest number of clicks.
const MAX_CLICKS: usize = 25;

/// A hall's profile in which orange and both goal colours are wrong: too bright, and orange is yellow.
const SPOILT: &str = "[orange]\nhue = [148, 165]\nsaturation = [50, 400]\nluma = [170, 230]\nchroma = 60\n
    [yellow]\nhue = [170, 172]\nluma = [230, 240]\n[blue]\nhue = [300, 302]\nluma = [200, 220]\n
    [green]\nhue = [193, 263]\nsaturation = [8, 400]\nluma = [38, 133]\nchroma = 5\n
    [white]\nsaturation = [0, 8]\nluma = [111, 255]\n";

/// A manager with labelled images.
fn bench_of(folder: Folder, images: PathBuf) -> Arc<Bench> {
    let options = options(&folder);
    let soccer =
        SoccerOptions { profiles: folder.0.join("profiles"), images: Some(images), ..SoccerOptions::default() };
    Bench::of_program(&Arc::new(folder), options, jmanager::program(soccer))
}

/// A message to the tuner.
fn tuner(message: Value) -> Request {
    Request::Extension { name: "tuner".to_owned(), message }
}

/// A click on a pixel of the ball.
fn pick(remove: bool, image: u32, (x, y): (u16, u16)) -> Request {
    tuner(json!({ "type": "pick", "class": ORANGE, "remove": remove, "image": image, "pixels": [[x, y]] }))
}

/// Returns recall and precision of the ball, missed images, and wrong detections.
fn score(page: &Page) -> (f64, f64, Vec<String>, Vec<String>) {
    let rows = page.ask(tuner(json!({ "type": "score" }))).unwrap();
    let row = &rows["rows"][0];
    assert_eq!(row["object"], "ball");
    let names = |list: &Value| list.as_array().unwrap().iter().map(|name| name.as_str().unwrap().to_owned()).collect();
    let precision = row["precision"].as_f64().unwrap_or(1.0);
    (row["recall"].as_f64().unwrap(), precision, names(&row["missed"]), names(&row["wrong"]))
}

/// Returns the class of each pixel of an image.
fn classify(page: &Page, image: u32) -> Vec<u8> {
    let id = page.send(tuner(json!({ "type": "classify", "image": image })));
    let frame = page.wait("the classes", |got| match got {
        Got::Binary(frame) => Some(frame.clone()),
        Got::Message(_) => None,
    });
    assert_eq!((frame[0], &frame[24..28]), (2, &id.to_le_bytes()[..]));
    page.message("answer", |answer| (answer["id"] == id).then_some(()));
    frame[32..].to_vec()
}

/// Returns the pixel of a ball nearest to its centre that is not yet classified as orange.
fn place_to_click(classes: &[u8], ball: &Ball) -> Option<(u16, u16)> {
    let (x0, y0, radius) = (ball.centre.x as i32, ball.centre.y as i32, (0.7 * ball.radius) as i32);
    let offsets = (-radius..=radius).flat_map(|dy| (-radius..=radius).map(move |dx| (dx, dy)));
    let mut inside: Vec<_> = offsets.filter(|(dx, dy)| dx * dx + dy * dy <= radius * radius).collect();
    inside.sort_by_key(|(dx, dy)| dx * dx + dy * dy);
    let places = inside.into_iter().map(|(dx, dy)| (x0 + dx, y0 + dy));
    let mut places = places.filter(|&(x, y)| (0..320).contains(&x) && (0..240).contains(&y));
    let is_other = |&(x, y): &(i32, i32)| usize::from(classes[(y * 320 + x) as usize]) != ORANGE;
    places.find(is_other).map(|(x, y)| (x as u16, y as u16))
}

bica_test_data::images_test! {
    fn clicks_on_pixels_mend_a_spoilt_profile() {
        let images = bica_test_data::images().join("nao2009");
        let labels = Labels::read(&images.join("../labels.csv"), &images).unwrap();
        let files = list(&images).unwrap();
        let name = |path: &Path| path.file_name().unwrap().to_str().unwrap().to_owned();
        let numbers: BTreeMap<String, u32> = (0..).zip(&files).map(|(number, path)| (stem(&name(path)).to_owned(), number)).collect();

        let folder = Folder::new("sessions");
        let profiles = folder.0.join("profiles");
        fs::create_dir_all(&profiles).unwrap();
        fs::write(profiles.join("spoilt.toml"), SPOILT).unwrap();
        let page = Page::new(&bench_of(folder, images));
        page.open(Open::Images {});
        page.session(|one| one["connection"] == "connected");
        page.ask(tuner(json!({ "type": "load", "name": "spoilt" }))).unwrap();

        let (mut recall, mut precision, mut missed, mut wrong) = score(&page);
        assert!(recall < 0.5, "spoilt: {recall}");
        let mut clicks = 0;
        while (recall < 0.97 || precision < 0.99) && clicks < MAX_CLICKS {
            let click = if recall < 0.97 {
                // Steps of seven through the missed images, so that successive clicks are on different balls.
                let image = &missed[clicks * 7 % missed.len()];
                let ball = *labels.get(image).unwrap().balls.iter().find(|ball| ball.orange && ball.full).unwrap();
                let number = numbers[stem(image)];
                place_to_click(&classify(&page, number), &ball).map(|place| (number, place, false))
            } else {
                // `NAME (X, Y)`
                let (image, at) = wrong[0].split_once(" (").unwrap();
                let (x, y) = at.trim_end_matches(')').split_once(", ").unwrap();
                Some((numbers[stem(image)], (x.parse().unwrap(), y.parse().unwrap()), true))
            };
            clicks += 1;
            if let Some((image, place, remove)) = click {
                page.ask(pick(remove, image, place)).unwrap();
            }
            (recall, precision, missed, wrong) = score(&page);
            println!("{clicks} clicks: recall {recall:.3}, precision {precision:.3}, missed {}", missed.len());
        }
        assert!(recall >= 0.97, "{recall}");
        assert!(precision >= 0.99, "{precision}");
        let saved = page.ask(tuner(json!({ "type": "save", "name": "mended" }))).unwrap();
        let text = fs::read_to_string(saved["path"].as_str().unwrap()).unwrap();
        assert!(text.contains("[orange]"));
    }

    fn a_pick_can_be_undone() {
        let images = bica_test_data::images().join("nao2009");
        let page = Page::new(&bench_of(Folder::new("sessions"), images));
        page.open(Open::Images {});
        page.session(|one| one["connection"] == "connected");
        let before = page.ask(tuner(json!({ "type": "read" }))).unwrap();
        let picked = page.ask(pick(false, 0, (5, 5))).unwrap();
        assert_ne!(picked["classes"], before["classes"]);
        let undone = page.ask(tuner(json!({ "type": "undo" }))).unwrap();
        assert_eq!(undone["classes"], before["classes"]);
        assert!(page.ask(tuner(json!({ "type": "undo" }))).is_err());
        assert!(page.ask(pick(false, 0, (320, 5))).unwrap_err()["text"].as_str().unwrap().contains("outside"));
    }
}

/// Returns the number of an image of the camera.
fn watched_image(page: &Page) -> u32 {
    let images = Some(WatchImages { max_hz: 30.0 });
    page.send(Request::Watch { watch: Watch { images, ..Watch::default() } });
    page.wait("an image", |got| match got {
        Got::Binary(frame) => Some(u32::from_le_bytes(frame[8..12].try_into().unwrap())),
        Got::Message(_) => None,
    })
}

#[test]
fn edited_profile_is_sent_as_parameters() {
    let (page, _) = running();
    let image = watched_image(&page);
    let picked = page.ask(pick(false, image, (80, 100))).unwrap();
    let luma = &picked["classes"][ORANGE]["limits"]["luma"][0];
    page.ask(Request::Acquire {}).unwrap();
    let sent = page.ask(tuner(json!({ "type": "send" }))).unwrap();
    assert!(sent["values"].as_array().unwrap().len() > 30);

    let late = Page::new(&page.bench);
    let described = late.message("described", |message| Some(message["description"].clone()));
    let named = |list: &Value, name| list.as_array().unwrap().iter().find(|one| one["name"] == name).unwrap().clone();
    let colours = named(&described["components"], "Colours");
    assert_eq!(&named(&colours["params"], "orange_luma_min")["value"], luma);
}

#[test]
fn field_boundary_is_shown_with_rejected_points() {
    let (page, _) = running();
    let image = watched_image(&page);
    let message = |image: u32| Request::Extension { name: "boundary".to_owned(), message: json!({ "image": image }) };
    let boundary = page.ask(message(image)).unwrap();
    let columns = boundary["columns"].as_array().unwrap();
    assert_eq!(columns.len(), 40);
    let inliers = columns.iter().filter(|column| column["verdict"] == "inlier").count();
    assert_eq!(boundary["corners"].as_array().unwrap().is_empty(), inliers == 0, "{boundary}");
    assert!(page.ask(message(1_000_000)).is_err());
}
