//! A small robot, its recordings in memory, and disks that fail.

use std::io::{self, Read, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use bica::prelude::*;
use bica::runner::{Request, Robot, Runner};
use bica::{Hold, Instant, Setting};
use bica_recording::{
    Header, ImagePolicy, RecordedCycle, Recorder, RecorderOptions, Recording, Report, RunEvent, Scenery, SetUp, Sink,
    Syncing, Topics,
};
use serde_json::json;

/// Sensor values of the cart.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sensors<'a> {
    /// Speeds of the left and the right wheel, rad/s.
    pub(crate) speeds: [f32; 2],
    /// Distances to obstacles around the cart, m.
    pub(crate) ranges: [f32; 8],
    /// Whether the bumper is pressed.
    pub(crate) bumper: bool,
    /// Image of the camera.
    pub(crate) image: Option<Blob<'a>>,
    /// Points of the laser scanner.
    pub(crate) scan: Option<Blob<'a>>,
}

/// Command of the cart.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Command {
    /// Torques of the left and the right wheel, N m.
    pub(crate) torques: [f32; 2],
    /// The lamp.
    pub(crate) lamp: Lamp,
}

/// A lamp.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Lamp {
    /// It is dark.
    Dark,
    /// It shines.
    Bright {
        /// Brightness.
        share: f32,
    },
}

/// How strongly the cart drives.
#[derive(Params)]
pub(crate) struct Drive {
    /// Torque for each run.
    #[param(default = 1.0, range = 0.0..=2.0, unit = "N m")]
    gain: f32,
}

/// Counts its runs.
pub(crate) struct Counter {
    runs: u32,
    torque: f32,
    /// Distance ahead, m.
    distance: f32,
}

#[component]
impl Counter {
    pub(crate) const fn new() -> Self {
        Self { runs: 0, torque: 0.0, distance: 0.0 }
    }

    /// Number of runs so far.
    #[output]
    fn runs(&self) -> u32 {
        self.runs
    }

    /// Part of the day, and its number.
    #[output(unit = "h")]
    fn day(&self) -> (Option<bool>, f32) {
        (Some(self.runs.is_multiple_of(2)), f32::NAN)
    }

    fn step(&mut self, tuned: &Tuned<Drive>) {
        self.runs += 1;
        self.torque = tuned.gain * self.runs as f32 + self.distance;
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
    /// A cart with two wheels.
    pub(crate) struct Cart { root: Blinker, cycle_hz: 100, tunable, components: [Blinker, Counter] }
}

impl Robot for Cart {
    type Sensors<'a> = Sensors<'a>;
    type Command = Command;
    type Error = std::convert::Infallible;

    fn sense(&mut self, sensors: &Sensors<'_>) -> Result<(), Self::Error> {
        let scanned = sensors.scan.map_or(0, |scan| scan.bytes.iter().map(|byte| u32::from(*byte)).sum());
        self.get_mut::<Counter>().distance = sensors.speeds[0] + scanned as f32;
        Ok(())
    }

    fn act(&mut self) -> Command {
        let Counter { runs, torque, .. } = *self.get::<Counter>();
        let lamp = if runs.is_multiple_of(2) { Lamp::Dark } else { Lamp::Bright { share: f32::NAN } };
        Command { torques: [torque, runs as f32], lamp }
    }
}

/// Width and height of the images.
pub(crate) const SIZE: (u16, u16) = (16, 12);

/// Returns the pixels of an image.
pub(crate) fn pixels(cycle: u64) -> Vec<u8> {
    let count = 2 * u64::from(SIZE.0) * u64::from(SIZE.1);
    (0..count).map(|i| ((i * i + cycle * 31) % 251 / 3) as u8).collect()
}

/// Returns an image of these pixels.
pub(crate) fn image(yuyv: &[u8]) -> Blob<'_> {
    Blob { bytes: yuyv, format: Format::Yuyv { width: SIZE.0, height: SIZE.1 }, frame: "camera" }
}

/// Points of the laser scanner.
const SCAN: [u8; 120 * 12] = [3; 120 * 12];

