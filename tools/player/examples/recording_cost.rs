//! Cost of a recording: bytes per second, processor time of its thread, and time of the loop with and without it, in one run.
//!
//! `cargo run --profile dist -p bica-player-program --features measure --example recording_cost -- [FOLDER]`: images of
//! 640×480 at 30/s, in real time. The recorder shares the owner of the image, as in a game, or the loop copies the
//! image. With a folder of raw images `NAME_640x240.yuyv` (every second row) two of them make up one image; without it
//! the built-in world renders the images.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use bica::runner::Runner;
use bica::runner::STACK_BYTES;
use bica_field::GoalColour;
use bica_player_program::game::{Rules, WorldKind, recording_header};
use bica_recording::{ImagePolicy, Recorder, RecorderOptions};
use bica_sim::setup::Frame;
use clap::Parser;

mod turns;

use turns::{HEIGHT, Values, WIDTH, forward, shown};

/// Measures what a recording costs the loop
#[derive(Parser)]
#[command(name = "recording_cost")]
struct Args {
    /// Folder of raw images `NAME_640x240.yuyv`; without it the built-in world renders the images
    folder: Option<PathBuf>,
    /// Time of each of the three measurements, s
    #[arg(long, value_name = "S", default_value_t = 20)]
    seconds: u64,
}

fn main() {
    let args = Args::parse();
    let run = move || run(&args);
    thread::Builder::new().stack_size(STACK_BYTES).spawn(run).expect("a thread").join().expect("no panic");
}

fn run(args: &Args) {
    let mut values = Values::new(args.folder.as_deref().map(loaded));
    for (policy, sharing) in [(ImagePolicy::All, true), (ImagePolicy::All, false), (ImagePolicy::None, true)] {
        let path = std::env::temp_dir().join("recording-cost.mcap");
        measure(&mut values, policy, sharing, &path, args.seconds);
        let _ = fs::remove_file(path);
    }
}

fn loaded(folder: &Path) -> Vec<Arc<Vec<u8>>> {
    let files = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let files = files.filter_map(|entry| fs::read(entry.ok()?.path()).ok());
    let half: Vec<_> = files.filter(|half| half.len() == WIDTH * HEIGHT).collect();
    assert!(!half.is_empty(), "{} has no raw image of 640×240 px", folder.display());
    half.iter().zip(half.iter().cycle().skip(1)).map(|(upper, lower)| Arc::new([&upper[..], lower].concat())).collect()
}

fn measure(values: &mut Values, policy: ImagePolicy, sharing: bool, path: &Path, seconds: u64) {
    let rules = Rules {
        world: WorldKind::BuiltIn,
        seed: 0,
        size: Frame::Large,
        robots: 0,
        limit: Duration::MAX,
        realtime: true,
        firmware: None,
        settings: &[],
        options: &[],
    };
    let header = recording_header(&rules, GoalColour::Yellow, policy).of_robot(&*forward());
    let file = fs::File::create(path).expect("room");
    let warn = |reason: &str| eprintln!("the recording ended: {reason}");
    let recorder = Recorder::start(file, &header, RecorderOptions::default(), warn).expect("room");
    let owner = values.owner();
    let recorder = recorder.sharing_blobs(move |bytes: &[u8]| sharing.then(|| owner(bytes)).flatten());
    let mut with = Runner::new(forward(), ()).with_observer(recorder);
    let mut without = Runner::new(forward(), ());
    let began = Instant::now();
    let times = values.take_turns((&mut (), &mut with), &mut without, 0..100 * seconds, || began.elapsed());
    let processor = processor_seconds("recorder");
    let (_, (), (), recorder) = with.into_parts();
    let report = recorder.finish("");
    let megabytes = report.bytes as f64 * 1e-6 / seconds as f64;
    let images = if sharing { "shared" } else { "copied" };
    println!(
        "{policy:?}, images {images}: {megabytes:.3} MB/s, {} images dropped, {:?}",
        report.dropped_images, report.reason
    );
    let share = processor.map(|used| 100.0 * used / seconds as f64);
    println!(
        "  processor time of the recorder: {} % of a core",
        share.map_or("?".to_owned(), |share| format!("{share:.1}"))
    );
    println!("  loop without: {}\n  loop with:    {}", shown(&times[0]), shown(&times[1]));
}

/// Returns the processor time of a thread of this process, s; Linux only.
fn processor_seconds(name: &str) -> Option<f64> {
    let tasks = fs::read_dir("/proc/self/task").ok()?;
    let task = tasks
        .filter_map(|entry| Some(entry.ok()?.path()))
        .find(|task| fs::read_to_string(task.join("comm")).is_ok_and(|comm| comm.trim() == name))?;
    let times = fs::read_to_string(task.join("schedstat")).ok()?;
    times.split_whitespace().next()?.parse::<f64>().ok().map(|nanoseconds| nanoseconds * 1e-9)
}
