//! Files of recordings in tests.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use bica::Tree;
use bica::runner::{RequestQueue, Runner, STACK_BYTES};
use bica_motion::model::simulation::NAO;
use bica_player::input::RobotProfile;
use bica_player::perception::GoalDetector;
use bica_player::tunable::Forward;
use bica_player_program::game::{
    RecordOptions, ReplayOptions, ReplayReport, Rules, WorldKind, play_recorded, recording_header, replay,
};
use bica_recording::mcap::{Compression, Item, Reader, Writer};
use bica_recording::{
    Backpressure, Channel, Error, ImagePolicy, Recorder, RecorderOptions, Topics, checksum, content, write_content,
};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};

/// File that is removed at the end of a test.
pub(crate) struct Temporary(pub(crate) PathBuf);

impl Temporary {
    pub(crate) fn new(name: &str) -> Self {
        Self(Path::new(env!("CARGO_TARGET_TMPDIR")).join(name))
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

/// Runs a function on a thread whose stack is large enough for the forward's tree.
pub(crate) fn with_stack<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    thread::scope(|scope| {
        let builder = thread::Builder::new().stack_size(STACK_BYTES);
        builder.spawn_scoped(scope, work).expect("a thread").join().expect("the test's own panic")
    })
}

/// Returns rules with small images.
pub(crate) fn rules(seed: u64, seconds: f32) -> Rules {
    Rules {
        world: WorldKind::BuiltIn,
        seed,
        size: Frame::Small,
        robots: 0,
        limit: Duration::from_secs_f32(seconds),
        realtime: false,
        firmware: None,
        settings: &[],
        options: &[],
    }
}

/// Plays and records a game.
pub(crate) fn record(path: &Path, rules: &Rules, images: ImagePolicy) {
    let options = RecordOptions { path, images, topics: Topics::None, split: None, force: true };
    let (summary, recording) = play_recorded(rules, &mut (), Some(options), None).expect("a game");
    let recording = recording.expect("requested");
    assert_eq!((recording.recorded_cycles, recording.dropped_images, recording.reason), (summary.cycles, 0, None));
}

/// Returns a forward in the built-in world that accepts requests and is recorded.
pub(crate) fn recorded(
    file: &Temporary,
    rules: &Rules,
    images: ImagePolicy,
) -> Runner<Box<Forward>, KinematicWorld, RequestQueue, Recorder> {
    let setup = Setup { seed: rules.seed, frame: rules.size, robots: rules.robots, ..Setup::default() };
    let mut world = KinematicWorld::new(NAO, &setup).expect("valid");
    let actions = World::actions(&mut world).list();
    let attacks = world.referee().attacks();
    let mut robot = Box::new(Forward::new());
    robot.get_mut::<RobotProfile>().set(rules.world.profile());
    robot.get_mut::<GoalDetector>().attack(attacks);
    let target = File::create(&file.0).expect("room");
    let options = RecorderOptions { backpressure: Backpressure::Wait, ..RecorderOptions::default() };
    let header = recording_header(rules, attacks, images).with_actions(actions).of_robot(&*robot);
    let recorder = Recorder::start(target, &header, options, |_| {}).expect("room");
    Runner::new(robot, world).with_requests(RequestQueue::new()).with_observer(recorder)
}

/// Replays a file from start to end.
pub(crate) fn replay_all(path: &Path) -> ReplayReport {
    replay(&ReplayOptions::whole(path)).expect("a recording")
}

/// Copies a recording, with changes of some messages and of the metadata.
pub(crate) fn rewrite(
    file: &[u8],
    mut message: impl FnMut(Channel, &mut Vec<u8>),
    mut header: impl FnMut(&mut String),
) -> Vec<u8> {
    let mut reader = Reader::new(file).expect("MCAP");
    let (mut schemas, mut channels, mut target) = (Vec::new(), Vec::new(), Vec::new());
    let mut writer = Writer::new(&mut target, "ros2").expect("memory");
    loop {
        match reader.next_item().expect("intact") {
            Item::Schema(schema) => schemas.push(schema),
            Item::Channel(channel) => channels.push(channel),
            Item::Metadata(_, name, mut fields) => {
                if name == "bica" {
                    fields.entry("json".to_owned()).and_modify(&mut header);
                    fields.insert("crc32".to_owned(), checksum(&fields["json"]));
                }
                writer.metadata(&name, &fields).expect("memory");
            }
            Item::Message(found) => {
                let channel = Channel::of_id(found.channel).expect("a channel of ours");
                let mut data = content(&found.data).expect("a message of ours").to_vec();
                message(channel, &mut data);
                let kind = if channel == Channel::Blobs { Compression::None } else { Compression::Lz4 };
                writer.message(kind, found.channel, found.time, |out| write_content(out, &data));
            }
            Item::Chunk { .. } if !schemas.is_empty() => {
                writer.declare(std::mem::take(&mut schemas), std::mem::take(&mut channels)).expect("memory");
            }
            Item::Chunk { .. } => writer.flush().expect("memory"),
            Item::End => break,
        }
    }
    writer.finish().map_err(Error::Io).expect("memory");
    target
}
