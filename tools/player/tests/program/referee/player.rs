//! Player under the commands of a `GameController`.

use std::time::{Duration, Instant};

use bica_player::referee::packet::{Penalty, PlayState, Version};

use super::{Controller, PATIENCE, Played, mate};
use crate::process::{Folder, run};

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
    let (base, mate) = mate();
    let more = ["--record", &file, "--seconds", "6", "--team-ports", &base];
    let mut played = Played::start(&controller, &more);
    let (to, socket) = (controller.to, controller.socket.try_clone().expect("a socket"));
    let sender = std::thread::spawn(move || {
        let mut sending = Controller { socket, to, number: 0, message_budget: 1200, penalty: Penalty::None };
        // Each message changes the part of the player, so a replay with other messages, or in another order, differs.
        for state in [PlayState::Initial, PlayState::Ready, PlayState::Set].into_iter().chain([PlayState::Playing; 18])
        {
            sending.send(Version::V20, state);
            mate(sending.number.into());
            std::thread::sleep(Duration::from_millis(500));
        }
    });
    let states = ["TeamPlayer:ready", "TeamPlayer:set", "TeamPlayer:playing", "status messages sent"];
    for state in states {
        played.prints(state);
    }
    played.prints("team messages sent: ");
    assert!(played.program.wait().expect("it ends").success());
    sender.join().expect("the sender");
    assert!(controller.receive().is_some());
    controller.number = 0;
    let replayed = run(&["replay", &file]);
    assert!(replayed.code == Some(0) && replayed.stdout.contains("equal, bit for bit"), "{}", replayed.stdout);
}
