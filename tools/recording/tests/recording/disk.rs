//! Full and slow disks.

use std::fs;
use std::path::Path;
use std::sync::atomic::Ordering;
use std::thread;
use std::time::{Duration, Instant};

use bica::runner::Runner;
use bica::{Blob, Format};
use bica_recording::{Backpressure, ImagePolicy, Info, Recorder, RecorderOptions, Recording, create};

use crate::support::{Cart, Disk, Sensors, cycles, header, pixels, record, recorded, sensors, small_chunks};

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_full_disk_leaves_a_readable_file() {
    let whole = recorded(60).len();
    let mut lengths = Vec::new();
    for capacity in (0..whole).step_by(whole / 200) {
        let disk = Disk { capacity: Some(capacity), ..Disk::default() };
        let Some(report) = record(&disk, ImagePolicy::All, 60, small_chunks()) else {
            assert!(Recorder::start(disk, &header(ImagePolicy::All), small_chunks(), |_| {}).is_err());
            continue;
        };
        let file = disk.contents();
        assert!(report.reason.expect("the disk is full").contains("write"), "{capacity}");
        assert_eq!((report.bytes, file.len() <= capacity), (file.len() as u64, true), "{capacity}");
        let (found, error) = cycles(&file[..]);
        assert_eq!(found.len() as u64, report.cycles, "{capacity}");
        assert!(error.is_none_or(|error| error.contains("cut off")), "{capacity}");
        lengths.push(found.len());
    }
    // Not sorted: on a busy machine some chunks are written early, because time has passed, and take more room.
    let (first, middle, last) = (lengths[0], lengths[lengths.len() / 2], lengths[lengths.len() - 1]);
    assert!(lengths.len() > 50 && first == 0 && (10..50).contains(&middle) && last > 50, "{lengths:?}");
}

#[test]
fn full_disk_is_reported_at_once_and_in_the_file() {
    let (sender, receiver) = std::sync::mpsc::channel();
    let disk = Disk { capacity: Some(recorded(1).len() + 300), ..Disk::default() };
    let on_end = move |reason: &str| sender.send(reason.to_owned()).expect("somebody listens");
    let recorder = Recorder::start(disk.clone(), &header(ImagePolicy::All), small_chunks(), on_end).expect("room");
    drop(recorder);
    assert!(receiver.try_recv().is_err(), "an empty recording fits");
    let mut recording = Recording::new(&disk.contents()[..]).map(|mut recording| {
        let end = recording.next_cycle();
        (matches!(end, Ok(None)), recording.ending().cloned())
    });
    let (is_closed, ending) = recording.as_mut().expect("a recording");
    assert!(*is_closed && ending.as_ref().is_some_and(|ending| ending.reason.is_empty()));
}

#[test]
fn a_slow_disk_loses_images_and_no_values() {
    let disk = Disk { delay: Duration::from_millis(20), ..Disk::default() };
    let options = RecorderOptions { images: 2, ..small_chunks() };
    let report = record(&disk, ImagePolicy::All, 300, options).expect("there is room");
    assert_eq!((report.cycles, &report.reason), (300, &None));
    let (found, error) = cycles(&disk.contents()[..]);
    assert_eq!((found.len(), error), (300, None));
    assert!(found.iter().all(|cycle| cycle.sensors.is_some() && cycle.command.is_some()));
    assert_eq!(found.iter().filter(|cycle| cycle.is_gap()).count() as u64, report.dropped_images);
    assert!((1..150).contains(&report.dropped_images), "{}", report.dropped_images);
    let has_blobs = |cycle: u64| cycle.is_multiple_of(3) || cycle.is_multiple_of(4);
    assert!(found.iter().all(|cycle| (cycle.tick.blobs != 0) == has_blobs(cycle.tick.cycle)));
}

#[test]
fn a_queue_without_room_for_values_ends_the_recording() {
    let disk = Disk { delay: Duration::from_millis(100), ..Disk::default() };
    let options = RecorderOptions { cycles: 20, ..small_chunks() };
    let report = record(&disk, ImagePolicy::All, 2000, options).expect("there is room");
    assert!(report.reason.expect("too slow").contains("too slow"));
    let (found, error) = cycles(&disk.contents()[..]);
    assert_eq!((found.len() as u64, error), (report.cycles, None));
    assert!((1..2000).contains(&report.cycles), "{}", report.cycles);
    assert!(
        found.iter().zip(0..).all(|(cycle, number)| cycle.tick.cycle == number),
        "no cycle is missing before the end"
    );
}

#[test]
fn simulation_waits_for_a_slow_disk() {
    let disk = Disk { delay: Duration::from_millis(2), ..Disk::default() };
    let backpressure = Backpressure::Wait;
    let options = RecorderOptions { cycles: 10, images: 2, backpressure, ..small_chunks() };
    let report = record(&disk, ImagePolicy::All, 300, options).expect("there is room");
    assert_eq!((report.cycles, report.dropped_images, report.reason), (300, 0, None));
    let (found, _) = cycles(&disk.contents()[..]);
    assert_eq!(found.iter().filter(|cycle| !cycle.blobs.is_empty()).count(), 150);
}

