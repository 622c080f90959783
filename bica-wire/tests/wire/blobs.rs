//! Messages whose large data is transferred separately.

use bica_core::{Blob, Format};
use bica_wire::blobs::{MIN_BLOB, decode, encode};
use bica_wire::messages_hash;
use postcard_schema::Schema;
use proptest::prelude::*;
use serde::{Deserialize, Serialize};

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
struct Sensors<'a> {
    number: u32,
    name: &'a str,
    #[serde(borrow)]
    image: Option<Blob<'a>>,
    ranges: [f32; 3],
    #[serde(borrow)]
    scan: Blob<'a>,
    last: bool,
}

/// A message with a part that follows a blob in the encoded form.
type Encoded = (Vec<u8>, Vec<u8>, Vec<usize>);

fn encoded(sensors: &Sensors<'_>) -> Encoded {
    let (mut blobs, mut places) = (Vec::new(), Vec::new());
    let take = |at, bytes: &[u8]| {
        blobs.extend_from_slice(bytes);
        places.push(at);
    };
    let message = encode(sensors, Vec::new(), take).expect("encodable");
    (message, blobs, places)
}

proptest! {
    #[test]
    fn messages_are_restored_and_large_data_is_separate(
        number in any::<u32>(), image in prop::option::of(0..400_usize), scan in 0..400_usize, name in 0..200_usize,
    ) {
        let (pixels, points, name) = (vec![1; image.unwrap_or(0)], vec![2; scan], "n".repeat(name));
        let format = Format::Gray8 { width: 7, height: 300 };
        let sensors = Sensors {
            number,
            name: &name,
            image: image.map(|_| Blob { bytes: &pixels, format, frame: "camera" }),
            ranges: [f32::MIN, 0.5, -0.0],
            scan: Blob { bytes: &points, format: Format::Other { media_type: "a/b" }, frame: "scanner" },
            last: true,
        };
        let (message, blobs, places) = encoded(&sensors);
        let large = [name.len(), pixels.len(), points.len()].map(|length| if length < MIN_BLOB { 0 } else { length });
        prop_assert_eq!(blobs.len(), large.iter().sum::<usize>());
        prop_assert_eq!(places.len(), large.iter().filter(|length| **length > 0).count());
        prop_assert_eq!(decode(&message, &blobs), Some(sensors.clone()));
        if let (Some(place), true) = (places.last(), scan >= MIN_BLOB) {
            let rest: (Format<'_>, &str) = postcard::take_from_bytes(&message[*place..]).expect("format and frame").0;
            prop_assert_eq!(rest, (sensors.scan.format, sensors.scan.frame));
        }
        let lost: Sensors<'_> = decode(&message, &[]).expect("whole but for its blobs");
        prop_assert_eq!((lost.number, lost.ranges, lost.last), (number, sensors.ranges, true));
        prop_assert_eq!(lost.scan.bytes.len(), if scan < MIN_BLOB { scan } else { 0 });
    }

    #[test]
    fn arbitrary_bytes_never_panic(message in prop::collection::vec(any::<u8>(), 0..300), blobs in 0..300_usize) {
        let _ = decode::<Sensors<'_>>(&message, &vec![0; blobs]);
    }
}

#[test]
fn a_message_that_is_cut_or_too_long_is_refused() {
    let blob = Blob { bytes: &[5; 200], format: Format::Points, frame: "" };
    let sensors = Sensors { number: 1, name: "", image: None, ranges: [0.0; 3], scan: blob, last: false };
    let (message, blobs, _) = encoded(&sensors);
    for length in 0..message.len() {
        assert_eq!(decode::<Sensors<'_>>(&message[..length], &blobs), None, "{length}");
    }
    assert_eq!(decode::<Sensors<'_>>(&[&message[..], &[0]].concat(), &blobs), None);
}

#[test]
fn a_field_of_another_name_changes_the_hash() {
    #[derive(Schema)]
    #[expect(dead_code, reason = "only its schema is used")]
    struct One {
        speed: f32,
    }
    #[derive(Schema)]
    #[expect(dead_code, reason = "only its schema is used")]
    struct Two {
        torque: f32,
    }
    let hashes = [messages_hash::<One, Two>(), messages_hash::<Two, One>(), messages_hash::<One, One>()];
    assert!(hashes[0] != hashes[1] && hashes[1] != hashes[2] && hashes[0] != hashes[2], "{hashes:?}");
}
