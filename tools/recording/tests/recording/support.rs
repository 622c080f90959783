//! A small robot, its recordings in memory, and disks that fail.

use std::io::{self, Read, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use bica::prelude::*;
use bica::runner::{Request, Robot, Runner};
use bica::{Hold, Instant};
use bica_motion::joints::Joints;
use bica_motion::robot::{CameraId, Command, Image, Lights, Sensors};
use bica_recording::{
    Header, ImagePolicy, RecordedCycle, Recorder, RecorderOptions, Recording, RefereeEvent, Report, RobotInfo, Sink,
    Syncing,
};
use bica_wire::message::Sensors as SensorsMessage;

/// Counts its runs.
pub(crate) struct Counter {
    runs: u32,
}

#[component]
impl Counter {
    pub(crate) const fn new() -> Self {
        Self { runs: 0 }
    }

    /// Number of runs so far.
    #[info]
    fn runs(&self) -> u32 {
        self.runs
    }

    /// Part of the day, and its number.
    #[info(unit = "h")]
    fn day(&self) -> (Option<bool>, f32) {
        (Some(self.runs.is_multiple_of(2)), f32::NAN)
    }

    fn step(&mut self) {
        self.runs += 1;
    }
}

/// Alternates between two states.
pub(crate) struct Blinker;

#[component]
impl Blinker {
    pub(crate) const fn new() -> Self {
        Self
    }

    #[state(initial)]
    fn dark(&mut self) {}

    #[state]
    fn bright(&mut self, counter: &Counter) {
        let _ = counter.runs;
    }

    #[transition(dark -> bright, after_ms = 30)]
    fn on(&self) -> bool {
        true
    }

    #[transition(bright -> dark, after_ms = 50)]
    fn off(&self) -> bool {
        true
    }
}

activation_tree! {
    /// A lamp.
    pub(crate) struct Lamp { root: Blinker, cycle_hz: 100, components: [Blinker, Counter] }
}

impl Robot for Lamp {
    type Sensors<'a> = Sensors<'a>;
    type Command = Command;
    type Error = std::convert::Infallible;

    fn sense(&mut self, _sensors: &Sensors<'_>) -> Result<(), Self::Error> {
        Ok(())
    }

    fn act(&mut self) -> Command {
        let angle = self.get::<Counter>().runs as f32;
        let (targets, stiffness) = (Joints::all(angle), Joints::all(f32::NAN));
        Command { targets, stiffness, lights: Lights::default(), camera: CameraId::Bottom }
    }
}

/// Width and height of the images.
pub(crate) const SIZE: (u16, u16) = (16, 12);

/// Returns the pixels of an image.
pub(crate) fn pixels(cycle: u64) -> Vec<u8> {
    let count = 2 * u64::from(SIZE.0) * u64::from(SIZE.1);
    (0..count).map(|i| ((i * i + cycle * 31) % 251 / 3) as u8).collect()
}

/// Returns the sensor values of a cycle; every third one has an image.
pub(crate) fn sensors(cycle: u64, yuyv: &[u8]) -> Sensors<'_> {
    let message = SensorsMessage {
        time_us: 0,
        angles: [f32::from_bits(0x7fc0_1234 + cycle as u32); 25],
        temperatures: [f32::NAN; 25],
        currents: [-0.0; 25],
        inertial: [cycle as f32; 8],
        feet: [f32::INFINITY; 8],
        buttons: [cycle.is_multiple_of(2), false, true],
        image: None,
    };
    let image = Image { camera: CameraId::Top, width: SIZE.0, height: SIZE.1, yuyv };
    Sensors { image: cycle.is_multiple_of(3).then_some(image), ..message.to_sensors(None) }
}

/// A disk in memory that may be slow or full.
#[derive(Clone, Default)]
pub(crate) struct Disk {
    pub(crate) bytes: Arc<Mutex<Vec<u8>>>,
    /// Number of bytes that fit.
    pub(crate) capacity: Option<usize>,
    /// Time of each write.
    pub(crate) delay: Duration,
    pub(crate) sync: Arc<Held>,
}

/// Syncs that wait for a gate.
#[derive(Default)]
pub(crate) struct Held {
    pub(crate) begun: AtomicBool,
    pub(crate) gate: Mutex<()>,
}

