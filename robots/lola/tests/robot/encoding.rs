//! Encoding of the maps.

use bica_lola::{ActuatorMap, Identity, Mistake, SENSOR_MAP_BYTES, SensorMap, Undecoded};
use bica_motion::joints::Joints;
use bica_motion::robot::{Light, Lights};
use bica_test_data::peer::Peer;
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

/// Values as the peer writes them: the bits of each number.
fn text(values: &mut [(&str, Vec<f32>)]) -> String {
    values.sort_unstable_by_key(|(key, _)| *key);
    let elements = |values: &[f32]| values.iter().map(|value| format!("{:08x}", value.to_bits())).collect::<Vec<_>>();
    values.iter().map(|(key, values)| format!("{key}={}", elements(values).join(","))).collect::<Vec<_>>().join(" ")
}

/// Our reading and writing of the sensor map of a peer.
fn sensors_again(bytes: &[u8]) -> (Vec<u8>, String) {
    let (map, size) = SensorMap::decode(bytes).expect("a map");
    assert_eq!(size, bytes.len());
    let floats = text(&mut [
        ("Accelerometer", map.accelerometer.to_vec()),
        ("Angles", map.angles.to_vec()),
        ("Battery", map.battery.to_vec()),
        ("Current", map.current.to_vec()),
        ("FSR", map.fsr.to_vec()),
        ("Gyroscope", map.gyroscope.to_vec()),
        ("Position", map.position.to_vec()),
        ("Sonar", map.sonar.to_vec()),
        ("Stiffness", map.stiffness.to_vec()),
        ("Temperature", map.temperature.to_vec()),
        ("Touch", map.touch.to_vec()),
    ]);
    let status = map.status.map(|status| status.to_string()).join(",");
    let others = format!(" RobotConfig={} Sonar=", map.identity.texts().join(","));
    // The order of the keys' names.
    let floats = floats.replace(" Sonar=", &others).replace(" Stiffness=", &format!(" Status={status} Stiffness="));
    (map.encode(), floats)
}

/// Our writing of what a peer's actuator map contains, of which the driver writes one colour for each eye.
fn actuators_again(bytes: &[u8], values: &str) -> (Vec<u8>, String) {
    let (position, stiffness, size) = ActuatorMap::decode(bytes).expect("a map");
    let (position, stiffness) = position.zip(stiffness).expect("both");
    assert_eq!(size, bytes.len());
    let given = |key: &str| {
        let found = values.split(' ').find_map(|part| part.strip_prefix(key)?.strip_prefix('='));
        let bits = |element| f32::from_bits(u32::from_str_radix(element, 16).expect("bits"));
        found.expect("the key").split(',').map(bits).collect::<Vec<_>>()
    };
    let bits = |values: &[f32]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&position.0), bits(&given("Position")));
    assert_eq!(bits(&stiffness.0), bits(&given("Stiffness")));
    let [chest, left_eye, right_eye] = [("Chest", 1), ("LEye", 8), ("REye", 8)].map(|(key, lights)| {
        let values = given(key);
        Light(values[0], values[lights], values[2 * lights])
    });
    let colours = |Light(red, green, blue): Light, lights| {
        [[red; 8], [green; 8], [blue; 8]].map(|it| it[..lights].to_vec()).concat()
    };
    let written = text(&mut [
        ("Position", position.0.to_vec()),
        ("Stiffness", stiffness.0.to_vec()),
        ("Chest", colours(chest, 1)),
        ("LEye", colours(left_eye, 8)),
        ("REye", colours(right_eye, 8)),
    ]);
    (ActuatorMap { position, stiffness, lights: Lights { chest, left_eye, right_eye } }.encode(), written)
}

/// Maps of Python's `msgpack` are read, and it reads those of this crate.
#[test]
fn peer_msgpack_agrees_in_every_field() {
    let Some(peer) = Peer::find("msgpack", concat!(env!("CARGO_MANIFEST_DIR"), "/maps.py")) else { return };
    peer.compare(|kind, bytes, values| {
        if kind == "actuators" {
            return actuators_again(bytes, values);
        }
        let (encoded, ours) = sensors_again(bytes);
        assert_eq!(ours, values);
        (encoded, ours)
    });
}