#[test]
fn long_sync_delays_no_write() {
    // The queue has room for their images and scans.
    const STEP: u64 = 45;
    let (disk, mut cart, mut count) = (Disk::default(), Cart::new(), 0);
    let recorder = Recorder::start(disk.clone(), &header(ImagePolicy::All), small_chunks(), |_| {}).expect("memory");
    let mut runner = Runner::new(&mut cart, ()).with_observer(recorder);
    // Declared last, so that a panic opens it first.
    let gate = disk.sync.gate.lock().expect("no panic while syncing");
    // Ten seconds of cycles after the sync has begun that waits for the gate.
    let mut until = u64::MAX;
    while count < until {
        for cycle in count..count + STEP {
            let (now, yuyv) = (bica::Instant::from_millis(10 * cycle), pixels(cycle));
            runner.sense(now, &sensors(cycle, &yuyv)).expect("never refused");
            runner.think(now);
        }
        count += STEP;
        let (began, mut length, mut written) = (Instant::now(), usize::MAX, 0);
        while written != count {
            assert!(began.elapsed() < Duration::from_secs(20), "{written} of {count} cycles are written");
            thread::sleep(Duration::from_millis(50));
            let contents = disk.contents();
            // While the file grows it is not read: each reading decompresses all of it.
            if contents.len() == length {
                written = Info::read(&contents[..]).expect("a header").cycles;
            }
            length = contents.len();
        }
        if disk.sync.begun.load(Ordering::Relaxed) {
            until = until.min(count + 1000);
        }
    }
    drop(gate);
    let report = runner.into_parts().3.finish("");
    assert_eq!((report.cycles, report.dropped_images, report.reason), (count, 0, None));
}

#[test]
fn no_small_image_is_lost_in_a_large_chunk() {
    let (disk, options) = (Disk::default(), RecorderOptions { images: 1000, ..RecorderOptions::default() });
    let report = record(&disk, ImagePolicy::All, 400, options).expect("there is room");
    assert_eq!((report.cycles, report.dropped_images, report.reason), (400, 0, None));
    let (found, error) = cycles(&disk.contents()[..]);
    assert_eq!((found.iter().find(|cycle| cycle.is_gap()).map(|cycle| cycle.tick.cycle), error), (None, None));
}

/// Records five cycles with images of a size, and one with an image and a scan of other sizes; returns the report's reason, and the number
/// of cycles of the file with their large data.
fn record_large(image: usize, scan: usize) -> (Option<String>, usize, Option<String>) {
    let (disk, mut cart) = (Disk::default(), Cart::new());
    let options = RecorderOptions { backpressure: Backpressure::Wait, ..RecorderOptions::default() };
    let recorder = Recorder::start(disk.clone(), &header(ImagePolicy::All), options, |_| {}).expect("memory");
    let mut runner = Runner::new(&mut cart, ()).with_observer(recorder);
    for cycle in 0..6 {
        let [image, scan] = if cycle < 5 { [1000; 2] } else { [image, scan] }.map(|size| vec![0; size]);
        let blob = |bytes, format, frame| Some(Blob { bytes, format, frame });
        let image = blob(&image, Format::Jpeg, "camera");
        let sensors = Sensors { image, scan: blob(&scan, Format::Points, "scanner"), ..sensors(cycle, &[]) };
        let now = bica::Instant::from_millis(10 * cycle);
        runner.sense(now, &sensors).expect("never refused");
        runner.think(now);
    }
    let report = runner.into_parts().3.finish("");
    let (found, error) = cycles(&disk.contents()[..]);
    assert_eq!(found.len() as u64, report.cycles);
    (report.reason, found.iter().filter(|cycle| cycle.blobs.len() == 2).count(), error)
}

#[test]
fn a_cycle_that_no_reader_takes_ends_the_recording() {
    const MIB: usize = 1 << 20;
    // Their topics are further chunks.
    assert_eq!(record_large(31 * MIB, 31 * MIB), (None, 6, None));
    for (image, scan) in [(65 * MIB, 12), (12, 64 * MIB), (33 * MIB, 33 * MIB)] {
        let (reason, cycles, error) = record_large(image, scan);
        assert_eq!((cycles, error), (5, None), "{image} {scan}");
        let reason = reason.expect("it is too large");
        assert!(reason.contains("cycle 5 has ") && reason.contains("at most 67108864 bytes"), "{reason}");
    }
}

#[test]
fn a_recorder_that_panics_does_not_stop_the_loop() {
    let disk = Disk { capacity: Some(recorded(1).len() + 300), panics: true, ..Disk::default() };
    let options = RecorderOptions { cycles: 10, images: 2, backpressure: Backpressure::Wait, ..small_chunks() };
    let (sender, ended) = std::sync::mpsc::channel();
    let on_end = move |reason: &str| sender.send(reason.to_owned()).expect("somebody listens");
    let recorder = Recorder::start(disk, &header(ImagePolicy::All), options, on_end).expect("there is room");
    let mut cart = Cart::new();
    let mut runner = Runner::new(&mut cart, ()).with_observer(recorder);
    for cycle in 0..300 {
        let (now, yuyv) = (bica::Instant::from_millis(10 * cycle), pixels(cycle));
        runner.sense(now, &sensors(cycle, &yuyv)).expect("never refused");
        runner.think(now);
    }
    assert_eq!(ended.recv().as_deref(), Ok("the thread of the recorder failed"));
    assert_eq!(runner.into_parts().3.finish("").reason.as_deref(), Some("the thread of the recorder failed"));
}

#[test]
fn file_that_is_being_recorded_is_not_replaced() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("locked.mcap");
    let writer = create(&path, true).expect("room");
    let error = create(&path, true).expect_err("locked");
    assert!(error.to_string().contains("another program"), "{error}");
    drop(writer);
    create(&path, true).expect("free");
    fs::remove_file(path).expect("a file");
}
