//! Players under the commands of a `GameController`, over UDP on this computer.

mod controller;
mod matches;
mod player;

use std::io::{BufRead, BufReader, Read};
use std::net::{Ipv4Addr, SocketAddr, UdpSocket};
use std::process::{Child, ChildStdout, Stdio};
use std::time::Duration;

use bica_player::referee::Identity;
use bica_player::referee::packet::{CONTROL_BYTES, Control, Penalty, PlayState, Status, Team, Version};
use bica_player::team::{Role, TeamMessage};

use crate::process::{Folder, player, refused};

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

/// Returns the base of free team ports, and a function that sends the message of another player with a number; that of an even number
/// says that it is the striker, that of an odd one that it is absent.
fn mate() -> (String, impl Fn(u16) + Send + 'static) {
    const TEAM: u8 = 5;
    let port = free_port();
    let socket = UdpSocket::bind((Ipv4Addr::LOCALHOST, 0)).expect("a free port");
    let send = move |number: u16| {
        let (from, time_ms) = (Identity { team: TEAM, player: 2 }, 1 + u32::from(number));
        let role = if number.is_multiple_of(2) { Role::Striker } else { Role::Absent };
        let message = TeamMessage { from, time_ms, role, claim: number, interval: 5.0, ..TeamMessage::default() };
        // Before the player listens, nobody receives it.
        let _ = socket.send_to(&message.encode(), (Ipv4Addr::LOCALHOST, port));
    };
    ((port - u16::from(TEAM)).to_string(), send)
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
