//! Player under the commands of a `GameController`, over UDP on this computer.

use std::collections::BTreeSet;
use std::io::{BufRead, BufReader, Read};
use std::net::{Ipv4Addr, SocketAddr, UdpSocket};
use std::process::{Child, ChildStdout, Command, Stdio};
use std::time::{Duration, Instant};

use bica_player::referee::packet::{CONTROL_BYTES, Control, Penalty, PlayState, Status, Team, Version};
use bica_player::referee::{Identity, Inbox};
use bica_player::team::{Role, TeamMessage};

use crate::process::{Folder, player, refused, run};

/// Longest wait, for busy computers.
const PATIENCE: Duration = Duration::from_mins(1);

/// `GameController` of this test.
struct Controller {
    socket: UdpSocket,
    /// Address of the player's socket.
    to: SocketAddr,
    number: u8,
    message_budget: u16,
    /// Penalty of player 1 of team 5.
    penalty: Penalty,
}

/// Returns a port that no program uses.
fn free_port() -> u16 {
    let socket = UdpSocket::bind("127.0.0.1:0").expect("a port");
    socket.local_addr().expect("an address").port()
}

impl Controller {
    fn new() -> Self {
        let socket = UdpSocket::bind("127.0.0.1:0").expect("a socket");
        socket.set_read_timeout(Some(Duration::from_millis(100))).expect("a time-out");
        Self {
            socket,
            to: SocketAddr::from(([127, 0, 0, 1], free_port())),
            number: 0,
            message_budget: 0,
            penalty: Penalty::None,
        }
    }

    fn return_port(&self) -> String {
        self.socket.local_addr().expect("an address").port().to_string()
    }

    fn send(&mut self, version: Version, state: PlayState) {
        self.number = self.number.wrapping_add(1);
        let mut teams = [23, 5].map(|number| Team { number, message_budget: self.message_budget, ..Team::default() });
        teams[1].players[0].penalty = self.penalty;
        let control =
            Control { version, number: self.number, state, teams, seconds_remaining: 600, ..Control::default() };
        let mut out = [0; CONTROL_BYTES];
        let datagram = control.encode(&mut out).expect("no penalty");
        self.socket.send_to(datagram, self.to).expect("it is sent");
        // Datagrams that must be ignored: another length, another header, the true state.
        for noise in [&datagram[1..], b"RGTD", b"RGme\x15", b""] {
            self.socket.send_to(noise, self.to).expect("it is sent");
        }
    }

    /// Next status message; `None` after 0.1 s without one.
    fn receive(&self) -> Option<Status> {
        let mut buffer = [0; 64];
        let (length, _) = self.socket.recv_from(&mut buffer).ok()?;
        Some(Status::parse(&buffer[..length]).expect("a status message"))
    }
}

/// Player 3 of team 5, in real time. Dropping it ends the program.
struct Played {
    program: Child,
    lines: BufReader<ChildStdout>,
}

impl Played {
    fn start(controller: &Controller, more: &[&str]) -> Self {
        let (port, answers) = (controller.to.port().to_string(), controller.return_port());
        let play = ["play", "--referee", "--team", "5", "--player", "3", "--size", "160x120"];
        let ports = ["--control-port", &port, "--return-port", &answers, "--broadcast", "127.255.255.255"];
        let mut command = player(&[&play[..], &ports, more].concat());
        let mut program = command.stdout(Stdio::piped()).spawn().expect("the program");
        let lines = BufReader::new(program.stdout.take().expect("a pipe"));
        Self { program, lines }
    }

    /// Waits for an output line that contains a text.
    fn prints(&mut self, text: &str) {
        let mut lines = self.lines.by_ref().lines().map_while(Result::ok);
        assert!(lines.any(|line| line.contains(text)), "the program ended before `{text}`");
    }
}

impl Drop for Played {
    fn drop(&mut self) {
        let _ = self.program.kill();
        let _ = self.program.wait();
    }
}

#[test]
fn player_answers_packets_of_both_versions() {
    for version in [Version::V19, Version::V20] {
        let mut controller = Controller::new();
        let _played = Played::start(&controller, &[]);
        let (start, mut times) = (Instant::now(), Vec::new());
        while times.len() < 5 {
            controller.send(version, PlayState::Initial);
            let until = Instant::now() + Duration::from_millis(500);
            while Instant::now() < until {
                if let Some(status) = controller.receive() {
                    assert_eq!((status.team, status.player, status.fallen, status.ball), (5, 3, false, None));
                    times.push(start.elapsed());
                }
            }
            assert!(start.elapsed() < PATIENCE, "{} messages", times.len());
        }
    }
}

