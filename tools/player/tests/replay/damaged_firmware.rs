//! Games of a firmware image over a link with damaged packets. The host records what the microcontroller computed from
//! the received packets; the recording must replay.

use std::env;
use std::fs::File;
use std::path::{Path, PathBuf};

use bica::runner::Runner;
use bica::{Instant, Tree};
use bica_field::GoalColour;
use bica_motion::model::simulation::NAO;
use bica_motion::robot::Command;
use bica_player::input::{IMAGE_BYTES, RobotProfile};
use bica_player::perception::GoalDetector;
use bica_player::tunable::Forward;
use bica_player_program::emulator::{Emulator, MESSAGES, SensorsMessage, Transport, command_bits, decode_command};
use bica_player_program::game::{FirmwareImage, recording_header};
use bica_recording::{Backpressure, ImagePolicy, Recorder, RecorderOptions};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::Setup;
use bica_wire::message::{ClockMode, Hello};
use bica_wire::{Decoder, FromRobot, ImageBuffer, MAX_PACKET, SCHEMA, ToRobot, blobs, encode};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};

use crate::files::{Temporary, replay_all, rules, with_stack};

/// Longest game, s.
const SECONDS: f32 = 30.0;
/// One of `DAMAGE` packets is damaged.
const DAMAGE: u32 = 150;

/// Forward on the host that receives the same bytes as the microcontroller.
struct Model {
    runner: Runner<Box<Forward>, (), (), Recorder>,
    decoder: Box<Decoder<MAX_PACKET>>,
    image: Box<ImageBuffer<IMAGE_BYTES>>,
    cycles: u64,
}

impl Model {
    /// Processes bytes; returns the command if they contain sensor values.
    fn receive(&mut self, bytes: &[u8]) -> Option<(u64, Command)> {
        let mut command = None;
        for &byte in bytes {
            let Some(packet) = self.decoder.push(byte) else { continue };
            match packet.message().expect("nothing is accepted that was not sent") {
                ToRobot::ImageChunk(chunk) => self.image.add(&chunk),
                ToRobot::Sensors(sensors) => {
                    let yuyv = sensors.blobs.as_ref().and_then(|info| self.image.take(info)).unwrap_or_default();
                    let now = Instant::from_micros(sensors.time_us);
                    let values = blobs::decode(sensors.values, yuyv).expect("nothing is accepted that was not sent");
                    self.runner.sense(now, &values).expect("the image fits");
                    command = Some((sensors.time_us, self.runner.think(now)));
                    self.cycles += 1;
                }
                other => panic!("{other:?} was not sent"),
            }
        }
        command
    }
}

/// Damages a packet: changes a byte, truncates it, or removes all of it.
fn damage(packet: &mut Vec<u8>, rng: &mut Pcg64) {
    let at = rng.next_u32() as usize % packet.len();
    match rng.next_u32() % 3 {
        0 => packet[at] ^= 1 << (rng.next_u32() % 8),
        1 => packet.truncate(at),
        _ => packet.clear(),
    }
}

