//! Faults of the robot's side.

use bica_lola::SensorMap;
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::NAO;

use crate::stand_in::{RISE, StandIn, stand};

/// Runs a robot, sends bytes that are no valid map, and checks that they are not answered but the next maps are.
fn survives(broken: impl Fn(Vec<u8>) -> Vec<u8>) {
    let mut robot = StandIn::start(stand);
    robot.cycles(RISE);
    for _ in 0..5 {
        let bytes = broken(robot.map.encode());
        robot.send(&bytes);
        assert!(robot.is_silent(), "it is answered");
        robot.cycles(10);
    }
    assert!(robot.is_silent());
}

/// Puts other bytes in the place of the first ones that are equal to some.
fn replace(mut bytes: Vec<u8>, old: &[u8], new: &[u8]) -> Vec<u8> {
    let at = bytes.windows(old.len()).position(|window| window == old).expect("it is there");
    bytes.splice(at..at + old.len(), new.iter().copied());
    bytes
}

#[test]
fn short_maps_are_not_answered() {
    for size in [1, 2, 12, 400, 895] {
        survives(|map| map[..size].to_vec());
    }
}

#[test]
fn long_maps_are_not_answered() {
    for extra in [&b"\xca\x00"[..], &[0; 40]] {
        survives(|map| [&map, extra].concat());
    }
    survives(|map| [&b"\x8e\xa4More\xca\0\0\0\0"[..], &map[1..]].concat());
}

#[test]
fn damaged_maps_are_not_answered() {
    survives(|map| vec![0xc1; map.len()]);
    survives(|map| vec![0x8d; map.len()]);
    // The start of a map with a long text, which the next map does not complete.
    survives(|_| b"\x8e\xa1x\xda\x0f\xff".to_vec());
    survives(|map| replace(map, b"\xa5Touch\x9e\xca", b"\xa5Touch\x9e\xcb"));
    survives(|map| replace(map, b"\xa6Angles\x92", b"\xa6Angles\x91"));
    survives(|map| replace(map, b"\xa6Status\xdc\x00\x19\x00", b"\xa6Status\xdc\x00\x19\xff"));
}

#[test]
fn maps_without_a_key_are_not_answered() {
    survives(|map| replace(map, b"Gyroscope", b"Gyroskope"));
    survives(|map| replace(map, b"\xa3FSR", b"\xa3FSX"));
}

#[test]
fn maps_with_nan_are_not_answered() {
    for value in [f32::NAN, f32::INFINITY] {
        survives(|map| {
            let (mut map, _) = SensorMap::decode(&map).expect("a map");
            map.position[3] = value;
            map.encode()
        });
    }
}

#[test]
fn maps_in_pieces_are_answered() {
    let mut robot = StandIn::start(stand);
    for _ in 0..3 {
        let map = robot.map.encode();
        for piece in map.chunks(100) {
            robot.send(piece);
            std::thread::sleep(std::time::Duration::from_millis(2));
        }
        robot.answer().expect("an answer");
    }
    assert!(robot.is_silent());
}

#[test]
fn robot_that_was_moved_starts_from_where_it_is() {
    let mut robot = StandIn::start(stand);
    robot.cycles(RISE);
    robot.map.position = NAO.sit.0;
    robot.map.position[Joint::HeadYaw.index()] = 1.5;
    robot.restart();
    robot.cycles(10);
    let (targets, _) = robot.last.expect("an answer");
    let mut expected = NAO.sit;
    expected[Joint::HeadYaw] = 1.5;
    assert_eq!(targets, expected);
    robot.cycles(RISE);
    assert!((Joints(robot.map.position)[Joint::LKneePitch] - NAO.stand[Joint::LKneePitch]).abs() < 0.01);
}

#[test]
fn stalled_robot_is_waited_for() {
    let mut robot = StandIn::start(stand);
    robot.cycles(RISE);
    std::thread::sleep(std::time::Duration::from_millis(1200));
    assert!(robot.is_silent());
    robot.cycles(50);
}

#[test]
fn late_maps_are_all_answered() {
    let mut robot = StandIn::start(stand);
    robot.cycles(RISE);
    let map = robot.map.encode();
    robot.send(&map.repeat(4));
    let expected = 4 * answer_bytes();
    let mut bytes = 0;
    while bytes < expected {
        bytes += robot.read();
    }
    assert_eq!(bytes, expected);
    assert!(robot.is_silent());
    robot.cycles(20);
}

/// Size of one answer, bytes.
fn answer_bytes() -> usize {
    let lights = bica_motion::robot::Lights::default();
    bica_lola::ActuatorMap { position: NAO.stand, stiffness: Joints::all(0.5), lights }.encode().len()
}
