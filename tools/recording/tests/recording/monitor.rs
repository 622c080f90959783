//! Recordings that a monitor makes.

use std::io::Cursor;

use std::io::Read;

use bica::runner::OwnedRequest;
use bica::{ComponentId, Hold};
use bica_link::{Component, Description, Output, State};
use bica_recording::repair::{recover, trim};
use bica_recording::{
    Error, Header, HoldsRecord, Info, LogLine, LogSource, MonitorRecorder, OutputRecord, OutputsRecord, RecordedCycle,
    Recording, Report, RequestRecord, RunEvent, Tick, TreeRecord,
};
use bica_wire::message::Offers;
use postcard_schema::Schema;
use serde::Serialize;

use crate::support::{self, Disk, SIZE, pixels};

/// The component `Counter`.
const COUNTER: ComponentId = ComponentId::new(1);

/// Period of a cycle, µs.
const PERIOD_US: u64 = 10_000;

/// Value of an output.
#[derive(Serialize, Schema)]
struct Seen {
    number: u64,
    at: (f32, f32),
}

/// A tree of two components, one of them with states and an output.
fn description() -> Description {
    let text = str::to_owned;
    let state = |name: &str, initial| State {
        name: text(name),
        doc: String::new(),
        initial,
        last: false,
        end: None,
        before: None,
    };
    let output = Output {
        name: text("seen"),
        doc: String::new(),
        unit: Some(text("m")),
        type_name: text("Seen"),
        placement: None,
        schema: Some(Seen::SCHEMA.into()),
    };
    let states = vec![state("dark", true), state("bright", false)];
    let blinker = Component { name: text("Blinker"), states, outputs: vec![output], ..Component::default() };
    let counter = Component { name: text("Counter"), ..Component::default() };
    let components = vec![blinker, counter];
    Description { name: text("Lamp"), hash: text("0123"), cycle_hz: 100.0, components, ..Description::default() }
}

fn header() -> Header {
    Header::of_monitor("tcp://lamp:7400", &description(), Offers::OPERATE)
}

/// A cycle with everything that depends on its number.
fn cycle(number: u64) -> RecordedCycle {
    let instant = PERIOD_US * number;
    let tick = Tick { cycle: number, instant, ..Tick::default() };
    let tree =
        TreeRecord { active: vec![1 + 2 * u8::from(number >= 20)], states: vec![u8::from(number >= 10), u8::MAX] };
    let holds = HoldsRecord {
        holds: vec![Hold::Tree, if number >= 15 { Hold::Latent } else { Hold::Active }],
        rates: vec![None, Some(25.0)],
    };
    let value = postcard::to_stdvec(&Seen { number, at: (0.5, f32::NAN) }).expect("memory");
    let value = OutputRecord { component: 0, index: 0, value };
    let mut cycle = RecordedCycle { tick, tree, ..RecordedCycle::default() };
    cycle.holds = [0, 15].contains(&number).then_some(holds);
    cycle.outputs = number.is_multiple_of(10).then(|| OutputsRecord { values: vec![value] });
    match number {
        3 => cycle.requests.push(RequestRecord::Tree(OwnedRequest::Hold { component: COUNTER, hold: Hold::Latent })),
        4 => cycle.log.push(LogLine { level: 3, source: LogSource::Monitor, text: "hot".to_owned() }),
        5 => cycle.events.push(RunEvent { at_ns: 50_000_000, kind: "goal".to_owned(), detail: "own".to_owned() }),
        _ => {}
    }
    cycle
}

/// Records cycles; every third one has an image, that comes some cycles late.
fn record(disk: &Disk, cycles: u64, late: u64) -> std::io::Result<Report> {
    let mut recorder = MonitorRecorder::new(disk.clone(), &header())?;
    let mut write = || -> std::io::Result<()> {
        for number in 0..cycles {
            recorder.cycle(&cycle(number))?;
            if let Some(of) = number.checked_sub(late).filter(|of| of.is_multiple_of(3)) {
                recorder.image(of as u32 / 3, PERIOD_US * of, &support::image(&pixels(of)))?;
            }
        }
        Ok(())
    };
    let reason = write().err().map(|error| format!("cannot write: {error}"));
    Ok(recorder.finish(reason, 0))
}

fn recorded(cycles: u64, late: u64) -> Vec<u8> {
    let disk = Disk::default();
    let report = record(&disk, cycles, late).expect("memory");
    assert_eq!((report.cycles, report.reason), (cycles, None));
    disk.contents()
}

/// All cycles, with the number and the time (µs) of their images.
fn read(source: impl Read) -> Vec<(RecordedCycle, Option<(u32, u64)>)> {
    let mut recording = Recording::new(source).expect("a recording");
    let mut cycles = Vec::new();
    while let Some(cycle) = recording.next_cycle().expect("intact") {
        cycles.push((cycle, recording.blob_places().first().map(|place| (place.id - 1, place.time / 1000))));
    }
    cycles
}

