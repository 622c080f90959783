//! Damages packets at random for as long as is said, and holds that nothing panics and nothing wrong is accepted.
//!
//! `cargo run --release -p bica-wire --example fuzz -- SECONDS [SEED]`

use std::process::ExitCode;
use std::time::{Duration, Instant};

use bica_field::GoalColour;
use bica_motion::joints::JOINTS;
use bica_wire::message::{Chunk, Command, Hello, Pace, Sensors};
use bica_wire::{Frame, FromRobot, MAX_PACKET, Receiver, Sender, ToRobot};

/// A sequence of pseudo-random numbers (`SplitMix64`, S. Vigna).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, end: usize) -> usize {
        (self.next() % end.max(1) as u64) as usize
    }
}

fn main() -> ExitCode {
    let mut words = std::env::args().skip(1).map(|word| word.parse().ok());
    let Some(Some(seconds)) = words.next() else {
        eprintln!("fuzz SECONDS [SEED]");
        return ExitCode::from(2);
    };
    let mut random = Random(words.next().flatten().unwrap_or(0));
    let (began, mut streams, mut accepted) = (Instant::now(), 0_u64, 0_u64);
    while began.elapsed() < Duration::from_secs(seconds) {
        for _ in 0..1000 {
            accepted += round(&mut random);
            streams += 1;
        }
    }
    println!("{streams} damaged streams, {accepted} messages accepted, every one of them as it was sent");
    ExitCode::SUCCESS
}

/// One stream of messages both ways, damaged; how many messages came through.
fn round(random: &mut Random) -> u64 {
    let piece: Vec<u8> = (0..random.below(1025)).map(|_| random.next() as u8).collect();
    let (up, down) = messages(random, &piece);
    let (mut sender, mut room) = (Sender::new(), [0; MAX_PACKET]);
    let mut pack = |message: &dyn Fn(&mut Sender, &mut [u8]) -> Vec<u8>| message(&mut sender, &mut room);
    let mut stream = Vec::new();
    for message in &up {
        stream.extend(pack(&|sender, room| sender.pack(message, room).expect("it fits").to_vec()));
    }
    for message in &down {
        stream.extend(pack(&|sender, room| sender.pack(message, room).expect("it fits").to_vec()));
    }
    damage(random, &mut stream);
    let (mut receiver, mut frame, mut accepted) = (Receiver::<MAX_PACKET>::new(), Frame::<4096>::new(), 0);
    for byte in stream {
        let Some(heard) = receiver.push(byte) else { continue };
        let (to, from) = (heard.read::<ToRobot<'_>>(), heard.read::<FromRobot<'_>>());
        let known = to.as_ref().is_ok_and(|to| up.contains(to)) || from.as_ref().is_ok_and(|from| down.contains(from));
        assert!(known, "accepted {to:?} {from:?}, which nobody sent");
        if let Ok(ToRobot::Chunk(chunk)) = to {
            frame.add(&chunk);
        }
        accepted += 1;
    }
    accepted
}

fn messages<'a>(random: &mut Random, piece: &'a [u8]) -> (Vec<ToRobot<'a>>, Vec<FromRobot<'a>>) {
    let mut floats = || -> [f32; JOINTS] { core::array::from_fn(|_| random.below(2000) as f32 / 100.0 - 10.0) };
    let (angles, temperatures, currents, targets) = (floats(), floats(), floats(), floats());
    let sensors = Sensors {
        time_us: random.next(),
        angles,
        temperatures,
        currents,
        inertial: [0.0; 8],
        feet: [1.0; 8],
        buttons: [true; 3],
        picture: None,
    };
    let hello = Hello { schema: random.next(), pace: Pace::Clock, attack: GoalColour::SkyBlue };
    let (image, at) = (random.next() as u32, random.next() as u32);
    let command =
        Command { time_us: random.next(), targets, stiffness: [0.5; JOINTS], lights: [0.0; 9], bottom: false };
    (
        vec![ToRobot::Hello(hello), ToRobot::Chunk(Chunk { image, at, bytes: piece }), ToRobot::Sensors(sensors)],
        vec![FromRobot::Command(command)],
    )
}

/// Flips, removes, doubles, inserts and cuts.
fn damage(random: &mut Random, stream: &mut Vec<u8>) {
    for _ in 0..=random.below(8) {
        let place = random.below(stream.len());
        let end = (place + random.below(40)).min(stream.len());
        match random.below(6) {
            0 => stream[place..end].iter_mut().for_each(|byte| *byte ^= random.next() as u8),
            1 => drop(stream.drain(place..end)),
            2 => stream.splice(place..place, (0..random.below(20)).map(|_| 0)).for_each(drop),
            3 => stream.extend_from_within(place..end),
            4 if place > 0 => stream.truncate(place.max(1)),
            _ => stream.insert(place, random.next() as u8),
        }
    }
}
