//! Matches of both teams.

use std::collections::BTreeSet;
use std::io::{BufRead, BufReader};
use std::net::SocketAddr;
use std::process::{Command, Stdio};
use std::time::Instant;

use bica_player::referee::packet::{Penalty, PlayState, Version};

use super::{Controller, PATIENCE};
use crate::process::{Folder, player, refused, run};

#[cfg(unix)]
#[test]
fn match_of_both_teams_writes_the_truth() {
    let folder = Folder::new("match");
    let path = folder.file("truth.sock");
    let listener = std::os::unix::net::UnixListener::bind(&path).expect("a socket");
    let mut controller = Controller::new();
    let (port, answers) = (controller.to.port().to_string(), controller.return_port());
    let play = ["play", "--world", "team", "--teams", "5,23", "--players", "2", "--size", "160x120", "--seconds", "4"];
    let ports = ["--control-port", &port, "--return-port", &answers, "--broadcast", "127.255.255.255", "--match"];
    let mut game = player(&[&play[..], &ports, &["--truth", &path]].concat());
    let mut game = game.stdout(Stdio::piped()).spawn().expect("the program");
    let (truth, _) = listener.accept().expect("the world connects");
    controller.to = SocketAddr::from(([127, 255, 255, 255], controller.to.port()));
    controller.socket.set_broadcast(true).expect("a broadcast");
    let (start, mut heard) = (Instant::now(), BTreeSet::new());
    while heard.len() < 4 {
        assert!(start.elapsed() < PATIENCE, "{heard:?}");
        controller.send(Version::V20, PlayState::Initial);
        while let Some(status) = controller.receive() {
            heard.insert((status.team, status.player));
        }
    }
    assert_eq!(heard.into_iter().collect::<Vec<_>>(), [(5, 1), (5, 2), (23, 1), (23, 2)]);
    let lines: Vec<serde_json::Value> = BufReader::new(truth)
        .lines()
        .map_while(Result::ok)
        .map(|line| serde_json::from_str(&line).expect("JSON"))
        .collect();
    assert!(game.wait().expect("it ends").success());
    assert!(lines.len() >= 40, "{} lines in 4 s", lines.len());
    let robots = lines[lines.len() - 1]["robots"].as_array().expect("robots");
    let names: Vec<_> = robots.iter().map(|robot| (robot["team"].as_u64(), robot["player"].as_u64())).collect();
    assert_eq!(names, [(Some(5), Some(1)), (Some(5), Some(2)), (Some(23), Some(1)), (Some(23), Some(2))]);
    assert!(robots.iter().all(|robot| robot["x"].as_f64().is_some_and(|x| x < -1.0) && robot["fallen"] == false));
}

#[cfg(unix)]
#[test]
fn penalized_player_is_carried_to_its_side_line() {
    let folder = Folder::new("carried");
    let path = folder.file("truth.sock");
    let listener = std::os::unix::net::UnixListener::bind(&path).expect("a socket");
    let mut controller = Controller::new();
    let (port, answers) = (controller.to.port().to_string(), controller.return_port());
    let play = ["play", "--world", "team", "--teams", "5,23", "--players", "1", "--size", "160x120", "--truth", &path];
    let ports = ["--control-port", &port, "--return-port", &answers, "--broadcast", "127.255.255.255", "--match"];
    let mut game = player(&[&play[..], &ports].concat()).stdout(Stdio::null()).spawn().expect("the program");
    let (truth, _) = listener.accept().expect("the world connects");
    controller.to = SocketAddr::from(([127, 255, 255, 255], controller.to.port()));
    controller.socket.set_broadcast(true).expect("a broadcast");
    let pose = |line: &str| {
        let line: serde_json::Value = serde_json::from_str(line).expect("JSON");
        ["x", "y", "theta"].map(|name| line["robots"][0][name].as_f64().expect("a number"))
    };
    let mut lines = BufReader::new(truth).lines().map_while(Result::ok);
    let start = Instant::now();
    let is_at = |[x, y, theta]: [f64; 3], at: [f64; 3]| {
        (x - at[0]).abs() < 0.05 && (y - at[1]).abs() < 0.05 && (theta - at[2]).abs() < 0.1
    };
    for (penalty, at) in [(Penalty::None, [-2.5, 1.9, -1.57]), (Penalty::Pushing, [-1.5, -1.9, 1.57])] {
        controller.penalty = penalty;
        let mut step = 0;
        while step == 0 || !is_at(pose(&lines.next().expect("a line")), at) {
            step += 1;
            if step % 10 == 1 {
                controller.send(Version::V20, PlayState::Initial);
            }
            assert!(start.elapsed() < PATIENCE, "{penalty:?}");
        }
    }
    game.kill().expect("it runs");
    game.wait().expect("it ends");
}

