//! The recording of a robot by a monitor, compared with the recording by the robot's own program.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use bica::prelude::*;
use bica::runner::{Request, Runner};
use bica::{Hold, Setting, Value};
use bica_link::{Client, ClientOptions, LinkServer, ServerOptions};
use bica_monitor::protocol::Open;
use bica_recording::{
    Header, ImagePolicy, LogLine, LogSource, OutputRecord, RecordedCycle, Recorder, RecorderOptions, Recording,
    RunEvent, SetUp, create,
};

use crate::lamp::{CYCLE_US, LampTree, Room};
use crate::page::{Bench, Folder, LONG};

/// Longer than any test, in the robot's time.
const FOREVER: Duration = Duration::from_secs(1_000_000);
/// Index of the lamp, and of the camera that looks at it.
const LAMP: ComponentId = ComponentId::new(0);
const EYE: ComponentId = ComponentId::new(1);

/// Runs the lamp with its own recorder, and a monitor and an operator behind a link. Returns both recordings.
fn run(folder: &Path) -> [PathBuf; 2] {
    let files = ["own.mcap", "monitor.mcap"].map(|name| folder.join(name));
    let address = "127.0.0.1:0".parse().unwrap();
    let options = ServerOptions { silence: FOREVER, ..ServerOptions::default() };
    let (server, requests, link) = LinkServer::start::<LampTree>(&address, options).unwrap();
    let address = server.address().to_owned();
    let header = Header::new(&LampTree::GRAPH, SetUp::new(), ImagePolicy::All).of_robot(&LampTree::new());
    let options = RecorderOptions { outputs_every: 1, ..RecorderOptions::default() };
    let recorder = Recorder::start(create(&files[0], false).unwrap(), &header, options, |_| {}).unwrap();
    let (ends, scores) = (AtomicBool::new(false), AtomicBool::new(false));
    thread::scope(|scope| {
        scope.spawn(|| {
            let runner = Runner::new(Box::new(LampTree::new()), Room::at(0)).with_requests(requests);
            let mut runner = runner.with_observer((link, recorder));
            while !ends.load(Ordering::Relaxed) {
                let at_ns = 1000 * runner.now().as_micros();
                runner.cycle().unwrap();
                if scores.swap(false, Ordering::Relaxed) {
                    server.event("goal", "own, by a lamp");
                    let (kind, detail) = ("goal".to_owned(), "own, by a lamp".to_owned());
                    runner.observer().1.event(RunEvent { at_ns, kind, detail });
                }
                thread::sleep(Duration::from_millis(1));
            }
            drop(server);
            let _ = runner.into_parts().3.1.finish("");
        });
        let bench = Bench::new();
        bench.manager.open_recorded(Open::Robot { address: address.clone() }, &files[1]).unwrap();
        let until = Instant::now() + LONG;
        while fs::metadata(&files[1]).map_or(0, |file| file.len()) == 0 {
            assert!(Instant::now() < until, "the monitor records nothing");
            thread::sleep(Duration::from_millis(10));
        }
        operate(&address);
        scores.store(true, Ordering::Relaxed);
        thread::sleep(Duration::from_millis(300));
        drop(bench);
        ends.store(true, Ordering::Relaxed);
    });
    files
}

/// Tunes the lamp, sets rate and hold of the camera, and releases control.
fn operate(address: &str) {
    // The robot's time is faster than the clock from which a client computes the expiry of a request.
    let options = ClientOptions { timeout: LONG, expiry: FOREVER };
    let mut operator = Client::connect(&address.parse().unwrap(), options).unwrap();
    operator.acquire(false).unwrap();
    let level = |level| [Setting::new(LAMP, 0, Value::F32(level))];
    for request in [
        Request::Params(&level(0.25)),
        Request::Rate { component: EYE, hz: Some(100.0) },
        Request::Hold { component: EYE, hold: Hold::Active },
    ] {
        operator.request(request).unwrap();
        thread::sleep(Duration::from_millis(50));
    }
    operator.request(Request::Params(&level(2.0))).unwrap_err();
    operator.release().unwrap();
}

/// Returns all cycles by their numbers.
fn read(file: &Path) -> (Header, BTreeMap<u64, RecordedCycle>) {
    let mut recording = Recording::open(file).unwrap();
    let mut cycles = BTreeMap::new();
    while let Some(cycle) = recording.next_cycle().unwrap() {
        cycles.insert(cycle.tick.cycle, cycle);
    }
    (recording.header().clone(), cycles)
}

#[test]
fn kept_recording_equals_that_of_the_robot() {
    let folder = Folder::new("kept");
    let [(_, own), (header, kept)] = run(folder.path()).map(|file| read(&file));
    assert_eq!(header.monitor.as_ref().unwrap().lacks, ["sensors", "command", "costs"]);
    let mut values = 0;
    for (number, cycle) in &kept {
        let own = &own[number];
        // Outputs of a cycle that the link omitted are in the next cycle.
        let is_complete = number.checked_sub(1).is_some_and(|before| kept.contains_key(&before));
        assert_eq!((&cycle.tree, cycle.tick.instant), (&own.tree, number * CYCLE_US), "{number}");
        for value in cycle.outputs.iter().flat_map(|record| &record.values).filter(|_| is_complete) {
            let is_same = |own: &&OutputRecord| (own.component, own.index) == (value.component, value.index);
            // The program itself records outputs of active components only.
            if let Some(own) = own.outputs.as_ref().unwrap().values.iter().find(is_same) {
                assert_eq!(value, own, "{number}");
                values += 1;
            }
        }
    }
    assert!(values > 10, "{values} values of {} cycles", kept.len());
    let requests = |cycles: &BTreeMap<u64, RecordedCycle>| -> Vec<_> {
        cycles.iter().flat_map(|(number, cycle)| cycle.requests.iter().map(|one| (*number, one.clone()))).collect()
    };
    let (sent, applied) = (requests(&kept), requests(&own));
    let changes =
        |requests: &[(u64, _)]| requests.iter().map(|(_, request)| format!("{request:?}")).collect::<Vec<_>>();
    assert_eq!(changes(&sent), changes(&applied));
    assert_eq!(applied.len(), 5, "three of the operator, two as its lease ends: {applied:?}");
    for ((kept_in, _), (number, request)) in sent.iter().zip(&applied) {
        // Requests of a cycle that the link omitted are in the next cycle.
        assert!(kept_in == number || (kept_in > number && !kept.contains_key(number)), "{request:?}");
    }
    let held = kept.values().filter_map(|cycle| cycle.holds.as_ref().map(|holds| holds.holds[1]));
    assert_eq!(held.collect::<Vec<_>>(), [Hold::Tree, Hold::Tree, Hold::Active, Hold::Tree], "at each change");
    let events = |cycles: &BTreeMap<u64, RecordedCycle>| -> Vec<RunEvent> {
        cycles.values().flat_map(|cycle| cycle.events.clone()).collect()
    };
    assert_eq!(events(&kept), events(&own));
    assert_eq!(events(&kept).len(), 1);
    let is_refusal = |line: &&LogLine| line.source == LogSource::Operator && line.text.contains("refused");
    assert_eq!(kept.values().flat_map(|cycle| cycle.log.iter().filter(is_refusal)).count(), 1);
}
