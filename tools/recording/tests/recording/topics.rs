//! Topics for other programs: derived, bounded, and ignored by everything else.

use std::collections::BTreeMap;
use std::io::Cursor;

use bica::runner::Runner;
use bica::visual::{CameraCalibration, ImageCircle, ImageSegment, Point2, Pose2, Scan};
use bica::{Blob, Format};
use bica_link::{Component, Description, Info as Output, Placement};
use bica_recording::mcap::{Item, Reader};
use bica_recording::repair::{recover, trim};
use bica_recording::{
    Header, ImagePolicy, InformationRecord, InformationValue, MonitorRecorder, ReceivedImage, RecordedCycle, Recorder,
    RecorderOptions, Tick, Topics, TreeRecord,
};
use bica_wire::message::Offers;
use postcard_schema::Schema;
use postcard_schema::schema::NamedType;
use serde::Serialize;
use serde_json::{Value, json};

use crate::support::{Cart, Disk, Sensors, cycles, header, record_topics, recorded, scenery, sensors};

/// Messages of the topics of other programs, with their times, ns.
fn topics(file: &[u8]) -> BTreeMap<String, Vec<(u64, Vec<u8>)>> {
    let (mut reader, mut names, mut found) = (Reader::new(file).expect("MCAP"), BTreeMap::new(), BTreeMap::new());
    loop {
        match reader.next_item().expect("intact") {
            Item::Channel(channel) if channel.encoding != "postcard" => _ = names.insert(channel.id, channel.topic),
            Item::Message(message) => {
                if let Some(topic) = names.get(&message.channel) {
                    found.entry(topic.clone()).or_insert_with(Vec::new).push((message.time, message.data));
                }
            }
            Item::End => return found,
            _ => {}
        }
    }
}

/// Returns the fields of a message of Protocol Buffers that have a number and a length.
fn fields(mut message: &[u8], number: u64) -> Vec<&[u8]> {
    let varint = |bytes: &mut &[u8]| {
        let length = bytes.iter().position(|byte| byte & 0x80 == 0).expect("an end") + 1;
        let (taken, rest) = bytes.split_at(length);
        *bytes = rest;
        taken.iter().rev().fold(0, |value, byte| value << 7 | u64::from(byte & 0x7f))
    };
    let mut found = Vec::new();
    while !message.is_empty() {
        let tag = varint(&mut message);
        let length = match tag & 7 {
            0 => {
                varint(&mut message);
                continue;
            }
            1 => 8,
            2 => varint(&mut message) as usize,
            _ => 4,
        };
        let (content, rest) = message.split_at(length);
        message = rest;
        found.extend((tag >> 3 == number).then_some(content));
    }
    found
}

fn double(message: &[u8], number: u64) -> f64 {
    fields(message, number).first().map_or(0.0, |bytes| f64::from_le_bytes((*bytes).try_into().expect("a double")))
}

/// Messages of each topic, with their times.
type Messages = BTreeMap<String, Vec<(u64, Vec<u8>)>>;

fn described(topics: Topics) -> (Vec<u8>, Messages) {
    let disk = Disk::default();
    record_topics(&disk, ImagePolicy::All, topics, 60, RecorderOptions::default()).expect("there is room");
    let file = disk.contents();
    let found = self::topics(&file);
    (file, found)
}

#[test]
fn topics_are_made_again_by_a_copy() {
    let [(none, empty), (standard, shown), (all, _)] = [Topics::None, Topics::Standard, Topics::All].map(described);
    assert_eq!(empty, BTreeMap::new());
    let names: Vec<_> = shown.keys().map(String::as_str).collect();
    assert_eq!(names, ["/camera/image", "/log", "/parameters", "/scanner/points", "/states"]);
    // As text, because a NaN is not equal to itself.
    let content = |file: &[u8]| format!("{:?}", cycles(file));
    assert_eq!(content(&standard), content(&none));
    assert_eq!(content(&all), content(&none));
    let (mut recovered, mut without) = (Vec::new(), Vec::new());
    recover(Cursor::new(&none), &mut recovered, Some(Topics::Standard)).expect("intact");
    assert!(topics(&recovered) == shown, "previews are of the same images");
    trim(Cursor::new(&recovered), &mut without, 0, u64::MAX, Some(Topics::None)).expect("intact");
    assert_eq!(topics(&without), empty);
}

#[test]
fn previews_are_rare_and_scans_are_points() {
    let (_, shown) = described(Topics::Standard);
    let times: Vec<_> = shown["/camera/image"].iter().map(|(time, _)| time / 1_000_000).collect();
    assert_eq!(times, [50, 350], "with the outputs of cycles 5 and 35");
    let (_, image) = &shown["/camera/image"][1];
    assert!(fields(image, 2)[0].starts_with(&[0xff, 0xd8, 0xff]));
    assert_eq!((fields(image, 3), fields(image, 4)), (vec![&b"jpeg"[..]], vec![&b"camera"[..]]));
    // The scan of cycle 32, of cycles 5 to 35 the newest.
    assert_eq!(fields(&shown["/scanner/points"][1].1, 6)[0].len(), 12 * (120 - 32));
}

