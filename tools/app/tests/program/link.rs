//! A served run with monitors.

use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::process::{Folder, Served, example, link, refused};

fn start() -> Served {
    let mut program = example("wall_follower");
    program.args(["run", "--serve", "127.0.0.1:0"]);
    Served::start(program)
}

#[test]
fn operator_watches_tunes_and_drives_a_paused_robot() {
    let served = start();
    link(&served, &["pause"]);
    let description = &link(&served, &["describe", "Drive"])[0];
    assert_eq!(
        (&description["name"], &description["components"][0]["name"]),
        (&"WallFollower".into(), &"Drive".into())
    );
    assert_eq!(link(&served, &["set", "Explorer.speed=0.3"])[0]["name"], "Explorer.speed");
    let explorer = &link(&served, &["describe", "Explorer"])[0]["components"][0];
    let speed = explorer["params"].as_array().and_then(|list| list.iter().find(|one| one["name"] == "speed"));
    assert_eq!(speed.map(|one| &one["value"]), Some(&0.3.into()), "a parameter stays");
    assert_eq!(link(&served, &["rate", "Explorer", "5", "--seconds", "0.01"])[0]["values"][0], 5.0);
    for (args, error) in [
        (&["set", "Explorer.speed=9"][..], "is outside"),
        (&["set", "Explorer.speed=high"], "`high` is not a value of `speed`"),
        (&["set", "Explorer.sped=0.5"], "did you mean `speed`?"),
        (&["hold", "Exploror", "latent"], "did you mean `Explorer`?"),
        (&["watch", "Odometry.pos"], "did you mean `pose`?"),
        (&["modulate", "Drive.request", "1"], "takes 2 arguments, found 1"),
        (&["modulate", "Drive.request", "1", "0", "--hold", "Explorer=off"], "COMPONENT=latent"),
    ] {
        refused(&[&["link", &served.address][..], args].concat(), &[error]);
    }
    link(&served, &["go", "Explorer", "arrive"]);
    refused(&["link", &served.address, "go", "Explorer", "arrives"], &["did you mean `arrive`?"]);
    link(&served, &["step", "1"]);
    let watched = link(&served, &["watch", "--count", "1"]);
    let gone = watched.iter().find(|line| line["schema"] == "bica/link-snapshot/1").expect("a snapshot");
    assert_eq!(gone["components"][0]["state"], "arrive");
    link(&served, &["hold", "Explorer", "latent", "--seconds", "0.01"]);
    link(&served, &["modulate", "Drive.request", "0.2", "1.0"]);
    // Options may stand behind values, of which some are negative.
    let drive =
        ["modulate", "Drive.request", "0.2", "-1.0", "--take", "--hold", "Explorer=latent", "--seconds", "0.01"];
    assert_eq!(link(&served, &drive).len(), 2, "a hold and a call");
    link(&served, &["step", "50"]);
    let watched = link(&served, &["watch", "Odometry.pose", "--count", "1"]);
    let snapshot = watched.iter().find(|line| line["schema"] == "bica/link-snapshot/1").expect("a snapshot");
    let explorer = &snapshot["components"][0];
    assert_eq!((&explorer["held"], &explorer["hz"]), (&"tree".into(), &25.0.into()), "each lease has ended");
}

#[test]
fn true_pose_equals_odometry_from_the_true_start() {
    let served = start();
    let watched = link(&served, &["watch", "Odometry.pose", "--truth", "--count", "60"]);
    let of = |schema: &'static str| watched.iter().filter(move |line| line["schema"] == schema);
    let axes = |value: &Value| ["x", "y"].map(|axis| value[axis].as_f64().expect("a number"));
    let mut compared = 0;
    for truth in of("bica/link-truth/2") {
        let [start, robot, _] = &truth["items"].as_array().expect("items")[..] else { panic!("{truth}") };
        let places = [&start["frame"], &start["child"], &robot["frame"], &robot["child"]];
        assert_eq!(places, ["room", "odometry", "room", "robot"]);
        // The truth was read after its cycle; the rotation of the wheels is measured in the next one.
        let is_of_cycle = |info: &&Value| {
            truth["time_us"].as_u64().map(|time| time + 20_000) == info["cycle"].as_u64().map(|cycle| 20_000 * cycle)
        };
        for pose in of("bica/link-info/1").filter(is_of_cycle) {
            let (start, robot, driven) = (axes(&start["value"]), axes(&robot["value"]), axes(&pose["value"]));
            let error = (robot[0] - start[0] - driven[0]).hypot(robot[1] - start[1] - driven[1]);
            assert!(error < 1e-3, "{truth} {pose}");
            compared += 1;
        }
    }
    assert!(compared > 20, "{compared}");
}

#[test]
fn a_stop_ends_a_hold_with_its_reason() {
    let served = start();
    let mut program = example("wall_follower");
    program.args(["link", &served.address, "hold", "Explorer", "latent"]);
    let mut hold = program.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    hold.stdout.as_mut().expect("a pipe").read_exact(&mut [0; 5]).expect("the hold is in force");
    link(&served, &["stop"]);
    let ended = hold.wait_with_output().expect("it ends");
    let error = String::from_utf8(ended.stderr).expect("UTF-8");
    assert!(ended.status.code() == Some(2) && error.contains("the lease has ended by a stop"), "{error}");
}

#[cfg(unix)]
#[test]
fn interrupt_ends_a_served_run_with_its_report() {
    let mut served = start();
    let id = served.child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().expect("kill runs").success());
    let mut rest = String::new();
    served.stdout.read_to_string(&mut rest).expect("UTF-8");
    assert_eq!(served.child.wait().expect("it ends").code(), Some(130));
    assert!(rest.contains("stopped by Ctrl-C") && rest.contains("cycles at 50 Hz") && rest.contains("####"), "{rest}");
}

#[test]
fn images_in_the_sensor_values_are_sent() {
    let mut program = example("camera");
    program.args(["run", "--serve", "127.0.0.1:0"]);
    let (served, folder) = (Served::start(program), Folder::new("images"));
    let seen = link(&served, &["watch", "--images", &folder.file("seen"), "--count", "50"]);
    let images: Vec<_> = seen.iter().filter(|line| line["schema"] == "bica/link-image/2").collect();
    let image = images.last().unwrap_or_else(|| panic!("{seen:?}"));
    assert_eq!((&image["camera"], &image["width"], &image["height"]), (&"eye".into(), &16.into(), &12.into()));
    // Every second cycle has an image. Its brightness is the number of the cycle, twice the number of the image.
    let number = image["number"].as_u64().expect("a number");
    let pixels = fs::read(image["path"].as_str().expect("a file")).expect("an image");
    assert_eq!(pixels, [2 * number as u8, 128].repeat(16 * 12));
}
