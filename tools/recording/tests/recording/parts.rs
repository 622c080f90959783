//! Recordings that are split: each part is complete, and all of them are the recording.

use std::fs::{self, File};
use std::path::PathBuf;

use bica::{Setting, Tree, Value};
use bica_recording::{
    Backpressure, ImagePolicy, Info, Recorder, RecorderOptions, Recording, ReplayOptions, Report, RunPart, RunParts,
    Split, create, replay,
};
use bica_test_data::process::Folder;

use crate::replay::subject;
use crate::support::{Cart, Counter, cycles, header, recorded, run, run_with, small_chunks};

fn file(folder: &Folder, number: u32) -> PathBuf {
    RunPart::path(&folder.path().join("run.mcap"), number)
}

fn recorder(folder: &Folder, split: Split) -> Recorder {
    let path = folder.path().join("run.mcap");
    let file = move |number| create(&RunPart::path(&path, number), false);
    let options = RecorderOptions { backpressure: Backpressure::Wait, ..small_chunks() };
    Recorder::start_split(file, split, &header(ImagePolicy::All), options, |_| {}).expect("room")
}

/// Returns the paths of all parts.
fn parts(folder: &Folder, report: &Report) -> Vec<PathBuf> {
    (1..=report.parts.expect("split")).map(|number| file(folder, number)).collect()
}

const LIMITS: [(&str, Split); 2] = [("time", Split::Time(130_000_000)), ("size", Split::Size(20_000))];

#[test]
fn joined_parts_are_the_whole_recording() {
    let (whole, error) = cycles(&recorded(60)[..]);
    assert_eq!((whole.len(), error), (60, None));
    for (name, split) in LIMITS {
        let folder = Folder::new(&format!("joined-{name}"));
        let report = run(recorder(&folder, split), 0, 60);
        let parts = parts(&folder, &report);
        assert!(parts.len() > 2 && !file(&folder, parts.len() as u32 + 1).exists(), "{parts:?}");
        assert_eq!((report.cycles, report.reason, report.dropped_images), (60, None, 0));
        let length: u64 = parts.iter().map(|part| fs::metadata(part).expect("a file").len()).sum();
        assert_eq!(report.bytes, length);
        let out = folder.path().join("whole.mcap");
        let any_order: Vec<_> = parts.iter().rev().cloned().collect();
        let parts = RunParts::open(&any_order).expect("all parts");
        parts.join(File::create(&out).expect("room"), None).expect("intact parts");
        let (joined, error) = cycles(File::open(&out).expect("written"));
        assert_eq!((joined.len(), error), (60, None));
        for (joined, whole) in joined.iter().zip(&whole) {
            // Costs and lines about budgets depend on the clock; there are none here.
            assert_eq!(joined, whole, "{name}");
        }
        let report = replay(&ReplayOptions::whole(&out), subject(None), |_| true).expect("a recording");
        assert!(report.equal && report.cycles == 60, "{:?}", report.first_difference);
        let info = Info::read(File::open(&out).expect("written")).expect("a recording");
        assert_eq!((info.header.part, info.ending.expect("closed").result), (None, "lit".to_owned()));
    }
}

#[test]
fn part_is_complete_and_within_its_limit() {
    for (name, split) in LIMITS {
        let folder = Folder::new(&format!("complete-{name}"));
        let parts = parts(&folder, &run(recorder(&folder, split), 0, 60));
        let (mut next, mut run) = (0, None);
        for (path, number) in parts.iter().zip(1..) {
            let mut recording = Recording::open(path).expect("a recording");
            let part = recording.header().part.clone().expect("a part");
            assert_eq!((part.number, run.get_or_insert(part.run.clone())), (number, &mut part.run.clone()));
            let first = recording.next_cycle().expect("intact").expect("a cycle");
            assert_eq!((first.tick.cycle, first.tree.states.len()), (next, Cart::COUNT), "the state is there");
            assert_eq!(first.tree.digest(), first.tick.tree);
            let info = Info::read(File::open(path).expect("a file")).expect("a recording");
            assert_eq!((info.damage, info.ending.expect("closed").cycles), (None, info.cycles));
            match split {
                Split::Time(_) => assert!(info.cycles == 13 || number as usize == parts.len(), "{}", info.cycles),
                Split::Size(size) => assert!(info.bytes < size + 25_000, "{} bytes", info.bytes),
            }
            next += info.cycles;
        }
        assert_eq!(next, 60);
    }
}

