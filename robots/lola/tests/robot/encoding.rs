//! Encoding of the maps.

use std::process::Command;

use bica_lola::{ActuatorMap, Identity, Mistake, SENSOR_MAP_BYTES, SensorMap, Undecoded};
use bica_motion::joints::Joints;
use bica_motion::robot::{Light, Lights};
use proptest::prelude::*;

fn array<const N: usize>() -> impl Strategy<Value = [f32; N]> {
    prop::collection::vec(-1e6_f32..1e6, N).prop_map(|values| values.try_into().expect("their number"))
}

prop_compose! {
    fn sensor_map()(
        (accelerometer, angles, battery, current) in (array(), array(), array(), array()),
        (fsr, gyroscope, position, sonar) in (array(), array(), array(), array()),
        (stiffness, temperature, touch) in (array(), array(), array()),
        status in prop::collection::vec(0_u8..4, 25),
        (body, version) in ("P[0-9A-Z]{19}", "[0-9]\\.[0-9]\\.[0-9]"),
    ) -> SensorMap {
        let identity = Identity::new([body.as_bytes(), b"6.0.0", b"P0000000A00S00I00000", version.as_bytes()]);
        let status = status.try_into().expect("25");
        SensorMap {
            identity, accelerometer, angles, battery, current, fsr, gyroscope, position, sonar, stiffness, temperature, touch,
            status,
        }
    }
}

proptest! {
    #[test]
    fn sensor_maps_round_trip(map in sensor_map()) {
        let bytes = map.encode();
        prop_assert_eq!(bytes.len(), SENSOR_MAP_BYTES);
        prop_assert_eq!(SensorMap::decode(&bytes), Ok((map, bytes.len())));
        for size in 0..bytes.len() {
            prop_assert_eq!(SensorMap::decode(&bytes[..size]), Err(Undecoded::Incomplete));
        }
    }

    #[test]
    fn actuator_maps_round_trip(position in array(), stiffness in array(), red in -1.0_f32..2.0) {
        let lights = Lights { chest: Light(red, 0.5, f32::NAN), ..Lights::default() };
        let (position, stiffness) = (Joints(position), Joints(stiffness));
        let bytes = ActuatorMap { position, stiffness, lights }.encode();
        prop_assert_eq!(ActuatorMap::decode(&bytes), Ok((Some(position), Some(stiffness), bytes.len())));
    }

    #[test]
    fn no_bytes_make_the_decoder_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        _ = SensorMap::decode(&bytes);
        _ = ActuatorMap::decode(&bytes);
    }
}

#[test]
fn keys_may_be_in_any_order_and_unknown() {
    let bytes = SensorMap::default().encode();
    // The last entry, `Status`, goes to the front, behind an unknown one with nested values.
    let status = bytes.windows(7).position(|window| window == b"\xa6Status").expect("it is there");
    let unknown = b"\xa3New\x82\xa1a\x92\xc3\xcd\x01\x02\xa1b\xc0";
    let moved = [&b"\x8e"[..], unknown, &bytes[status..], &bytes[1..status]].concat();
    assert_eq!(SensorMap::decode(&moved), Ok((SensorMap::default(), moved.len())));
}

#[test]
fn each_mistake_is_named() {
    let bytes = SensorMap::default().encode();
    let replaced = |old: &[u8], new: &[u8]| {
        let at = bytes.windows(old.len()).position(|window| window == old).expect("it is there");
        [&bytes[..at], new, &bytes[at + old.len()..]].concat()
    };
    for (map, mistake) in [
        (replaced(b"\xa3FSR", b"\xa3FSX"), Mistake::Missing { key: "FSR" }),
        (replaced(b"\xa8Position", b"\xa7Current"), Mistake::Twice { key: "Current" }),
        (replaced(b"\xa5Sonar\x92", b"\xa5Sonar\x93"), Mistake::Length { key: "Sonar", expected: 2, found: 3 }),
        (replaced(b"\xa5Sonar\x92\xca", b"\xa5Sonar\x92\x00"), Mistake::Type { key: "Sonar" }),
        (replaced(b"\xa5Sonar\x92\xca\x00", b"\xa5Sonar\x92\xca\xff"), Mistake::Missing { key: "none" }),
        (replaced(b"\x8d\xab", b"\x9d\xab"), Mistake::NoMap),
        (replaced(b"\x8d\xab", b"\x8d\xcb"), Mistake::NoKey),
    ] {
        match (SensorMap::decode(&map), mistake) {
            // A large number is no mistake.
            (Ok(_), Mistake::Missing { key: "none" }) => {}
            (found, mistake) => assert_eq!(found, Err(Undecoded::Wrong(mistake))),
        }
    }
    let map = SensorMap { sonar: [0.0, f32::NAN], ..SensorMap::default() };
    assert_eq!(SensorMap::decode(&map.encode()), Err(Undecoded::Wrong(Mistake::NotFinite { key: "Sonar" })));
}

/// Python's `msgpack` reads both maps as this crate writes them.
#[test]
fn encoding_equals_that_of_python() {
    let program = "import sys, msgpack\n\
                   data = sys.stdin.buffer.read()\n\
                   assert msgpack.packb(msgpack.unpackb(data), use_single_float=True) == data";
    let has_module = Command::new("python3").args(["-c", "import msgpack"]).output();
    if !has_module.is_ok_and(|output| output.status.success()) {
        eprintln!("skipped: python3 with msgpack is not installed");
        return;
    }
    let lights = Lights { chest: Light(0.0, 1.0, 0.0), ..Lights::default() };
    let actuators = ActuatorMap { position: Joints::all(0.1), stiffness: Joints::all(0.8), lights };
    for bytes in [SensorMap { position: [0.3; 25], ..SensorMap::default() }.encode(), actuators.encode()] {
        let mut python = Command::new("python3")
            .args(["-c", program])
            .stdin(std::process::Stdio::piped())
            .spawn()
            .expect("it was there");
        std::io::Write::write_all(&mut python.stdin.take().expect("a pipe"), &bytes).expect("it reads");
        assert!(python.wait().expect("it ends").success());
    }
}
