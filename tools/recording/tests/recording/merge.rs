//! Recordings of several robots in one file.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use bica_recording::{Error, Header, ImagePolicy, Info, Recorder, Robots, Start};
use bica_test_data::process::Folder;

use crate::cdr::{Cdr, messages};
use crate::support::{Disk, header, run, scenery, small_chunks};

/// Records a cart that starts at a second of the year, in a clock that begins at another time, ms.
fn record(folder: &Folder, name: &str, second: u32, clock: u64) -> PathBuf {
    let start = Start { time: format!("2026-01-01T00:00:{second:02}.500Z"), host: String::new() };
    let header = Header { start, scenery: vec![scenery("wall", "room")], ..header(ImagePolicy::All) };
    let disk = Disk::default();
    let recorder = Recorder::start(disk.clone(), &header, small_chunks(), |_| {}).expect("memory");
    assert_eq!(run(recorder, clock, 60).cycles, 60);
    let path = folder.path().join(name);
    fs::write(&path, disk.contents()).expect("room");
    path
}

/// 2026-01-01, ns since 1970.
const YEAR: u64 = 1_767_225_600_000_000_000;

#[test]
fn robots_have_their_own_topics_on_one_time() {
    let folder = Folder::new("merged");
    let paths = [record(&folder, "alice.mcap", 3, 0), record(&folder, "bob.mcap", 1, 70_000)];
    let mut file = Vec::new();
    let copied = Robots::open(&paths, None).and_then(|robots| robots.merge(&mut file)).expect("two robots");
    assert_eq!((copied.cycles, copied.bytes), (120, file.len() as u64));
    let merged = messages(&file);
    let common: Vec<_> =
        merged.keys().filter(|topic| !topic.starts_with("/alice/") && !topic.starts_with("/bob/")).collect();
    assert_eq!(common, ["/parameter_events", "/rosout"], "ROS has one topic of them for all nodes");
    for (path, name, start) in [(&paths[0], "alice", YEAR + 3_500_000_000), (&paths[1], "bob", YEAR + 1_500_000_000)] {
        let own = messages(&fs::read(path).expect("a file"));
        let is_own = |topic: &&String| !common.contains(topic);
        let counts =
            own.iter().filter(|(topic, _)| is_own(topic)).map(|(topic, all)| (format!("/{name}{topic}"), all.len()));
        let of_robot = merged.iter().filter(|(topic, _)| topic.starts_with(&format!("/{name}/")));
        let found: BTreeMap<_, _> = of_robot.map(|(topic, all)| (topic.clone(), all.len())).collect();
        assert_eq!(found, counts.collect(), "{name}");
        let frame = |topic: &str| Cdr::new(&merged[&format!("/{name}/{topic}")][0].1).header().1.to_owned();
        assert_eq!(frame("camera/image_raw/compressed"), format!("{name}/camera"), "its frame is its own");
        assert_eq!(frame("cart/scenery/wall/points"), "room", "the room is common");
        assert_eq!(merged[&format!("/{name}/cart/states")][0].0, start);
    }
    let times: Vec<u64> = merged.values().flatten().map(|(time, _)| *time).collect();
    let (first, last) = (times.iter().min().copied(), times.iter().max().copied());
    assert_eq!((first, last.is_some_and(|last| last <= YEAR + 4_100_000_000)), (Some(YEAR + 1_500_000_000), true));
    assert!(matches!(Info::read(&file[..]), Err(Error::NotARecording)), "it is for viewers");
}

#[test]
fn equal_names_and_a_single_recording_are_refused() {
    let folder = Folder::new("merged-refused");
    fs::create_dir(folder.path().join("other")).expect("room");
    let paths = [record(&folder, "alice.mcap", 0, 0), record(&folder, "other/alice.mcap", 0, 0)];
    let refused = |paths: &[PathBuf]| Robots::open(paths, None).expect_err("refused").to_string();
    let names = refused(&paths);
    assert!(names.contains("refused/alice.mcap") && names.contains("other/alice.mcap"), "{names}");
    assert!(refused(&paths[..1]).contains("nothing to merge"));
    assert!(refused(&[paths[0].clone(), paths[0].clone()]).contains("alice.mcap` is given twice"));
    let missing = [paths[0].clone(), folder.path().join("missing.mcap")];
    assert!(refused(&missing).contains("missing.mcap"));
    let whole = fs::read(&paths[0]).expect("a file");
    let cut = folder.path().join("cut.mcap");
    fs::write(&cut, &whole[..whole.len() / 2]).expect("room");
    let paths = [paths[0].clone(), cut];
    let failed = Robots::open(&paths, None).and_then(|robots| robots.merge(std::io::sink())).expect_err("cut");
    assert!(failed.what.contains("cut.mcap") && failed.help.contains("record recover"), "{failed}");
}
