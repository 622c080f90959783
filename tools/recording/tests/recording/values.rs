//! What is written is read again.

use std::io::Cursor;
use std::sync::Arc;

use bica::ComponentId;
use bica::runner::OwnedRequest;
use bica_recording::repair::trim;
use bica_recording::{
    Comparison, ImagePolicy, Info, Recordable, RecordedCycle, RecorderOptions, Recording, RequestRecord,
};
use postcard_schema::Schema;

use crate::support::{
    Cart, Command, Disk, Lamp, Sensors, cycles, header, image, pixels, record, record_sharing, recorded, recorded_from,
    sensors,
};

/// Returns the sensor values of a cycle.
fn sensed<'a>(cycle: &'a RecordedCycle, blobs: &'a [u8]) -> Sensors<'a> {
    Cart::decode_sensors(cycle.sensors.as_ref().expect("stored"), blobs).expect("intact")
}

/// Returns the command of a cycle.
fn command(cycle: &RecordedCycle) -> Command {
    postcard::from_bytes(cycle.command.as_ref().expect("stored")).expect("intact")
}

#[test]
fn every_value_is_restored_bit_for_bit() {
    let (cycles, error) = cycles(&recorded(60)[..]);
    assert_eq!((cycles.len(), error), (60, None));
    for (number, cycle) in cycles.iter().enumerate() {
        let number = number as u64;
        assert_eq!((cycle.tick.cycle, cycle.tick.instant), (number, 10_000 * number));
        let (yuyv, blobs) = (pixels(number), cycle.blob_bytes());
        // As text, because a NaN is not equal to itself.
        assert_eq!(format!("{:?}", sensed(cycle, &blobs)), format!("{:?}", sensors(number, &yuyv)));
        assert_eq!(cycle.tick.blobs, crc32fast::hash(&blobs));
        assert_eq!(sensed(cycle, &blobs).ranges[7].to_bits(), 0x7fc0_1234 + number as u32);
        let count = usize::from(number.is_multiple_of(3)) + usize::from(number.is_multiple_of(4));
        assert_eq!(cycle.blobs.len(), count);
        if number.is_multiple_of(3) {
            assert_eq!(cycle.blobs[0].blob(), image(&yuyv));
        }
        let Command { torques, lamp } = command(cycle);
        assert_eq!(matches!(lamp, Lamp::Bright { share } if share.is_nan()), (torques[1] as u32) % 2 == 1);
    }
    let component = ComponentId::new(1);
    assert_eq!(cycles[7].requests[0], RequestRecord::Tree(OwnedRequest::Hold { component, hold: bica::Hold::Active }));
    assert_eq!(cycles[7].requests[1], RequestRecord::Tree(OwnedRequest::Rate { component, hz: None }));
    let event = cycles.iter().position(|cycle| !cycle.events.is_empty());
    assert_eq!(event, Some(10), "an event belongs to the cycle after it");
    let states: Vec<_> = cycles.iter().map(|cycle| cycle.tree.state(0)).collect();
    assert!(states.contains(&Some(0)) && states.contains(&Some(1)));
    assert!(cycles.iter().all(|cycle| cycle.tree.is_active(0)));
    assert!(!cycles[0].tree.is_active(1) && cycles[8].tree.is_active(1));
}

#[test]
fn outputs_are_recorded_in_each_tenth_cycle() {
    let (cycles, _) = cycles(&recorded(60)[..]);
    let with: Vec<_> = cycles.iter().filter(|cycle| cycle.outputs.is_some()).collect();
    assert_eq!(with.iter().map(|cycle| cycle.tick.cycle).collect::<Vec<_>>(), [5, 15, 25, 35, 45, 55]);
    for cycle in with {
        let values = &cycle.outputs.as_ref().expect("filtered").values;
        if !cycle.tree.is_active(1) {
            assert_eq!(values, &[]);
            continue;
        }
        let [runs, day] = &values[..] else { panic!("{values:?}") };
        assert_eq!(((runs.component, runs.index), (day.component, day.index)), ((1, 0), (1, 1)));
        let command = command(cycle).torques[1];
        assert_eq!(postcard::from_bytes::<u32>(&runs.value).expect("a number"), command as u32);
        let (even, hour): (Option<bool>, f32) = postcard::from_bytes(&day.value).expect("a pair");
        assert!(even == Some((command as u32).is_multiple_of(2)) && hour.is_nan());
    }
    let header = header(ImagePolicy::All);
    let info = &header.tree.components[1].outputs;
    assert_eq!((info[0].name.as_str(), info[1].unit.as_deref()), ("runs", Some("h")));
    let schemas: Vec<_> = header.tree.components[1].outputs.iter().map(|output| output.schema.clone()).collect();
    assert_eq!(schemas, [Some(u32::SCHEMA.into()), Some(<(Option<bool>, f32)>::SCHEMA.into())]);
}

