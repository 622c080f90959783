//! A cart, which is no humanoid and plays no soccer, runs again on its recordings.

use std::fs::{self, File};
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::process;

use bica::runner::World;
use bica::{Instant, Setting, Tree, Value};
use bica_recording::repair::trim;
use bica_recording::{
    Error, Header, ImagePolicy, Info, Program, Recorder, Recording, RepeatedWorld, ReplayOptions, ReplayReport,
    Subject, replay, rerun,
};

use crate::support::{Cart, Command, Counter, Disk, Sensors, header, pixels, record, recorded, sensors, small_chunks};

/// File that is removed at the end of a test.
pub(crate) struct Temporary(pub(crate) PathBuf);

impl Temporary {
    pub(crate) fn new(name: &str, content: &[u8]) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        fs::write(&path, content).expect("room");
        Self(path)
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

/// The room of the recordings, which runs again.
struct Room {
    cycle: u64,
    yuyv: Vec<u8>,
}

impl World<Cart> for Room {
    fn now(&self) -> Instant {
        Instant::from_millis(10 * self.cycle)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        self.yuyv = pixels(self.cycle);
        sensors(self.cycle, &self.yuyv)
    }

    fn act(&mut self, _command: &Command) {
        self.cycle += 1;
    }
}

impl RepeatedWorld<Cart> for Room {}

/// Returns the cart at its start with another gain, and the room.
pub(crate) fn subject(
    gain: Option<f32>,
) -> impl FnOnce(&Header, bool) -> Result<Subject<Cart>, bica_wire::model::Invalid> {
    move |header, runs_world| {
        assert_eq!(header.set_up["seed"], 7);
        let mut robot = Box::new(Cart::new());
        let setting = |gain| Setting::new(Cart::id::<Counter>(), 0, Value::F32(gain));
        gain.map_or(Ok(()), |gain| robot.set_params(&[setting(gain)])).expect("in range");
        let world = || -> Box<dyn RepeatedWorld<Cart>> { Box::new(Room { cycle: 0, yuyv: Vec::new() }) };
        Ok(Subject { robot, world: runs_world.then(world) })
    }
}

fn replayed(options: &ReplayOptions<'_>, gain: Option<f32>) -> ReplayReport {
    replay(options, subject(gain), |_| true).expect("a recording")
}

/// Records cycles without sensor values.
fn recorded_by_rules(cycles: u64) -> Vec<u8> {
    let disk = Disk::default();
    record(&disk, ImagePolicy::None, cycles, small_chunks()).expect("there is room");
    disk.contents()
}

#[test]
fn a_cart_replays_bit_for_bit() {
    for (source, content) in [("stored", recorded(60)), ("rules", recorded_by_rules(60))] {
        let file = Temporary::new(&format!("cart-{source}.mcap"), &content);
        let report = replayed(&ReplayOptions::whole(&file.0), None);
        assert!(report.equal, "{source}: {:?}", report.first_difference);
        assert_eq!((report.cycles, report.source, report.gaps.len()), (60, source, 0));
        let closed = replayed(&ReplayOptions { closed_loop: true, ..ReplayOptions::whole(&file.0) }, None);
        assert!(closed.equal && closed.source == "rules", "{:?}", closed.first_difference);
    }
}

#[test]
fn other_processors_are_named_if_both_are_known() {
    let here = Program::bica();
    let other = Program { processor: "x86_64 without FMA".to_owned(), ..here.clone() };
    assert_eq!(other.other_processor(&here), Some([other.processor.clone(), here.processor.clone()]));
    let unknown = Program { processor: String::new(), ..here.clone() };
    assert_eq!([here.other_processor(&here), unknown.other_processor(&here)], [None, None]);
    let mut header = header(ImagePolicy::All);
    assert_eq!((&header.program.processor, header.program.bica.is_empty()), (&here.processor, false));
    header.program.executable.push('0');
    assert!(!header.program.is_same_build(&Program::bica()), "equal commits may be different builds");
}

#[test]
fn first_difference_names_the_parameter_s_value() {
    let file = Temporary::new("cart-gain.mcap", &recorded(60));
    let report = replayed(&ReplayOptions::whole(&file.0), Some(0.5));
    assert_eq!(report.feedback, Some("open"));
    let first = report.first_difference.expect("another gain");
    // The cart counts from the cycle on in which its lamp shines.
    assert_eq!((first.field.as_str(), first.cycle > 0), ("command.torques[0]", true), "{first:?}");
}

#[test]
fn a_changed_byte_of_any_message_is_found() {
    let content = recorded(30);
    let file = Temporary::new("cart-flipped.mcap", &content);
    for at in (content.len() / 4..content.len() * 3 / 4).step_by(97) {
        let mut damaged = content.clone();
        damaged[at] ^= 1;
        fs::write(&file.0, &damaged).expect("room");
        let found = replay(&ReplayOptions::whole(&file.0), subject(None), |_| true);
        assert!(found.is_err() || found.is_ok_and(|report| report.damage.is_some() || !report.equal), "byte {at}");
    }
}

#[test]
fn a_cart_that_runs_again_is_recorded_as_before() {
    let (file, again) = (Temporary::new("cart-once.mcap", &recorded(60)), Temporary::new("cart-again.mcap", &[]));
    let report = rerun(&file.0, &again.0, subject(None), |_| true).expect("a recording");
    assert_eq!((report.cycles, report.reason), (60, None));
    let against = ReplayOptions { against: Some(&again.0), ..ReplayOptions::whole(&file.0) };
    let report = replay(&against, subject(None), |_| true).expect("two recordings");
    assert!(report.equal && report.cycles == 60, "{:?}", report.first_difference);
    let info = Info::read(&fs::read(&again.0).expect("written")[..]).expect("a recording");
    assert_eq!((info.events.len(), info.requests.len()), (1, 2));
}

#[test]
fn unwritable_new_course_is_an_error() {
    let file = Temporary::new("cart-long.mcap", &recorded(60));
    let out = file.0.with_file_name("cart-pipe.mcap");
    let _ = fs::remove_file(&out);
    assert!(process::Command::new("mkfifo").arg(&out).status().expect("a program").success());
    let out = Temporary(out);
    // A pipe holds the header. Then nobody reads it any more.
    let mut pipe = Some(File::options().read(true).write(true).open(&out.0).expect("a pipe"));
    let progress = |_| {
        pipe = None;
        true
    };
    let failed = rerun(&file.0, &out.0, subject(None), progress).expect_err("the cycles cannot be written");
    assert!(failed.what.contains("cart-pipe.mcap` ends after 0 cycles: cannot write: "), "{failed}");
}

#[test]
fn span_and_another_recording_are_compared() {
    let (one, two) =
        (Temporary::new("cart-short.mcap", &recorded(60)), Temporary::new("cart-longer.mcap", &recorded_by_rules(90)));
    let whole = ReplayOptions::whole(&one.0);
    assert_eq!(replayed(&ReplayOptions { from: 0.1, until: 0.2, ..whole }, None).cycles, 11);
    let against = ReplayOptions { against: Some(&two.0), ..whole };
    let report = replayed(&against, None);
    let first = report.first_difference.expect("one is longer");
    assert_eq!((report.cycles, first.cycle, first.field.as_str()), (60, 60, "cycle"));
    assert_eq!((first.recorded.as_str(), first.repeated.as_str()), ("the end", "a cycle"));
    assert!(replayed(&ReplayOptions { until: 0.5, ..against }, None).equal);
}

#[test]
fn cut_recording_is_compared_up_to_its_cut() {
    let bytes = recorded(60);
    let file = Temporary::new("cart-cut.mcap", &bytes[..2 * bytes.len() / 3]);
    let report = replayed(&ReplayOptions::whole(&file.0), None);
    assert!(report.equal && report.damage.expect("cut").contains("cut off"));
    assert!((10..60).contains(&report.cycles), "{}", report.cycles);
}

#[test]
fn span_without_cycles_or_beyond_the_end_is_refused() {
    let bytes = recorded(31);
    let file = Temporary::new("cart-no-cycles.mcap", &bytes);
    let whole = ReplayOptions::whole(&file.0);
    let header = Recording::new(&bytes[..]).expect("a header").position() as usize;
    let cut = Temporary::new("cart-header.mcap", &bytes[..header]);
    for (options, words) in [
        (ReplayOptions { from: 0.5, ..whole }, ["no cycle was compared", "0.30 s"]),
        (ReplayOptions { from: 0.101, until: 0.109, ..whole }, ["no cycle was compared", "none in the span"]),
        (ReplayOptions { until: 0.5, ..whole }, ["--until", "0.30 s"]),
        (ReplayOptions::whole(&cut.0), ["none before its damage", "cut off"]),
    ] {
        let refused = replay(&options, subject(None), |_| true).expect_err("no cycle is compared").what;
        assert!(words.iter().all(|word| refused.contains(word)), "{refused}");
    }
    assert_eq!(replayed(&ReplayOptions { until: 0.3, ..whole }, None).cycles, 31);
    let trimmed = |from, until| trim(Cursor::new(&bytes), std::io::sink(), from, until, None);
    for (from, until) in [(500_000_000, u64::MAX), (0, 500_000_000)] {
        assert!(matches!(trimmed(from, until), Err(Error::Span { end: 300_000_000 })), "{from} to {until}");
    }
}

#[test]
fn a_recording_of_other_sensor_values_is_refused() {
    let (disk, mut other) = (Disk::default(), header(ImagePolicy::All));
    let messages = other.tree.messages.as_mut().expect("a robot's header");
    messages.sensors = messages.command.clone();
    let recorder = Recorder::start(disk.clone(), &other, small_chunks(), |_| {}).expect("there is room");
    assert_eq!(recorder.finish("").reason, None);
    let file = Temporary::new("cart-other.mcap", &disk.contents());
    let refused = replay(&ReplayOptions::whole(&file.0), subject(None), |_| true).expect_err("other messages");
    assert!(refused.what.contains("sensor values or commands of another form"), "{refused}");
}
