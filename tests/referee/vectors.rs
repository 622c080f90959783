//! Packets compared with an encoder that shares no code with this repository: Python's `struct`.

use std::env;
use std::process::Command;
use std::str::FromStr;

use bica_player::referee::packet::{BallReport, CONTROL_BYTES, Control, PlayerInfo, Status, Team};

/// Runs the encoder for `count` packets of each kind; `None` without Python. In CI, which has Python, it must run.
fn vectors(count: usize) -> Option<String> {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/referee/vectors.py");
    let run = Command::new("python3").args([script, &count.to_string(), "2026"]).output();
    match run {
        Ok(run) => {
            assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
            Some(String::from_utf8(run.stdout).expect("text"))
        }
        Err(error) => {
            assert!(env::var_os("CI").is_none(), "python3 does not start: {error}");
            eprintln!("skipped: python3 does not start: {error}");
            None
        }
    }
}

fn bytes(hex: &str) -> Vec<u8> {
    (0..hex.len()).step_by(2).map(|at| u8::from_str_radix(&hex[at..at + 2], 16).expect("two digits")).collect()
}

fn numbers<'a, T: FromStr<Err: core::fmt::Debug>>(fields: impl Iterator<Item = &'a str>) -> Vec<T> {
    fields.map(|field| field.parse().expect("a number")).collect()
}

/// Returns all fields of a packet as numbers, in the order of the packet.
fn fields(control: &Control) -> Vec<i32> {
    let &Control { version, number, players_per_team, competition, stopped, first_half, kicking_team, .. } = control;
    let mut fields: Vec<i32> = [version.number(), number, players_per_team, competition].map(i32::from).into();
    fields.extend([i32::from(stopped), control.game_phase as i32, control.state as i32, control.set_play as i32]);
    fields.extend([i32::from(first_half), i32::from(kicking_team.unwrap_or(255))]);
    fields.extend([control.seconds_remaining, control.secondary_seconds].map(i32::from));
    for team in &control.teams {
        let &Team { number, field_colour, keeper_colour, goalkeeper, score, penalty_shot, .. } = team;
        fields.extend([number, field_colour, keeper_colour, goalkeeper, score, penalty_shot].map(i32::from));
        fields.extend([team.single_shots, team.message_budget].map(i32::from));
        for PlayerInfo { penalty, seconds, warnings, cautions } in team.players {
            let penalty = penalty.number(version).expect("a number of this version");
            fields.extend([penalty, seconds, warnings, cautions].map(i32::from));
        }
    }
    fields
}

#[test]
fn packets_equal_those_of_another_encoder() {
    let count = bica_test_data::cases(500, 10_000);
    let Some(vectors) = vectors(count) else { return };
    let mut counts = [0; 2];
    for line in vectors.lines() {
        let mut words = line.split(' ');
        let (kind, sent) = (words.next().expect("a kind"), bytes(words.next().expect("bytes")));
        if kind == "control" {
            let control = Control::parse(&sent).expect("a packet");
            assert_eq!(fields(&control), numbers::<i32>(words));
            assert_eq!(control.encode(&mut [0; CONTROL_BYTES]).expect("all penalties"), sent);
            counts[0] += 1;
        } else {
            let numbers = numbers::<f32>(words);
            let [player, team, fallen, seen, x, y, heading, age, forward, left] = numbers[..] else {
                panic!("{} fields", numbers.len())
            };
            let ball = (seen > 0.0).then_some(BallReport { age, at: [forward, left] });
            let status =
                Status { player: player as u8, team: team as u8, fallen: fallen > 0.0, pose: [x, y, heading], ball };
            assert_eq!(status.encode()[..], sent);
            let read = Status::parse(&sent).expect("a message");
            assert_eq!((read.player, read.team, read.fallen), (status.player, status.team, status.fallen));
            assert!(read.pose.iter().zip(status.pose).all(|(read, sent)| (read - sent).abs() < 1e-5));
            assert_eq!(read.ball.map(|ball| ball.age.to_bits()), ball.map(|ball| ball.age.to_bits()));
            counts[1] += 1;
        }
    }
    assert_eq!(counts, [count; 2]);
}