fn a_recorded_match_replays(world: &str) {
    let folder = Folder::new(&format!("match-recordings-{world}"));
    let games = folder.file("games");
    let mut controller = Controller { message_budget: 1200, ..Controller::new() };
    let (port, answers) = (controller.to.port().to_string(), controller.return_port());
    let play = ["play", "--world", world, "--teams", "5,23", "--players", "1", "--size", "160x120", "--seconds", "6"];
    let ports = ["--control-port", &port, "--return-port", &answers, "--broadcast", "127.255.255.255", "--match"];
    let mut game = player(&[&play[..], &ports, &["--record", &games]].concat());
    let mut game = game.stdout(Stdio::piped()).spawn().expect("the program");
    controller.to = SocketAddr::from(([127, 255, 255, 255], controller.to.port()));
    controller.socket.set_broadcast(true).expect("a broadcast");
    let start = Instant::now();
    while game.try_wait().expect("a status").is_none() {
        controller.send(Version::V20, PlayState::Playing);
        while controller.receive().is_some() {}
        assert!(start.elapsed() < PATIENCE, "the match does not end");
    }
    assert!(game.wait().expect("it ends").success());
    for robot in ["5-1", "23-1"] {
        let replayed = run(&["replay", &format!("{games}/{robot}.mcap")]);
        assert!(replayed.code == Some(0) && replayed.stdout.contains("equal, bit for bit"), "{}", replayed.stdout);
    }
    let again = [&play[..], &["--record", &games]].concat();
    refused(&again, &["5-1.mcap", "--force"]);
    refused(&[&again[..], &["--images", "none"]].concat(), &["--images"]);
}

#[test]
fn match_recordings_replay_bit_for_bit() {
    a_recorded_match_replays("team");
}

#[cfg(feature = "mujoco")]
#[test]
fn match_recordings_of_mujoco_replay_bit_for_bit() {
    a_recorded_match_replays("mujoco");
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_halves_do_not_depend_on_the_number_of_threads() {
    let halves = |threads| {
        let play = ["play", "--world", "team", "--teams", "5,23", "--players", "2", "--size", "160x120", "--idle"];
        run(&[&play[..], &["--games", "2", "--seconds", "20", "--json", "--threads", threads]].concat()).json()
    };
    let one = halves("1");
    assert_eq!(one, halves("2"));
    let (team, half) = (&one["teams"][0], &one["halves"][1]);
    assert_eq!((one["teams"].as_array().map(Vec::len), team["team"].as_u64()), (Some(1), Some(5)));
    assert!(half["cycles"].as_u64().is_some_and(|cycles| cycles >= 2000), "{half}");
    assert!(team["one_striker"].as_f64().is_some_and(|share| (0.9..=1.0).contains(&share)), "{team}");
}

/// The port in a line of strace that binds, connects or sends, as `sin_port=htons(3838)`.
fn port(call: &str) -> Option<u16> {
    let (_, after) = call.split_once("htons(")?;
    after.split_once(')')?.0.parse().ok()
}

#[test]
#[ignore = "slow: `cargo xtask ci` installs strace and runs it"]
fn slow_match_uses_the_ports_of_the_rules_only() {
    let folder = Folder::new("match-network");
    let calls = folder.file("calls");
    let mut controller = Controller { message_budget: 1200, ..Controller::new() };
    let (control, answers) = (controller.to.port(), controller.socket.local_addr().expect("an address").port());
    let team = [10_005, 10_023];
    let ports = [control, answers].map(|port| port.to_string());
    let play = ["play", "--world", "team", "--teams", "5,23", "--players", "2", "--size", "160x120", "--seconds", "20"];
    let ports = ["--control-port", &ports[0], "--return-port", &ports[1], "--broadcast", "127.255.255.255", "--match"];
    let game = player(&[&play[..], &ports].concat());
    let mut strace = Command::new("strace");
    strace.args(["--follow-forks", "--trace=%network", "--string-limit=0", "--output", &calls]);
    let mut strace = strace.arg(game.get_program()).args(game.get_args()).stdout(Stdio::null()).spawn();
    let traced = strace.as_mut().expect("strace, which `apt-get install strace` installs");
    controller.to = SocketAddr::from(([127, 255, 255, 255], control));
    controller.socket.set_broadcast(true).expect("a broadcast");
    let start = Instant::now();
    let status = loop {
        controller.send(Version::V20, PlayState::Playing);
        while controller.receive().is_some() {}
        if let Some(status) = traced.try_wait().expect("a status") {
            break status;
        }
        assert!(start.elapsed() < PATIENCE, "the game does not end");
    };
    assert!(status.success(), "{status}");
    let text = std::fs::read_to_string(calls).expect("the calls");
    let calls_of = |name: &'static str| text.lines().filter(move |line| line.contains(name));
    assert!(calls_of(" socket(").all(|call| call.contains("AF_INET, SOCK_DGRAM")), "{text}");
    assert_eq!(calls_of(" connect(").count() + calls_of(" listen(").count(), 0, "{text}");
    let used = |name| calls_of(name).map(|call| port(call).unwrap_or_else(|| panic!("no port in {call}")));
    let (bound, sent): (BTreeSet<_>, BTreeSet<_>) = (used(" bind(").collect(), used(" sendto(").collect());
    assert_eq!(bound, BTreeSet::from([control, team[0], team[1]]));
    assert_eq!(sent, BTreeSet::from([answers, team[0], team[1]]), "answers and messages of both teams");
}
