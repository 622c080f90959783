//! Topics for other programs: derived, bounded, and ignored by everything else.

use std::collections::BTreeMap;
use std::io::Cursor;

use bica::runner::Runner;
use bica::visual::{CameraCalibration, ImageCircle, ImageSegment, Point2, Pose2, Scan};
use bica::{Blob, Format};
use bica_link::{Component, Description, Output, Placement};
use bica_recording::repair::{recover, trim};
use bica_recording::{
    Header, ImagePolicy, MonitorRecorder, OutputRecord, OutputsRecord, RecordedCycle, Recorder, RecorderOptions, Tick,
    Topics, TreeRecord,
};
use bica_wire::message::Offers;
use postcard_schema::Schema;
use postcard_schema::schema::NamedType;
use serde::Serialize;
use serde_json::{Value, json};

use crate::cdr::{Cdr, Messages, messages};
use crate::support::{Cart, Disk, Sensors, cycles, header, record_topics, recorded, scenery, sensors};

fn described(topics: Topics) -> (Vec<u8>, Messages) {
    let disk = Disk::default();
    record_topics(&disk, ImagePolicy::All, topics, 60, RecorderOptions::default()).expect("there is room");
    let file = disk.contents();
    let found = messages(&file);
    (file, found)
}

#[test]
fn topics_are_made_again_by_a_copy() {
    let [(none, empty), (standard, shown), (all, _)] = [Topics::None, Topics::Standard, Topics::All].map(described);
    assert_eq!(empty, BTreeMap::new());
    let names: Vec<_> = shown.keys().map(String::as_str).collect();
    assert_eq!(
        names,
        [
            "/camera/image_raw/compressed",
            "/cart/blinker/state",
            "/cart/states",
            "/parameter_events",
            "/rosout",
            "/scanner/points",
        ]
    );
    // As text, because a NaN is not equal to itself.
    let content = |file: &[u8]| format!("{:?}", cycles(file));
    assert_eq!(content(&standard), content(&none));
    assert_eq!(content(&all), content(&none));
    let (mut recovered, mut without) = (Vec::new(), Vec::new());
    recover(Cursor::new(&none), &mut recovered, Some(Topics::Standard)).expect("intact");
    assert!(messages(&recovered) == shown, "previews are of the same images");
    trim(Cursor::new(&recovered), &mut without, 0, u64::MAX, Some(Topics::None)).expect("intact");
    assert_eq!(messages(&without), empty);
}

#[test]
fn previews_are_rare_and_scans_are_points() {
    let (_, shown) = described(Topics::Standard);
    let images = &shown["/camera/image_raw/compressed"];
    let times: Vec<_> = images.iter().map(|(time, _)| time / 1_000_000).collect();
    assert_eq!(times, [50, 350], "with the outputs of cycles 5 and 35");
    let mut image = Cdr::new(&images[1].1);
    assert_eq!((image.header().1, image.text()), ("camera", "jpeg"));
    assert!(image.bytes().starts_with(&[0xff, 0xd8, 0xff]));
    // The scan of cycle 32, of cycles 5 to 35 the newest.
    assert_eq!(points(&shown["/scanner/points"][1].1).len(), 12 * (120 - 32));
}

/// Returns the points of a message `sensor_msgs/msg/PointCloud2`.
fn points(message: &[u8]) -> &[u8] {
    let mut cloud = Cdr::new(message);
    let (_, [_, width], fields) = (cloud.header(), [cloud.u32(), cloud.u32()], cloud.u32());
    let field = |_| {
        let (name, offset, _, _) = (cloud.text(), cloud.u32(), cloud.u8(), cloud.u32());
        (name, offset)
    };
    let names: Vec<_> = (0..fields).map(field).collect();
    assert_eq!(names, [("x", 0), ("y", 4), ("z", 8)]);
    let (is_bigendian, [step, row]) = (cloud.u8(), [cloud.u32(), cloud.u32()]);
    assert_eq!((is_bigendian, step, row), (0, 12, 12 * width));
    cloud.bytes()
}