#[test]
fn part_begins_with_the_parameters_in_force() {
    let folder = Folder::new("parameters");
    let request = [Setting::new(Cart::id::<Counter>(), 0, Value::F32(0.5))];
    let report = run_with(recorder(&folder, LIMITS[0].1), 0, 30, &request);
    let gain = |path: &PathBuf| {
        let header = Recording::open(path).expect("a recording").header().clone();
        header.assignments().next().expect("a parameter")
    };
    let gains: Vec<_> = parts(&folder, &report).iter().map(gain).collect();
    assert_eq!(gains, ["Counter.gain=1.0", "Counter.gain=0.5", "Counter.gain=0.5"]);
}

#[test]
fn part_without_its_start_names_the_first_part() {
    let folder = Folder::new("second");
    let parts = parts(&folder, &run(recorder(&folder, LIMITS[0].1), 0, 30));
    let replayed = |path| replay(&ReplayOptions::whole(path), subject(None), |_| true);
    assert!(replayed(&parts[0]).is_ok_and(|report| report.equal && report.cycles == 13));
    let refused = replayed(&parts[1]).expect_err("its start is in another file");
    assert!(refused.what.contains("run-002.mcap` is part 2 of a run"), "{refused}");
    assert!(refused.help.contains("run-001.mcap`, or join all parts with `record merge"), "{refused}");
}

#[test]
fn missing_doubled_and_foreign_parts_are_refused() {
    let (folder, other) = (Folder::new("refused"), Folder::new("refused-other"));
    let one = parts(&folder, &run(recorder(&folder, LIMITS[0].1), 0, 40));
    let two = parts(&other, &run(recorder(&other, LIMITS[0].1), 0, 40));
    let whole = folder.path().join("whole.mcap");
    fs::write(&whole, recorded(3)).expect("room");
    let refused = |parts: &[&PathBuf], words: &[&str]| {
        let parts: Vec<_> = parts.iter().copied().cloned().collect();
        let joined = RunParts::open(&parts).and_then(|parts| parts.join(std::io::sink(), None));
        let refused = joined.expect_err("refused").to_string();
        assert!(words.iter().all(|word| refused.contains(word)), "{refused}");
    };
    refused(&[], &["no part is given"]);
    refused(&[&one[0], &one[2]], &["part 2 of the run", "is missing"]);
    refused(&[&one[1], &one[2]], &["part 1 of the run", "is missing"]);
    refused(&[&one[0], &one[1], &one[1]], &["both part 2"]);
    refused(&[&one[0], &two[1]], &["refused/run-001.mcap", "refused-other/run-002.mcap", "two runs"]);
    refused(&[&one[0], &whole], &["whole.mcap` is not a part of a run"]);
}

#[test]
fn file_in_the_way_of_a_part_ends_the_recording() {
    let folder = Folder::new("in-the-way");
    fs::write(file(&folder, 2), "precious").expect("room");
    let report = run(recorder(&folder, LIMITS[0].1), 0, 40);
    let reason = report.reason.expect("part 2 exists");
    assert!(reason.contains("part 2: ") && reason.contains("exists"), "{reason}");
    assert_eq!((report.cycles, fs::read(file(&folder, 2)).expect("kept")), (13, b"precious".to_vec()));
    let (found, error) = cycles(File::open(file(&folder, 1)).expect("a part"));
    assert_eq!((found.len(), error), (13, None));
}

#[test]
fn limits_have_units_of_time_or_size() {
    let parsed = |text: &str| text.parse::<Split>();
    for (text, split) in [
        ("10min", Split::Time(600_000_000_000)),
        ("1.5s", Split::Time(1_500_000_000)),
        ("2 h", Split::Time(7_200_000_000_000)),
        ("2GB", Split::Size(2_000_000_000)),
        ("500mb", Split::Size(500_000_000)),
        ("1GiB", Split::Size(1 << 30)),
    ] {
        assert_eq!(parsed(text).expect(text), split);
    }
    for (text, words) in [
        ("10", "`10` has no unit"),
        ("10m", "`m` is no unit"),
        ("GB", "`GB` does not begin with a number"),
        ("1.2.3s", "does not begin with a number"),
        ("-5s", "`-5s` is no unit"),
        ("0.5s", "too short"),
        ("0.9MB", "too small"),
    ] {
        let refused = parsed(text).expect_err(text);
        assert!(refused.what.contains(words) && refused.help.contains("10min"), "{refused}");
    }
}