impl Write for Disk {
    fn write(&mut self, data: &[u8]) -> io::Result<usize> {
        thread::sleep(self.delay);
        let mut bytes = self.bytes.lock().expect("no panic while writing");
        let room = self.capacity.map_or(usize::MAX, |capacity| capacity - bytes.len());
        if room == 0 {
            return Err(io::ErrorKind::StorageFull.into());
        }
        let count = data.len().min(room);
        bytes.extend(&data[..count]);
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Sink for Disk {
    fn truncate(&mut self, length: u64) -> io::Result<()> {
        self.bytes.lock().expect("no panic while writing").truncate(length as usize);
        Ok(())
    }

    fn syncing(&self) -> io::Result<Syncing> {
        let held = self.sync.clone();
        Ok(Box::new(move || {
            held.begun.store(true, Ordering::Relaxed);
            drop(held.gate.lock());
            Ok(())
        }))
    }
}

impl Disk {
    pub(crate) fn contents(&self) -> Vec<u8> {
        self.bytes.lock().expect("no panic while writing").clone()
    }
}

/// Returns the header of the recordings.
pub(crate) fn header(images: ImagePolicy) -> Header {
    let text = str::to_owned;
    let robot = RobotInfo { model: text("lamp"), profile: text("none"), attacks: text("nothing") };
    Header::new(&Lamp::GRAPH, robot, None, images).of_tree(&Lamp::new())
}

/// Runs the robot for a number of cycles; `None` as header: the disk has no room for it.
pub(crate) fn record(disk: &Disk, images: ImagePolicy, cycles: u64, options: RecorderOptions) -> Option<Report> {
    record_sharing(disk, images, cycles, options, |_| None)
}

/// As [`record`], with images that have an owner.
pub(crate) fn record_sharing(
    disk: &Disk,
    images: ImagePolicy,
    cycles: u64,
    options: RecorderOptions,
    owner: impl Fn(&[u8]) -> Option<Arc<Vec<u8>>> + Send + 'static,
) -> Option<Report> {
    let recorder = Recorder::start(disk.clone(), &header(images), options, |_| {}).ok()?.sharing_images(owner);
    let mut lamp = Lamp::new();
    let mut runner = Runner::new(&mut lamp, ()).with_observer(recorder);
    for cycle in 0..cycles {
        let now = Instant::from_millis(10 * cycle);
        if cycle == 7 {
            runner
                .request(now, Request::Hold { component: Lamp::id::<Counter>(), hold: Hold::Active })
                .expect("listed");
            runner.request(now, Request::Rate { component: Lamp::id::<Counter>(), hz: None }).expect("listed");
        }
        let yuyv = pixels(cycle);
        runner.sense(now, &sensors(cycle, &yuyv)).expect("never refused");
        runner.think(now);
        if cycle == 9 {
            runner.observer().event(RefereeEvent { at_ns: 90_000_000, kind: "goal".to_owned(), detail: String::new() });
        }
    }
    let (_, (), (), recorder) = runner.into_parts();
    Some(recorder.finish("lit"))
}

/// Options with chunks of few cycles.
pub(crate) fn small_chunks() -> RecorderOptions {
    RecorderOptions { chunk_bytes: 3000, ..RecorderOptions::default() }
}

/// Returns a recording with images.
pub(crate) fn recorded(cycles: u64) -> Vec<u8> {
    let disk = Disk::default();
    let report = record(&disk, ImagePolicy::All, cycles, small_chunks()).expect("there is room");
    assert_eq!((report.cycles, report.dropped_images, report.reason), (cycles, 0, None));
    disk.contents()
}

/// Returns the cycles of a recording up to its end or the first error.
pub(crate) fn cycles(source: impl Read) -> (Vec<RecordedCycle>, Option<String>) {
    let mut recording = Recording::new(source).expect("a header");
    let mut cycles = Vec::new();
    loop {
        match recording.next_cycle() {
            Ok(Some(cycle)) => cycles.push(cycle),
            Ok(None) => return (cycles, None),
            Err(error) => return (cycles, Some(error.to_string())),
        }
    }
}