#[test]
fn states_have_names_and_parameters_their_values() {
    let (_, shown) = described(Topics::Standard);
    let states = shown["/cart/blinker/state"].iter().map(|(_, message)| Cdr::new(message).text());
    assert_eq!(states.take(2).collect::<Vec<_>>(), ["dark", "bright"]);
    let mut all = Cdr::new(&shown["/cart/states"][0].1);
    assert_eq!((all.u8(), all.text(), all.text(), all.text()), (0, "cart", "dark", "/cart"));
    let values: Vec<_> = (0..all.u32()).map(|_| [all.text(), all.text()]).collect();
    assert_eq!(values, [["Blinker", "dark"], ["Counter", "latent"]]);
    let parameters = &shown["/parameter_events"];
    let mut first = Cdr::new(&parameters[0].1);
    assert_eq!((parameters.len(), first.header().1, first.u32(), first.u32()), (1, "/cart", 0, 1));
    assert_eq!((first.text(), first.u8(), first.u8()), ("Counter.gain", 3, 0), "a number");
    assert_eq!(first.f64s(2), [0.0, 1.0], "without an integer");
    let line = |(_, line): &(u64, Vec<u8>)| {
        let mut line = Cdr::new(line);
        (line.u32(), line.u32(), line.u8(), line.text().to_owned(), line.text().to_owned())
    };
    let lines: Vec<_> = shown["/rosout"].iter().map(line).map(|(.., level, name, text)| (level, name, text)).collect();
    let expected = [
        (10, "cart.Blinker", "Blinker: bright"),
        (20, "cart.operator", "hold Counter active"),
        (20, "cart.event", "goal"),
    ];
    for (level, name, text) in expected {
        assert!(lines.contains(&(level, name.to_owned(), text.to_owned())), "{text} in {lines:?}");
    }
}