#[test]
fn states_have_names_and_parameters_their_values() {
    let (_, shown) = described(Topics::Standard);
    let states: Vec<_> = shown["/states"].iter().map(|(_, message)| [1, 2].map(|at| fields(message, at)[0])).collect();
    assert_eq!(states[..2], [[&b"dark"[..], b"latent"], [b"bright", b"active"]]);
    let parameters = &shown["/parameters"];
    assert_eq!((parameters.len(), double(fields(&parameters[0].1, 2)[0], 1)), (1, 1.0));
    let lines: Vec<_> = shown["/log"].iter().map(|(_, line)| String::from_utf8_lossy(fields(line, 3)[0])).collect();
    for line in ["Blinker: bright", "hold Counter active", "goal"] {
        assert!(lines.iter().any(|one| one == line), "{line} in {lines:?}");
    }
}

#[test]
fn all_numbers_are_json_on_request() {
    let (_, shown) = described(Topics::All);
    let json = |topic: &str| -> Vec<Value> {
        shown[topic].iter().map(|(_, message)| serde_json::from_slice(message).expect("JSON")).collect()
    };
    let runs: Vec<_> = json("/outputs/Counter/runs").iter().map(|runs| runs["value"].as_u64()).collect();
    assert!(runs.len() > 2 && runs.is_sorted() && runs.iter().all(Option::is_some), "{runs:?}");
    let days = json("/outputs/Counter/day");
    assert!(days.len() == runs.len() && days.iter().all(|day| day["value"][0].is_boolean()), "{days:?}");
    let sensors = &json("/sensors")[7];
    assert_eq!((&sensors["speeds"], &sensors["ranges"][7]), (&json!([7.0, -0.0]), &Value::Null));
    assert_eq!(json("/command").len(), 60);
}

/// An output with a visual type: that type, the frame of its values, the frame that they place, its schema and its value.
type Seen = (&'static str, &'static str, Option<&'static str>, &'static NamedType, Vec<u8>);

fn output<V: Serialize + Schema>(shape: &'static str, frame: &'static str, value: &V) -> Seen {
    (shape, frame, None, V::SCHEMA, postcard::to_stdvec(value).expect("memory"))
}

/// Outputs of a robot with a camera, and their values.
fn outputs() -> [Seen; 6] {
    let ranges = [2.0, 5.0, f32::NAN].into_iter().collect();
    let pose = Pose2 { x: 1.0, y: 2.0, heading: 0.5 };
    let mut place = output("Pose2", "world", &pose);
    place.2 = Some("robot");
    [
        place,
        output("Point2", "robot", &(Some(Point2 { x: 3.0, y: 0.5 }), None::<Point2>)),
        output("Scan", "robot", &Scan::<3> { angle_min: 0.0, angle_increment: 0.5, range_max: 4.0, ranges }),
        output("ImageCircle", "eye", &ImageCircle { x: 100.0, y: 50.0, radius: 8.0 }),
        output("ImageSegment", "eye", &None::<ImageSegment>),
        output(
            "CameraCalibration",
            "eye",
            &CameraCalibration { focal_x: 600.0, focal_y: 602.0, centre_x: 320.0, centre_y: 240.0 },
        ),
    ]
}

/// Records a robot of which only a description is known.
fn monitored(seconds: u64) -> BTreeMap<String, Vec<(u64, Vec<u8>)>> {
    let info = outputs().map(|(shape, frame, child, schema, _)| {
        let [shape, frame] = [shape, frame].map(str::to_owned);
        let placement = Some(Placement { shape: shape.clone(), frame, child: child.map(str::to_owned) });
        let schema = Some(schema.into());
        Output { name: shape, doc: String::new(), unit: None, type_name: String::new(), placement, schema }
    });
    let component = Component { name: "Seeing".to_owned(), info: info.to_vec(), ..Component::default() };
    let description = Description { cycle_hz: 100.0, components: vec![component], ..Description::default() };
    let disk = Disk::default();
    let header = Header::of_monitor("tcp://robot:7400", &description, Offers::OPERATE);
    let mut recorder = MonitorRecorder::new(disk.clone(), &header).expect("memory");
    let yuyv = [[200, 90], [40, 160]].concat().repeat(640 * 480 / 2);
    for number in 0..100 * seconds {
        let blob = Blob { bytes: &yuyv, format: Format::Yuyv { width: 640, height: 480 }, frame: "top_eye" };
        if number % 10 == 0 {
            let image = ReceivedImage { number: number as u32, time_us: 10_000 * number, blob };
            recorder.image(&image).expect("memory");
        }
        let values = outputs().into_iter().enumerate().map(|(index, (.., value))| {
            // Each second the component sees something in its first half.
            InformationValue { component: 0, index: index as u16, value }
        });
        let active = number % 100 < 50;
        let values = if active { values.collect() } else { Vec::new() };
        let mut cycle = RecordedCycle {
            tick: Tick { cycle: number, instant: 10_000 * number, ..Tick::default() },
            tree: TreeRecord { active: vec![active.into()], states: vec![u8::MAX] },
            ..RecordedCycle::default()
        };
        cycle.information = number.is_multiple_of(2).then_some(InformationRecord { values });
        recorder.cycle(&cycle).expect("memory");
    }
    assert_eq!(recorder.finish(None, 0).reason, None);
    topics(&disk.contents())
}

