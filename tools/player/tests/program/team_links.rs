//! Links of a match: one for each robot.

use std::io::{BufRead, BufReader};
use std::process::Stdio;
use std::time::Duration;

use bica_link::{Client, ClientOptions, Event};
use bica_wire::message::ExtraKind;

use crate::process::{Folder, player, refused, run};

const MATCH: [&str; 8] = ["play", "--world", "team", "--teams", "5,23", "--players", "1", "--size"];
/// Packets of other tests come to other ports.
const PORTS: [&str; 7] =
    ["160x120", "--control-port", "48381", "--return-port", "48382", "--broadcast", "127.255.255.255"];

/// Waits for the true position of the ball, m, in the field frame of a robot's team.
fn ball(address: &str, near: [f64; 2]) {
    let address = address.parse().expect("an address");
    let mut client = Client::connect(&address, ClientOptions::default()).expect("a link");
    client.watch_extra(ExtraKind::Truth, 1).expect("it offers the true state");
    for _ in 0..500 {
        let Some(Event::Truth(truth)) = client.poll(Duration::from_millis(100)).expect("the link lasts") else {
            continue;
        };
        let ball = &truth.items.iter().find(|item| item.name == "ball").expect("a ball").value;
        let at = ["x", "y"].map(|axis| ball[axis].as_f64().expect("a number"));
        if at.iter().zip(near).all(|(one, other)| (one - other).abs() < 1e-3) {
            return;
        }
    }
    panic!("the ball is not at {near:?}");
}

#[test]
fn each_robot_of_a_match_has_a_link() {
    let folder = Folder::new("match-links");
    let more = ["--seconds", "12", "--serve", "127.0.0.1:0", "--record", folder.text()];
    let mut game = player(&[&MATCH[..], &PORTS, &more].concat()).stdout(Stdio::piped()).spawn().expect("the program");
    let mut lines = BufReader::new(game.stdout.take().expect("a pipe")).lines().map_while(Result::ok);
    let mut address = |name: &str| {
        let line = lines.find(|line| line.contains("monitors attach at ")).expect("an address");
        line.split_once(&format!("{name}: monitors attach at ")).expect("its name").1.trim().to_owned()
    };
    let robots = [address("5-1"), address("23-1")];
    let link = |robot: usize, args: &[&str]| run(&[&["link", &robots[robot]][..], args].concat());
    let placed = link(1, &["act", "place_ball", "1.0", "0.5"]);
    assert_eq!(placed.code, Some(0), "{}", placed.stderr);
    ball(&robots[1], [1.0, 0.5]);
    ball(&robots[0], [-1.0, -0.5]);
    assert!(link(0, &["act", "place_ball", "-2.5", "1.9"]).stderr.contains("a robot"), "5-1 stands there");
    assert_eq!(link(0, &["set", "GoTo.speed=0.11"]).code, Some(0));
    let described = [0, 1].map(|robot| link(robot, &["describe", "GoTo"]).stdout);
    assert!(described[0].contains("speed = 0.11") && described[1].contains("speed = 0.2"), "{described:?}");
    assert_eq!(link(0, &["pause"]).code, Some(2), "a match follows its GameController");
    assert!(game.wait().expect("it ends").success());
    for robot in ["5-1", "23-1"] {
        let replayed = run(&["replay", &folder.file(&format!("{robot}.mcap"))]);
        assert!(replayed.code == Some(0) && replayed.stdout.contains("equal, bit for bit"), "{}", replayed.stdout);
    }
}

#[test]
fn a_match_refuses_links_that_it_cannot_have() {
    for (more, words) in [
        (&["--serve", "127.0.0.1:0", "--match"][..], &["--match", "--serve"][..]),
        (&["--serve", "127.0.0.1:65535"], &["robot 2", "65535"]),
        (&["--serve", "/dev/ttyUSB0"], &["serial line", "HOST:PORT"]),
        (&["--serve", "127.0.0.1:0", "--unpaced"], &["--unpaced"]),
        (&["--serve", "127.0.0.1:0", "--paused"], &["--paused"]),
    ] {
        refused(&[&MATCH[..], &PORTS, more].concat(), words);
    }
}
