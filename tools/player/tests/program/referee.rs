//! Player under the commands of a `GameController`, over UDP on this computer.

use std::io::{BufRead, BufReader, Read};
use std::net::{SocketAddr, UdpSocket};
use std::process::{Child, ChildStdout, Stdio};
use std::time::{Duration, Instant};

use bica_player::referee::packet::{CONTROL_BYTES, Control, PlayState, Status, Team, Version};

use crate::process::{Folder, player, refused, run};

/// Longest wait, for busy computers.
const PATIENCE: Duration = Duration::from_mins(1);

/// `GameController` of this test.
struct Controller {
    socket: UdpSocket,
    /// Address of the player's socket.
    to: SocketAddr,
    number: u8,
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
        Self { socket, to: SocketAddr::from(([127, 0, 0, 1], free_port())), number: 0 }
    }

    fn return_port(&self) -> String {
        self.socket.local_addr().expect("an address").port().to_string()
    }

    fn send(&mut self, version: Version, state: PlayState) {
        self.number = self.number.wrapping_add(1);
        let teams = [23, 5].map(|number| Team { number, ..Team::default() });
        let control = Control { version, number: self.number, state, teams, ..Control::default() };
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
        let ports = ["--control-port", &port, "--return-port", &answers];
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

#[test]
fn packets_change_the_state_and_replay_bit_for_bit() {
    let folder = Folder::new("referee");
    let file = folder.file("game.mcap");
    let mut controller = Controller::new();
    let mut played = Played::start(&controller, &["--record", &file, "--seconds", "6"]);
    let (to, socket) = (controller.to, controller.socket.try_clone().expect("a socket"));
    let sender = std::thread::spawn(move || {
        let mut sending = Controller { socket, to, number: 0 };
        for state in [PlayState::Initial, PlayState::Ready, PlayState::Set, PlayState::Playing].into_iter().cycle() {
            sending.send(Version::V20, state);
            std::thread::sleep(Duration::from_millis(500));
            if sending.number > 20 {
                break;
            }
        }
    });
    for state in ["TeamPlayer:ready", "TeamPlayer:set", "TeamPlayer:playing", "status messages sent"] {
        played.prints(state);
    }
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
        (vec!["referee", "--teams", "5,5"], &["two different numbers"]),
        (vec!["referee", "--players", "21"], &["21"]),
        (vec!["referee", "--script", &script], &["half.txt:2", "no command `begin`"]),
    ] {
        refused(&args, words);
    }
}