#[test]
fn visual_outputs_are_shown_in_their_frames() {
    let shown = monitored(2);
    // Before any place is known the frames are one tree.
    let first = fields(&shown["/tf"][0].1, 1);
    assert_eq!((shown["/tf"][0].0, first.len(), fields(first[0], 2)), (0, 1, vec![&b"world"[..]]));
    let tf = fields(&shown["/tf"][1].1, 1);
    let frames: Vec<_> = tf.iter().map(|tf| [2, 3].map(|at| String::from_utf8_lossy(fields(tf, at)[0]))).collect();
    assert_eq!(frames, [["world", "robot"], ["eye", "eye_optical"]]);
    assert_eq!((double(fields(tf[0], 4)[0], 2), double(fields(tf[0], 5)[0], 3)), (2.0, 0.25_f64.sin()));
    let dots = fields(fields(&shown["/scene/Seeing/Point2"][0].1, 2)[0], 9);
    assert_eq!((dots.len(), double(fields(fields(dots[0], 1)[0], 1)[0], 1)), (1, 3.0));
    assert_eq!(fields(&shown["/points/Seeing/Scan"][0].1, 6), [[2.0_f32, 0.0, 0.0].map(f32::to_le_bytes).concat()]);
    assert!(!shown.contains_key("/scene/Seeing/Scan"));
    // The image of 640×480 is shown at half its size, and with it what is seen in it.
    let circle = fields(&shown["/annotations/Seeing/ImageCircle"][0].1, 1)[0];
    assert_eq!((double(fields(circle, 2)[0], 1), double(circle, 3)), (50.0, 8.0));
    let matrix = fields(&shown["/eye/calibration"][0].1, 6)[0];
    assert_eq!(matrix[..8], 300.0_f64.to_le_bytes());
    assert_eq!(fields(&shown["/eye/image"][0].1, 4), [b"eye_optical"]);
    assert!(!shown.contains_key("/annotations/Seeing/ImageSegment"), "there never was one");
}

#[test]
fn rates_are_bounded_and_latent_outputs_disappear() {
    let shown = monitored(2);
    assert_eq!(shown["/tf"].len(), 1 + 2 * 17, "17 a second, of 50 records");
    assert_eq!(shown["/eye/image"].len(), 7);
    let scenes = &shown["/scene/Seeing/Point2"];
    let dots: Vec<_> = scenes.iter().map(|(_, scene)| fields(fields(scene, 2)[0], 9).len()).collect();
    assert_eq!(dots, [1, 0, 1, 0], "a value that stays is not repeated");
    let (_, last) = shown["/annotations/Seeing/ImageCircle"].last().expect("some");
    assert_eq!(fields(last, 1).len(), 0);
}

#[test]
fn a_recording_of_before_has_no_topics() {
    let header = Header::of_monitor("tcp://robot:7400", &Description::default(), Offers::OPERATE);
    let text = serde_json::to_value(header).expect("JSON");
    let mut old = text.as_object().expect("an object").clone();
    assert_eq!(old.remove("topics"), Some("standard".into()));
    let header: Header = serde_json::from_value(old.into()).expect("a header");
    assert_eq!(header.topics, Topics::None);
    assert!(topics(&recorded(3)).contains_key("/states"));
}

#[test]
fn each_camera_has_its_own_topic() {
    let (disk, mut cart, options) = (Disk::default(), Cart::new(), RecorderOptions::default());
    let recorder = Recorder::start(disk.clone(), &header(ImagePolicy::All), options, |_| {}).expect("memory");
    let mut runner = Runner::new(&mut cart, ()).with_observer(recorder);
    for cycle in 0..60 {
        let blob = |bytes| Some(Blob { bytes, format: Format::Jpeg, frame: "left eye" });
        let values = Sensors { image: blob(&[1; 200]), scan: blob(&[2; 200]), ..sensors(cycle, &[]) };
        let now = bica::Instant::from_millis(10 * cycle);
        runner.sense(now, &values).expect("never refused");
        runner.think(now);
    }
    drop(runner);
    let shown = topics(&disk.contents());
    let pixels = |topic: &str| fields(&shown[topic][0].1, 2)[0].to_vec();
    assert_eq!((pixels("/left_eye/image"), pixels("/left_eye_2/image")), (vec![1; 200], vec![2; 200]));
}

#[test]
fn equal_topics_are_refused_before_the_run() {
    let header =
        Header { scenery: vec![scenery("far wall", "room"), scenery("far_wall", "room")], ..header(ImagePolicy::All) };
    let refused = Recorder::start(Disk::default(), &header, RecorderOptions::default(), |_| {}).expect_err("one topic");
    let text = refused.to_string();
    assert!(text.contains("`far wall`") && text.contains("`far_wall`") && text.contains("/scene/far_wall"), "{text}");
}