#[test]
fn without_images_digests_and_decisions_are_the_same() {
    let disk = Disk::default();
    record(&disk, ImagePolicy::None, 60, RecorderOptions::default()).expect("there is room");
    let small = disk.contents();
    let (all, empty) = (recorded(60), recorded(0).len());
    assert!(small.len() - empty < (all.len() - empty) / 4, "{} of {} beside {empty}", small.len(), all.len());
    let (one, two) = (cycles(&all[..]).0, cycles(&small[..]).0);
    let mut comparison = Comparison::new(&header(ImagePolicy::None));
    for (one, two) in one.iter().zip(&two) {
        assert_eq!(one.tick, two.tick);
        comparison.add(one, two);
    }
    assert_eq!((comparison.cycles, comparison.first), (60, None));
}

#[test]
fn shared_images_are_recorded_without_a_copy() {
    let dark = |yuyv: &[u8]| -> Arc<Vec<u8>> { Arc::new(yuyv.iter().map(|value| value / 2).collect()) };
    for images in [ImagePolicy::All, ImagePolicy::None] {
        let disk = Disk::default();
        // The images of every sixth cycle have an owner with other pixels. The recording has to contain those of the owner.
        let owner = move |yuyv: &[u8]| (0..30).any(|i| yuyv == pixels(6 * i)).then(|| dark(yuyv));
        let report = record_sharing(&disk, images, 60, RecorderOptions::default(), owner).expect("there is room");
        assert_eq!((report.cycles, report.dropped_images), (60, 0));
        for (number, cycle) in (0..).zip(cycles(&disk.contents()[..]).0) {
            let own = pixels(number);
            let expected = if number % 6 == 0 { dark(&own).to_vec() } else { own.clone() };
            let scan = sensors(number, &own).scan.map_or(&[][..], |scan| scan.bytes);
            let both = [if number % 3 == 0 { &expected[..] } else { &[] }, scan].concat();
            assert_eq!(cycle.tick.blobs, crc32fast::hash(&both), "cycle {number}");
            let stored = if images == ImagePolicy::All { both } else { Vec::new() };
            assert!(cycle.blob_bytes() == stored, "cycle {number}");
        }
    }
}

#[test]
fn every_changed_value_is_a_difference_of_its_field() {
    let cycles = cycles(&recorded(12)[..]).0;
    let differs = |change: &dyn Fn(&mut RecordedCycle)| {
        let mut comparison = Comparison::new(&header(ImagePolicy::All));
        for (number, cycle) in cycles.iter().enumerate() {
            let mut other = cycle.clone();
            if number == 9 {
                change(&mut other);
            }
            comparison.add(&other, cycle);
        }
        let first = comparison.first.expect("a difference");
        assert_eq!(first.cycle, 9);
        (first.component, first.field)
    };
    let field = |change: &dyn Fn(&mut RecordedCycle)| differs(change).1;
    assert_eq!(field(&|cycle| cycle.tick.instant ^= 1), "tick.instant");
    assert_eq!(field(&|cycle| cycle.tick.cycle ^= 1), "tick.cycle");
    assert_eq!(field(&|cycle| cycle.tick.fingerprint ^= 1), "fingerprint");
    assert_eq!(field(&|cycle| cycle.tick.blobs ^= 1), "blobs");
    assert_eq!(
        field(&|cycle| cycle
            .requests
            .push(RequestRecord::Tree(OwnedRequest::Rate { component: ComponentId::new(0), hz: Some(1.0) }))),
        "requests"
    );
    let sensors = |change: fn(&mut Sensors<'_>)| {
        field(&|cycle| {
            let blobs = cycle.blob_bytes();
            let mut sensors = sensed(cycle, &blobs);
            change(&mut sensors);
            let changed = Cart::encode_sensors(&sensors, Vec::new(), |_, _| {});
            cycle.sensors = changed;
        })
    };
    assert_eq!(sensors(|sensors| sensors.speeds[1] = 0.0), "sensors.speeds[1]");
    assert_eq!(sensors(|sensors| sensors.ranges[7] = f32::NAN), "sensors.ranges[7]");
    assert_eq!(sensors(|sensors| sensors.image = None), "sensors.image");
    assert_eq!(sensors(|sensors| sensors.image.as_mut().unwrap().frame = ""), "sensors.image.frame");
    let command = |change: fn(&mut Command)| {
        field(&|cycle| {
            let mut command = command(cycle);
            change(&mut command);
            cycle.command = Cart::encode_command(&command, Vec::new());
        })
    };
    assert_eq!(command(|command| command.torques[1] = 0.5), "command.torques[1]");
    assert_eq!(command(|command| command.lamp = Lamp::Bright { share: 0.5 }), "command.lamp.Bright.share");
    assert_eq!(command(|command| command.lamp = Lamp::Dark), "command.lamp");
    let active = differs(&|cycle| cycle.tree.active[0] ^= 1);
    assert_eq!(active, (Some("Blinker".to_owned()), "active".to_owned()));
    let state = differs(&|cycle| cycle.tree.states[0] ^= 1);
    assert_eq!(state, (Some("Blinker".to_owned()), "state".to_owned()));
}

