//! Small controller: the program `player referee`.

use std::io::{BufRead, BufReader};
use std::net::UdpSocket;
use std::process::Stdio;
use std::time::Instant;

use bica_player::referee::Inbox;
use bica_player::referee::packet::{Control, Penalty, PlayState};

use super::{Controller, PATIENCE, Played, free_port, mate};
use crate::process::{Folder, player, run};

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