/// Returns the base of free team ports, and a function that sends the message of another player, the striker, with a number.
fn mate() -> (String, impl Fn(u32) + Send + 'static) {
    const TEAM: u8 = 5;
    let port = free_port();
    let socket = UdpSocket::bind((Ipv4Addr::LOCALHOST, 0)).expect("a free port");
    let send = move |number: u32| {
        let from = Identity { team: TEAM, player: 2 };
        let (role, time_ms) = (Role::Striker, 1 + number);
        let message = TeamMessage { from, time_ms, role, claim: 9, interval: 5.0, ..TeamMessage::default() };
        // Before the player listens, nobody receives it.
        let _ = socket.send_to(&message.encode(), (Ipv4Addr::LOCALHOST, port));
    };
    ((port - u16::from(TEAM)).to_string(), send)
}

#[test]
fn packets_change_the_state_and_replay_bit_for_bit() {
    let folder = Folder::new("referee");
    let file = folder.file("game.mcap");
    let mut controller = Controller::new();
    let (base, mate) = mate();
    let more = ["--record", &file, "--seconds", "6", "--team-ports", &base];
    let mut played = Played::start(&controller, &more);
    let (to, socket) = (controller.to, controller.socket.try_clone().expect("a socket"));
    let sender = std::thread::spawn(move || {
        let mut sending = Controller { socket, to, number: 0, message_budget: 0, penalty: Penalty::None };
        for state in [PlayState::Initial, PlayState::Ready, PlayState::Set, PlayState::Playing].into_iter().cycle() {
            sending.send(Version::V20, state);
            mate(u32::from(sending.number));
            std::thread::sleep(Duration::from_millis(500));
            if sending.number > 20 {
                break;
            }
        }
    });
    let states = ["TeamPlayer:ready", "TeamPlayer:set", "TeamPlayer:playing", "status messages sent"];
    for state in states {
        played.prints(state);
    }
    played.prints("team messages sent: 0; other datagrams refused");
    assert!(played.program.wait().expect("it ends").success());
    sender.join().expect("the sender");
    assert!(controller.receive().is_some());
    controller.number = 0;
    let replayed = run(&["replay", &file]);
    assert!(replayed.code == Some(0) && replayed.stdout.contains("equal, bit for bit"), "{}", replayed.stdout);
}

#[test]
fn small_controller_commands_a_player() {
    let folder = Folder::new("controller");
    let script = folder.file("half.txt");
    let text = "wait 2\nready 23  # the other team kicks off\nwait 2\nset\nwait 2\nplaying\nwait 2\npenalty 5 3 pushing\n\
                wait 2\npenalty 5 3 none\nwait 2\nfinished\nwait 60\n";
    std::fs::write(&script, text).expect("a file");
    let mut controller = Controller::new();
    let mut played = Played::start(&controller, &[]);
    // From here on the port of the status messages belongs to the small controller.
    let (port, answers) = (controller.to.port().to_string(), controller.return_port());
    controller.socket = UdpSocket::bind("127.0.0.1:0").expect("a socket");
    let ports = ["--control-port", &port, "--return-port", &answers];
    let arguments = [&["referee", "--to", "127.0.0.1", "--players", "3", "--script", &script][..], &ports].concat();
    let mut referee = player(&arguments);
    let mut referee = referee.stdout(Stdio::piped()).spawn().expect("the program");
    for state in ["ready", "set", "wait", "penalized", "finished"] {
        played.prints(&format!("TeamPlayer:{state}"));
    }
    let lines = BufReader::new(referee.stdout.take().expect("a pipe")).lines();
    assert!(lines.map_while(Result::ok).any(|line| line.contains("team 5 player 3 from 127.0.0.1")));
    referee.kill().expect("it runs");
    referee.wait().expect("it ends");
}