#[test]
fn times_are_those_since_the_first_cycle() {
    let unix = recorded_from(1_764_000_000_000, 60);
    let [early, late] = [&recorded(60), &unix].map(|file| Info::read(&file[..]).expect("a recording"));
    let times =
        |info: &Info| (info.events.iter().map(|one| one.t).chain(info.requests.iter().map(|one| one.t))).collect();
    assert_eq!((late.seconds, times(&late)), (0.59, vec![0.09, 0.07, 0.07]));
    assert_eq!((early.seconds, times(&early)), (late.seconds, times(&late)));
    let mut target = Vec::new();
    let copied = trim(Cursor::new(&unix), &mut target, 200_000_000, 299_999_999, None).expect("a recording");
    assert_eq!((copied.cycles, cycles(&target[..]).0[0].tick.cycle), (10, 20));
    let beyond = trim(Cursor::new(&unix), &mut Vec::new(), 0, 700_000_000, None).expect_err("it is beyond the end");
    assert_eq!(beyond.to_string(), "the recording has no such span: it ends at 0.59 s");
}

#[test]
fn trimmed_file_has_its_cycles_and_tree() {
    let source = recorded(60);
    let mut target = Vec::new();
    let copied = trim(Cursor::new(&source), &mut target, 200_000_000, 299_999_999, None).expect("a recording");
    assert_eq!((copied.cycles, copied.damage.len()), (10, 0));
    let (all, (part, error)) = (cycles(&source[..]).0, cycles(&target[..]));
    assert_eq!(error, None);
    assert_eq!(part.len(), 10);
    for (one, two) in part.iter().zip(&all[20..]) {
        assert_eq!((one.tick, &one.tree, &one.blobs), (two.tick, &two.tree, &two.blobs));
    }
}

#[test]
fn the_contents_are_counted() {
    let info = Info::read(&recorded(60)[..]).expect("a recording");
    assert_eq!((info.cycles, info.damage, info.events.len(), info.requests.len()), (60, None, 1, 2));
    assert!((info.seconds - 0.59).abs() < 1e-9 && info.chunks > 4);
    assert_eq!(info.requests[0].request, "hold Counter active");
    let ending = info.ending.expect("closed");
    assert_eq!((ending.cycles, ending.result.as_str(), ending.reason.as_str()), (60, "lit", ""));
    let count =
        |topic: &str| info.channels.iter().find(|channel| channel.topic == topic).map(|channel| channel.messages);
    assert_eq!((count("blobs"), count("tick"), count("events")), (Some(35), Some(60), Some(1)));
}

#[test]
fn an_event_of_the_last_cycle_is_kept() {
    let file = recorded(10);
    let mut recording = Recording::new(&file[..]).expect("a header");
    while recording.next_cycle().expect("intact").is_some() {}
    assert_eq!(recording.rest().events.len(), 1);
}
