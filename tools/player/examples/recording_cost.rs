//! Cost of a recording: bytes per second, processor time of its thread, and time of the loop with and without it in one run.
//!
//! `cargo run --release -p bica-player-program --example recording_cost -- [FOLDER] [SECONDS]`: images of 640×480 at 30/s,
//! in real time, whose owner is shared with the recorder, as in a game, or which the loop copies. With a
//! folder of raw images `NAME_640x240.yuyv` (every second row) two of these make up an image, else the built-in world renders
//! them.

use std::fs;
use std::path::Path;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant as Clock};

use bica::runner::Runner;
use bica::{Instant, Tree};
use bica_app::STACK_BYTES;
use bica_evaluation::statistics::percentile;
use bica_field::GoalColour;
use bica_motion::robot::{Image, Sensors};
use bica_player::Model;
use bica_player::input::RobotProfile;
use bica_player::tunable::Forward;
use bica_player_program::game::{Rules, WorldKind, recording_header};
use bica_recording::{ImagePolicy, Recorder, RecorderOptions};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};

const WIDTH: usize = 640;
const HEIGHT: usize = 480;
/// Number of images that are repeated.
const IMAGES: usize = 30;

fn main() {
    thread::Builder::new().stack_size(STACK_BYTES).spawn(run).expect("a thread").join().expect("no panic");
}

fn run() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let folder = arguments.first().filter(|folder| Path::new(folder).is_dir());
    let seconds = arguments.last().and_then(|text| text.parse().ok()).unwrap_or(20_u64);
    let setup = Setup { frame: Frame::Large, ..Setup::default() };
    let mut world = KinematicWorld::<Model>::new(&setup).expect("valid");
    let images = folder.map_or_else(|| rendered(&mut world), |folder| loaded(Path::new(folder)));
    for (policy, sharing) in [(ImagePolicy::All, true), (ImagePolicy::All, false), (ImagePolicy::None, true)] {
        let path = std::env::temp_dir().join("recording-cost.mcap");
        measure(&mut world, &images, policy, sharing, &path, seconds);
        let _ = fs::remove_file(path);
    }
}

fn rendered(world: &mut KinematicWorld<Model>) -> Vec<Arc<Vec<u8>>> {
    let mut images = Vec::new();
    let mut robot = forward();
    while images.len() < IMAGES {
        images.extend(world.sensors().image.map(|image| Arc::new(image.yuyv.to_vec())));
        let now = Instant::from_micros(World::now(world).as_micros() as u64);
        bica::runner::Robot::sense(&mut *robot, &world.sensors()).expect("the image fits");
        robot.tick(now);
        let command = bica::runner::Robot::act(&mut *robot);
        world.act(&command);
    }
    images
}

fn loaded(folder: &Path) -> Vec<Arc<Vec<u8>>> {
    let files = fs::read_dir(folder).expect("a folder").filter_map(|entry| fs::read(entry.ok()?.path()).ok());
    let half: Vec<_> = files.filter(|half| half.len() == WIDTH * HEIGHT).collect();
    half.iter().zip(half.iter().cycle().skip(1)).map(|(upper, lower)| Arc::new([&upper[..], lower].concat())).collect()
}

fn forward() -> Box<Forward> {
    let mut robot = Box::new(Forward::new());
    robot.get_mut::<RobotProfile>().set(WorldKind::BuiltIn.profile());
    robot
}

fn measure(
    world: &mut KinematicWorld<Model>,
    images: &[Arc<Vec<u8>>],
    policy: ImagePolicy,
    sharing: bool,
    path: &Path,
    seconds: u64,
) {
    let rules = Rules {
        world: WorldKind::BuiltIn,
        seed: 0,
        size: Frame::Large,
        robots: 0,
        limit: Duration::MAX,
        realtime: true,
        firmware: None,
        settings: &[],
    };
    let header = recording_header(&rules, GoalColour::Yellow, policy).of_robot(&*forward());
    let file = fs::File::create(path).expect("room");
    let warn = |reason: &str| eprintln!("the recording ended: {reason}");
    let recorder = Recorder::start(file, &header, RecorderOptions::default(), warn).expect("room");
    let (newest, shared) = (Arc::new(Mutex::new(Arc::clone(&images[0]))), sharing);
    let in_recorder = Arc::clone(&newest);
    let owner = move |_: &[u8]| shared.then(|| Arc::clone(&in_recorder.lock().expect("no panic")));
    let recorder = recorder.sharing_blobs(owner);
    let mut with = Runner::new(forward(), ()).with_observer(recorder);
    let mut without = Runner::new(forward(), ());
    let (mut times, began) = ([Vec::new(), Vec::new()], Clock::now());
    for cycle in 0..100 * seconds {
        thread::sleep(Duration::from_millis(10 * cycle).saturating_sub(began.elapsed()));
        let has_image = cycle == 0 || cycle * 3 / 10 != (cycle - 1) * 3 / 10;
        let yuyv = &images[(cycle * 3 / 10) as usize % images.len()];
        newest.lock().expect("no panic").clone_from(yuyv);
        let sensors = world.sensors();
        let camera = bica_motion::robot::CameraId::Top;
        let image = Image { camera, width: WIDTH as u16, height: HEIGHT as u16, yuyv };
        let sensors = Sensors { image: has_image.then_some(image), ..sensors };
        let now = Instant::from_millis(10 * cycle);
        // The one that comes second finds the image in the cache.
        for index in [cycle % 2, 1 - cycle % 2] {
            let start = Clock::now();
            if index == 0 {
                without.sense(now, &sensors).expect("the image fits");
                without.think(now);
            } else {
                with.sense(now, &sensors).expect("the image fits");
                with.think(now);
            }
            times[index as usize].push(start.elapsed().as_secs_f64() * 1e3);
        }
    }
    let processor = processor_seconds("recorder");
    let (_, (), (), recorder) = with.into_parts();
    let report = recorder.finish("");
    let [without, with] = times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        [0.5, 0.99, 1.0].map(|part| percentile(&times, part).unwrap_or(0.0))
    });
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
    println!("  loop without: median {:.3}, p99 {:.3}, max {:.3} ms", without[0], without[1], without[2]);
    println!("  loop with:    median {:.3}, p99 {:.3}, max {:.3} ms", with[0], with[1], with[2]);
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