/// Plays a game; returns the number of cycles, of cycles that the robot missed, and of images that it dropped.
fn play(image: &Path, file: &Temporary, seed: u64) -> (u64, u64, u32) {
    let rules = rules(seed, SECONDS);
    let setup = Setup { seed, frame: rules.size, ..Setup::default() };
    let mut world = KinematicWorld::new(NAO, &setup).expect("valid");
    let attacks = world.referee().attacks();
    let mut emulator = start(image, attacks);
    let mut robot = Box::new(Forward::new());
    robot.get_mut::<RobotProfile>().set(rules.world.profile());
    robot.get_mut::<GoalDetector>().attack(attacks);
    let target = File::create(&file.0).expect("room");
    let options = RecorderOptions { backpressure: Backpressure::Wait, ..RecorderOptions::default() };
    let header = recording_header(&rules, attacks, ImagePolicy::All).of_robot(&*robot);
    let recorder = Recorder::start(target, &header, options, |_| {}).expect("room");
    let mut model = Model {
        runner: Runner::new(robot, ()).with_observer(recorder),
        decoder: Box::default(),
        image: Box::new(ImageBuffer::new()),
        cycles: 0,
    };
    let (mut rng, mut id, mut missed, mut last) = (Pcg64::seed_from_u64(seed), 0, 0, None);
    while world.referee().goals() == 0 && world.now() < rules.limit {
        let (time_us, sensors) = (world.now().as_micros() as u64, world.sensors());
        let (rx, tx) = emulator.link().halves();
        let mut bytes = Vec::new();
        id += u32::from(sensors.image.is_some());
        let sensors = SensorsMessage::new(time_us, &sensors, id);
        for message in sensors.chunks().chain([sensors.message()]) {
            let mut packet = tx.encode(&message).expect("it fits");
            if rng.next_u32().is_multiple_of(DAMAGE) {
                damage(&mut packet, &mut rng);
            }
            bytes.extend(packet);
        }
        tx.write(&bytes).expect("the emulator runs");
        if let Some((time_us, command)) = model.receive(&bytes) {
            let sent = rx.receive(|message| match message {
                FromRobot::Command(sent) => Some((sent.time_us, decode_command(&sent))),
                _ => None,
            });
            let (of_us, sent) = sent.expect("a command");
            assert_eq!(of_us, time_us);
            let sent = sent.expect("valid");
            assert!(command_bits(&sent).eq(command_bits(&command)), "seed {seed}: they deviate at {time_us} µs");
            last = Some(sent);
        } else {
            missed += 1;
        }
        // A body without a new command keeps the last one.
        world.act(last.as_ref().expect("the first packets are intact"));
    }
    let (cycles, incomplete) = (model.cycles, model.image.incomplete());
    let report = model.runner.into_parts().3.finish("");
    assert_eq!((report.cycles, report.reason), (cycles, None));
    (cycles, missed, incomplete)
}

fn start(image: &Path, attacks: GoalColour) -> Emulator {
    let mut emulator = Emulator::start(image, Transport::Pipe, None).expect("an image");
    let identity = |message: FromRobot<'_>| matches!(message, FromRobot::Identity(_)).then_some(());
    emulator.link().receive(identity).expect("its identity");
    let mut set_up = [0; 8];
    let set_up = encode(&attacks, &mut set_up).expect("a byte");
    let hello = Hello { schema: SCHEMA, messages: MESSAGES, clock_mode: ClockMode::Lockstep, set_up };
    // The decoder of the model begins after this packet, so only the robot counts a missing first packet.
    emulator.link().send(&ToRobot::Hello(hello)).expect("the emulator runs");
    emulator.link().receive(identity).expect("its identity");
    emulator
}

/// Path of the firmware image: the file in `BICA_IMAGE`, or else that of this repository.
fn image() -> PathBuf {
    let built = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(FirmwareImage::DEFAULT);
    let image = env::var_os("BICA_IMAGE").map_or(built, PathBuf::from);
    assert!(image.exists(), "there is no {}: build it with `cargo xtask firmware --build`", image.display());
    image
}

#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_firmware_games_over_a_bad_link_replay() {
    let image = image();
    with_stack(|| {
        for seed in 0..5 {
            let file = Temporary::new(&format!("damaged-firmware-{}-{seed}.mcap", std::process::id()));
            let (cycles, missed, incomplete) = play(&image, &file, seed);
            println!("seed {seed}: {cycles} cycles, {missed} missed, {incomplete} images incomplete");
            assert!(cycles > 500 && missed > 5 && incomplete > 5, "the link was damaged");
            let replayed = replay_all(&file.0);
            assert!(replayed.equal, "seed {seed}: {replayed:?}");
            assert_eq!(replayed.cycles, cycles);
        }
    });
}