#[test]
fn small_controller_is_commanded_by_a_monitor() {
    let robot = UdpSocket::bind("127.0.0.1:0").expect("a socket");
    robot.set_read_timeout(Some(PATIENCE)).expect("a time-out");
    let port = |socket: &UdpSocket| socket.local_addr().expect("an address").port().to_string();
    let (base, mate) = mate();
    let arguments = ["referee", "--to", "127.0.0.1", "--players", "3", "--serve", "127.0.0.1:0", "--budget", "100"];
    let ports = ["--control-port", &port(&robot), "--return-port", &free_port().to_string(), "--team-ports", &base];
    let mut referee = player(&[&arguments[..], &ports].concat());
    let mut referee = referee.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("the program");
    let mut lines = BufReader::new(referee.stdout.take().expect("a pipe")).lines().map_while(Result::ok);
    let address = lines.find_map(|line| Some(line.split_once("attach at ")?.1.to_owned())).expect("an address");
    let link = |args: &[&str]| assert_eq!(run(&[&["link", &address][..], args].concat()).code, Some(0), "{args:?}");
    link(&["modulate", "Referee.ready", "Second"]);
    link(&["modulate", "Referee.penalty", "First", "3", "Pushing"]);
    mate(1);
    mate(2);
    let mut inbox = Inbox::new(5);
    let mut packet = |wanted: &dyn Fn(&Control) -> bool| {
        let (mut buffer, start) = ([0; 256], Instant::now());
        while start.elapsed() < PATIENCE {
            let length = robot.recv(&mut buffer).expect("packets come");
            if inbox.take(&buffer[..length]).is_some_and(|control| wanted(&control)) {
                return;
            }
        }
        panic!("no such packet");
    };
    packet(&|control| {
        let Control { state, kicking_team, teams: [own, other], .. } = control;
        (*state, *kicking_team, own.players[2].penalty) == (PlayState::Ready, Some(23), Penalty::Pushing)
            && (own.message_budget, other.message_budget) == (98, 100)
    });
    // The stop of any robot, which needs no lease.
    link(&["stop"]);
    packet(&|control| control.stopped);
    assert!(lines.any(|line| line.contains("Ready, stopped")), "commands of a monitor are printed");
    referee.kill().expect("it runs");
    referee.wait().expect("it ends");
}

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

#[test]
fn wrong_teams_players_and_scripts_are_refused() {
    let folder = Folder::new("script");
    let script = folder.file("half.txt");
    std::fs::write(&script, "ready\nbegin\n").expect("a file");
    let play = |more: &[&'static str]| [&["play", "--referee"][..], more].concat();
    for (args, words) in [
        (play(&[]), &["`BICA`", "--team N"][..]),
        (play(&["--team", "256"]), &["`256`", "0 to 254"]),
        (play(&["--team", "255"]), &["255", "0 to 254"]),
        (play(&["--team", "5", "--player", "0"]), &["number 0", "1 to 20"]),
        (play(&["--team", "5", "--player", "21"]), &["number 21", "1 to 20"]),
        (play(&["--team", "5", "--games", "2"]), &["--games"]),
        (play(&["--team", "5", "--world", "firmware"]), &["--world"]),
        (vec!["play", "--referee=nowhere", "--team", "5"], &["nowhere", "IPv4"]),
        (vec!["play", "--player", "2"], &["--referee"]),
        (vec!["play", "--world", "team"], &["--teams 5,23"]),
        (vec!["play", "--teams", "5,23"], &["--world team or --world mujoco"]),
        (vec!["play", "--world", "team", "--teams", "5,23", "--idle"], &["--games N"]),
        (vec!["play", "--world", "team", "--teams", "5,23", "--games", "1", "--truth", "t"], &["--truth"]),
        (vec!["play", "--world", "team", "--teams", "5,23", "--film", "f.gif"], &["--record FOLDER"]),
        (play(&["--team", "5", "--match", "--serve", "127.0.0.1:0"]), &["--match", "--serve"]),
        (vec!["referee", "--teams", "5,5"], &["two different numbers"]),
        (vec!["referee", "--players", "21"], &["21"]),
        (vec!["referee", "--team-ports", "65530"], &["team 23", "smaller --team-ports"]),
        (vec!["referee", "--serve", "0.0.0.0:0"], &["--listen-anywhere"]),
        (vec!["referee", "--script", &script], &["half.txt:2", "no command `begin`"]),
    ] {
        refused(&args, words);
    }
}