/// Returns the sensor values of a cycle; every third one has an image, and every fourth one a scan.
pub(crate) fn sensors(cycle: u64, yuyv: &[u8]) -> Sensors<'_> {
    let scan = Blob { bytes: &SCAN[12 * (cycle as usize % 50)..], format: Format::Points, frame: "scanner" };
    Sensors {
        speeds: [cycle as f32, -0.0],
        ranges: [f32::from_bits(0x7fc0_1234 + cycle as u32); 8],
        bumper: cycle.is_multiple_of(2),
        image: cycle.is_multiple_of(3).then_some(image(yuyv)),
        scan: cycle.is_multiple_of(4).then_some(scan),
    }
}

/// A disk in memory that may be slow or full.
#[derive(Clone, Default)]
pub(crate) struct Disk {
    pub(crate) bytes: Arc<Mutex<Vec<u8>>>,
    /// Number of bytes that fit.
    pub(crate) capacity: Option<usize>,
    /// Whether a write panics if there is no room.
    pub(crate) panics: bool,
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
        assert!(room > 0 || !self.panics, "the disk is broken");
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
    let set_up = [("seed", 7.into()), ("world", "room".into())].map(|(name, value)| (name.to_owned(), value));
    Header::new(&Cart::GRAPH, SetUp::from(set_up), images).of_robot(&Cart::new())
}

/// Runs the robot for a number of cycles; `None` as header: the disk has no room for it.
pub(crate) fn record(disk: &Disk, images: ImagePolicy, cycles: u64, options: RecorderOptions) -> Option<Report> {
    record_sharing(disk, images, cycles, options, |_| None)
}

/// As [`record`], with topics.
pub(crate) fn record_topics(
    disk: &Disk,
    images: ImagePolicy,
    topics: Topics,
    cycles: u64,
    options: RecorderOptions,
) -> Option<Report> {
    let header = Header { topics, ..header(images) };
    Some(run(Recorder::start(disk.clone(), &header, options, |_| {}).ok()?, 0, cycles))
}

/// Returns a recording whose clock begins at a time, ms.
pub(crate) fn recorded_from(start: u64, cycles: u64) -> Vec<u8> {
    let disk = Disk::default();
    let recorder = Recorder::start(disk.clone(), &header(ImagePolicy::All), small_chunks(), |_| {}).expect("memory");
    assert_eq!(run(recorder, start, cycles).cycles, cycles);
    disk.contents()
}

/// As [`record`], with images that have an owner.
pub(crate) fn record_sharing(
    disk: &Disk,
    images: ImagePolicy,
    cycles: u64,
    options: RecorderOptions,
    owner: impl Fn(&[u8]) -> Option<Arc<Vec<u8>>> + Send + 'static,
) -> Option<Report> {
    let recorder = Recorder::start(disk.clone(), &header(images), options, |_| {}).ok()?.sharing_blobs(owner);
    Some(run(recorder, 0, cycles))
}

/// Runs the robot from a time on, ms, for a number of cycles, recorded.
pub(crate) fn run(recorder: Recorder, start: u64, cycles: u64) -> Report {
    run_with(recorder, start, cycles, &[])
}

/// As [`run`], with other parameters from cycle 7 on.
pub(crate) fn run_with(recorder: Recorder, start: u64, cycles: u64, settings: &[Setting]) -> Report {
    let mut cart = Cart::new();
    let mut runner = Runner::new(&mut cart, ()).with_observer(recorder);
    for cycle in 0..cycles {
        let now = Instant::from_millis(start + 10 * cycle);
        if cycle == 7 {
            runner
                .request(now, Request::Hold { component: Cart::id::<Counter>(), hold: Hold::Active })
                .expect("listed");
            runner.request(now, Request::Rate { component: Cart::id::<Counter>(), hz: None }).expect("listed");
            if !settings.is_empty() {
                runner.request(now, Request::Params(settings)).expect("in range");
            }
        }
        let yuyv = pixels(cycle);
        runner.sense(now, &sensors(cycle, &yuyv)).expect("never refused");
        runner.think(now);
        if cycle == 9 {
            let at_ns = 1_000_000 * start + 90_000_000;
            runner.observer().event(RunEvent { at_ns, kind: "goal".to_owned(), detail: String::new() });
        }
    }
    let (_, (), (), recorder) = runner.into_parts();
    recorder.finish("lit")
}

/// Returns a point that does not move.
pub(crate) fn scenery(name: &str, frame: &str) -> Scenery {
    Scenery {
        name: name.to_owned(),
        shape: "Point2".to_owned(),
        frame: frame.to_owned(),
        colour: None,
        line_width: None,
        value: json!({ "x": 1.0, "y": 2.0 }),
    }
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