#[test]
fn what_was_received_is_read_again() {
    for (number, (read, place)) in (0..).zip(read(&recorded(40, 0)[..])) {
        let mut expected = cycle(number);
        expected.tick.tree = expected.tree.digest();
        expected.blobs = read.blobs.clone();
        assert_eq!(read, expected);
        let time_us = PERIOD_US * number;
        assert_eq!(place, number.is_multiple_of(3).then_some((number as u32 / 3, time_us)));
        if let Some(image) = read.blobs.first() {
            assert!(image.bytes == pixels(number), "{number}");
        }
    }
}

#[test]
fn an_image_that_came_late_has_its_own_time() {
    let bytes = recorded(60, 7);
    let places: Vec<_> = read(&bytes[..]).into_iter().filter_map(|(_, place)| place).collect();
    let expected: Vec<_> = (0..=17).map(|number: u32| (number, 3 * PERIOD_US * u64::from(number))).collect();
    assert_eq!(places, expected);
}

#[test]
fn many_small_images_find_their_cycles() {
    let disk = Disk::default();
    let mut recorder = MonitorRecorder::new(disk.clone(), &header()).expect("memory");
    let dark = [0; 2 * SIZE.0 as usize * SIZE.1 as usize];
    for number in 0..300 {
        recorder.image(number as u32, PERIOD_US * number, &support::image(&dark)).expect("memory");
        recorder.cycle(&cycle(number)).expect("memory");
    }
    assert_eq!(recorder.finish(None, 0).cycles, 300);
    for (number, (_, place)) in (0..).zip(read(&disk.contents()[..])) {
        assert_eq!(place, Some((number as u32, PERIOD_US * number)));
    }
}

#[test]
fn an_image_of_an_impossible_size_is_left_out() {
    let disk = Disk::default();
    let mut recorder = MonitorRecorder::new(disk.clone(), &header()).expect("memory");
    recorder.image(1, 0, &support::image(&[0; 12])).expect("nothing is written");
    recorder.cycle(&cycle(0)).expect("memory");
    assert_eq!(recorder.finish(None, 0).reason, None);
    assert!(read(&disk.contents()[..]).iter().all(|(_, place)| place.is_none()));
}

#[test]
fn trimmed_recording_begins_with_earlier_states() {
    let mut part = Vec::new();
    let copied = trim(Cursor::new(recorded(40, 0)), &mut part, 250_000_000, 300_000_000, None).expect("memory");
    assert_eq!(copied.cycles, 6);
    let (first, _) = read(&part[..]).remove(0);
    assert_eq!((first.tick.cycle, first.tree), (25, cycle(25).tree));
    assert_eq!(first.holds, cycle(15).holds);
}

#[test]
fn a_cut_recording_is_recovered_up_to_the_cut() {
    // More images than a chunk has, so that there are several chunks.
    let whole = recorded(400, 0);
    let cut = &whole[..whole.len() * 3 / 4];
    assert!(matches!(Recording::new(cut).map(|_| ()), Ok(())));
    let mut recovered = Vec::new();
    let copied = recover(Cursor::new(cut), &mut recovered, None).expect("memory");
    assert!((100..400).contains(&copied.cycles) && copied.damage.len() == 1, "{copied:?}");
    assert_eq!(read(&recovered[..]).len() as u64, copied.cycles);
}

#[test]
fn a_full_disk_leaves_all_complete_chunks() {
    let whole = recorded(400, 0);
    let disk = Disk { capacity: Some(whole.len() / 2), ..Disk::default() };
    let report = record(&disk, 400, 0).expect("room for the header");
    assert!(report.reason.as_ref().is_some_and(|reason| reason.contains("cannot write")), "{report:?}");
    assert!((50..400).contains(&report.cycles), "{report:?}");
    let info = Info::read(&disk.contents()[..]).expect("a recording");
    assert_eq!(info.cycles, report.cycles);
    assert!(MonitorRecorder::new(Disk { capacity: Some(100), ..Disk::default() }, &header()).is_err());
}

#[test]
fn overview_lists_requests_and_events() {
    let info = Info::read(&recorded(40, 0)[..]).expect("a recording");
    assert_eq!((info.cycles, info.fingerprint.as_str(), info.damage), (40, "", None));
    assert_eq!((info.requests[0].request.as_str(), info.events[0].event.as_str()), ("hold Counter latent", "goal"));
    let monitor = info.header.monitor.expect("a monitor made it");
    assert_eq!(monitor.address, "tcp://lamp:7400");
    assert_eq!(monitor.lacks, ["sensors", "command", "costs", "requests"]);
    assert_eq!(info.header.tree, description());
}

#[test]
fn a_recording_of_another_format_is_refused() {
    for format in [1, 6, 9] {
        let disk = Disk::default();
        let _ = MonitorRecorder::new(disk.clone(), &Header { format, ..header() }).expect("memory");
        let error = Recording::new(&disk.contents()[..]).map(|_| ()).expect_err("another format");
        assert!(matches!(error, Error::Format(found) if found == format), "{error}");
        assert!(
            error.to_string().contains(&format!("format {format}; this program reads format 7, of a monitor 8")),
            "{error}"
        );
    }
}