#[test]
fn all_numbers_are_json_on_request() {
    let (_, shown) = described(Topics::All);
    let json = |topic: &str| -> Vec<Value> {
        let text = |(_, message): &(u64, Vec<u8>)| serde_json::from_str(Cdr::new(message).text()).expect("JSON");
        shown[topic].iter().map(text).collect()
    };
    let runs: Vec<_> = shown["/cart/counter/runs"].iter().map(|(_, runs)| Cdr::new(runs).u32()).collect();
    assert!(runs.len() > 2 && runs.is_sorted(), "{runs:?}");
    let days = json("/cart/counter/day");
    assert!(days.len() == runs.len() && days.iter().all(|day| day[0].is_boolean()), "{days:?}");
    let sensors = &json("/cart/sensors")[7];
    assert_eq!((&sensors["speeds"], &sensors["ranges"][7]), (&json!([7.0, -0.0]), &Value::Null));
    assert_eq!(json("/cart/command").len(), 60);
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
fn monitored(seconds: u64) -> Messages {
    let described = outputs().map(|(shape, frame, child, schema, _)| {
        let [shape, frame] = [shape, frame].map(str::to_owned);
        let placement = Some(Placement { shape: shape.clone(), frame, child: child.map(str::to_owned) });
        let schema = Some(schema.into());
        let type_name = if shape == "Point2" { "(Option<Point2>, Option<Point2>)" } else { "" }.to_owned();
        Output { name: shape, doc: String::new(), unit: None, type_name, placement, schema }
    });
    let component = Component { name: "Seeing".to_owned(), outputs: described.to_vec(), ..Component::default() };
    let description = Description {
        name: "Robot".to_owned(),
        cycle_hz: 100.0,
        components: vec![component],
        ..Description::default()
    };
    let disk = Disk::default();
    let header = Header::of_monitor("tcp://robot:7400", &description, Offers::OPERATE);
    let mut recorder = MonitorRecorder::new(disk.clone(), &header).expect("memory");
    let yuyv = [[200, 90], [40, 160]].concat().repeat(640 * 480 / 2);
    for number in 0..100 * seconds {
        let blob = Blob { bytes: &yuyv, format: Format::Yuyv { width: 640, height: 480 }, frame: "top_eye" };
        if number % 10 == 0 {
            recorder.image(number as u32, 10_000 * number, &blob).expect("memory");
        }
        let values = outputs().into_iter().enumerate().map(|(index, (.., value))| {
            // Each second the component sees something in its first half.
            OutputRecord { component: 0, index: index as u16, value }
        });
        let active = number % 100 < 50;
        let values = if active { values.collect() } else { Vec::new() };
        let mut cycle = RecordedCycle {
            tick: Tick { cycle: number, instant: 10_000 * number, ..Tick::default() },
            tree: TreeRecord { active: vec![active.into()], states: vec![u8::MAX] },
            ..RecordedCycle::default()
        };
        cycle.outputs = number.is_multiple_of(2).then_some(OutputsRecord { values });
        recorder.cycle(&cycle).expect("memory");
    }
    assert_eq!(recorder.finish(None, 0).reason, None);
    messages(&disk.contents())
}

#[test]
fn visual_outputs_are_shown_in_their_frames() {
    let shown = monitored(2);
    // Before any place is known the frames are one tree.
    let mut first = Cdr::new(&shown["/tf"][0].1);
    assert_eq!((shown["/tf"][0].0, first.u32(), first.header(), first.text()), (0, 1, (0, "world"), "base_link"));
    assert_eq!(first.f64s(7), [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
    let mut tf = Cdr::new(&shown["/tf"][1].1);
    assert_eq!((tf.u32(), tf.header().1, tf.text()), (1, "world", "base_link"));
    assert_eq!(tf.f64s(7), [1.0, 2.0, 0.0, 0.0, 0.0, 0.25_f64.sin(), 0.25_f64.cos()]);
    let mut optical = Cdr::new(&shown["/tf_static"][0].1);
    assert_eq!((optical.u32(), optical.header().1, optical.text()), (1, "eye", "eye_optical"));
    let mut position = Cdr::new(&shown["/robot/seeing/point2"][0].1);
    assert_eq!((position.u32(), position.header().1), (2, "base_link"), "a removal and a point");
    assert_eq!(points(&shown["/robot/seeing/scan/points"][0].1), [2.0_f32, 0.0, 0.0].map(f32::to_le_bytes).concat());
    assert!(!shown.contains_key("/robot/seeing/scan/markers"));
    // The image of 640×480 is shown at half its size, and with it what is seen in it.
    let mut seen = Cdr::new(&shown["/robot/seeing/image_circle"][0].1);
    let time = [seen.u32(), seen.u32()];
    assert_eq!((time, seen.u32(), [seen.u32(), seen.u32()]), ([0, 0], 1, time));
    assert_eq!(seen.f64s(4), [50.0, 25.0, 8.0, 2.0], "centre, diameter and width of the line");
    let mut camera = Cdr::new(&shown["/eye/camera_info"][0].1);
    assert_eq!((camera.header().1, camera.u32(), camera.u32()), ("eye_optical", 240, 320));
    assert_eq!((camera.text(), camera.u32(), camera.f64s(6)[5]), ("plumb_bob", 5, 300.0));
    assert_eq!(Cdr::new(&shown["/eye/image_raw/compressed"][0].1).header().1, "eye_optical");
    assert!(!shown.contains_key("/robot/seeing/image_segment"), "there never was one");
}

#[test]
fn rates_are_bounded_and_latent_outputs_disappear() {
    let shown = monitored(2);
    assert_eq!(shown["/tf"].len(), 1 + 17, "17 a second, of 50 records, in half of the time");
    assert_eq!(shown["/eye/image_raw/compressed"].len(), 7);
    let markers = shown["/robot/seeing/point2"].iter().map(|(_, markers)| Cdr::new(markers).u32());
    assert_eq!(markers.collect::<Vec<_>>(), [2, 1, 2, 1], "a value that stays is not repeated");
    let (_, last) = shown["/robot/seeing/image_circle"].last().expect("some");
    let mut last = Cdr::new(last);
    assert_eq!([last.u32(), last.u32(), last.u32()][2], 0);
}

#[test]
fn a_recording_of_before_has_no_topics() {
    let header = Header::of_monitor("tcp://robot:7400", &Description::default(), Offers::OPERATE);
    let text = serde_json::to_value(header).expect("JSON");
    let mut old = text.as_object().expect("an object").clone();
    assert_eq!(old.remove("topics"), Some("standard".into()));
    let header: Header = serde_json::from_value(old.into()).expect("a header");
    assert_eq!(header.topics, Topics::None);
    assert!(messages(&recorded(3)).contains_key("/cart/states"));
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
    let shown = messages(&disk.contents());
    let pixels = |frame: &str| {
        let mut image = Cdr::new(&shown[&format!("/{frame}/image_raw/compressed")][0].1);
        let _ = (image.header(), image.text());
        image.bytes().to_vec()
    };
    assert_eq!((pixels("left_eye"), pixels("left_eye_2")), (vec![1; 200], vec![2; 200]));
}

#[test]
fn equal_topics_are_refused_before_the_run() {
    let header =
        Header { scenery: vec![scenery("far wall", "room"), scenery("far_wall", "room")], ..header(ImagePolicy::All) };
    let refused = Recorder::start(Disk::default(), &header, RecorderOptions::default(), |_| {}).expect_err("one topic");
    let text = refused.to_string();
    assert!(
        text.contains("`far wall`") && text.contains("`far_wall`") && text.contains("/cart/scenery/far_wall/points"),
        "{text}"
    );
}
