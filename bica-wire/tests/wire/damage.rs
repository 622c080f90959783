//! Damaged streams: no panic, no wrong message accepted, every loss counted.

use bica_wire::message::{ImageChunk, LinkStats};
use bica_wire::{Decoder, FromRobot, MAX_PACKET, ToRobot};
use proptest::prelude::*;

use crate::arbitrary::{decode, packets, to_robot};

static CONTENT: [u8; 1024] = {
    let mut content = [0; 1024];
    let mut index = 0;
    while index < content.len() {
        content[index] = (index * 7 % 256) as u8;
        index += 1;
    }
    content
};

fn messages() -> impl Strategy<Value = Vec<ToRobot<'static>>> {
    let message = (0..=CONTENT.len()).prop_flat_map(|length| to_robot(&CONTENT[..length]));
    prop::collection::vec(message, 1..8)
}

/// Ignores a message.
fn ignore(_: Option<ToRobot<'_>>, _: Option<FromRobot<'_>>) {}

proptest! {
    #[test]
    fn undamaged_messages_are_received_in_order(messages in messages()) {
        let (mut decoder, mut received) = (Decoder::new(), 0);
        let stream = packets(&messages).concat();
        decode(&mut decoder, &stream, |message, _| {
            assert_eq!(message.as_ref(), messages.get(received));
            received += 1;
        });
        prop_assert_eq!(received, messages.len());
        prop_assert_eq!(decoder.stats(), LinkStats { received: received as u32, damaged: 0, missing: 0 });
    }

    #[test]
    fn message_after_noise_is_received(noise in prop::collection::vec(any::<u8>(), 0..4000), message in to_robot(&CONTENT)) {
        let mut decoder = Decoder::new();
        prop_assert_eq!(decode(&mut decoder, &noise, ignore), 0, "noise has a valid CRC");
        decode(&mut decoder, &[0], ignore);
        let mut received = 0;
        decode(&mut decoder, &packets(std::slice::from_ref(&message)).concat(), |got, _| {
            assert_eq!(got.as_ref(), Some(&message));
            received += 1;
        });
        prop_assert_eq!(received, 1);
    }

    /// A CRC-32 detects every burst of up to four bytes. A zero byte in the burst splits the packet into two damaged ones.
    #[test]
    fn damaged_packet_is_dropped_alone(
        messages in messages(), which in any::<prop::sample::Index>(), place in any::<prop::sample::Index>(),
        burst in prop::collection::vec(1_u8.., 1..4),
    ) {
        let mut packets = packets(&messages);
        let which = which.index(packets.len());
        let length = packets[which].len() - 1;
        let place = place.index(length);
        for (byte, flip) in packets[which][..length].iter_mut().skip(place).zip(burst) {
            *byte ^= flip;
        }
        let zeros: u32 = packets[which][..length].iter().map(|byte| u32::from(*byte == 0)).sum();
        let mut intact = messages.clone();
        intact.remove(which);
        let (mut decoder, mut received) = (Decoder::new(), 0);
        decode(&mut decoder, &packets.concat(), |message, _| {
            assert_eq!(message.as_ref(), intact.get(received));
            received += 1;
        });
        prop_assert_eq!(received, intact.len());
        prop_assert!((1..=1 + zeros).contains(&decoder.stats().damaged), "{:?}", decoder.stats());
        let visible_gap = u32::from(which > 0 && which + 1 < messages.len());
        prop_assert_eq!(decoder.stats().missing, visible_gap);
    }

    #[test]
    fn lost_and_truncated_packets_are_counted(messages in messages(), fates in prop::collection::vec(0..3_u8, 8)) {
        let (mut stream, mut undamaged) = (Vec::new(), 0);
        for (packet, fate) in packets(&messages).iter().zip(&fates) {
            match fate {
                0 => { stream.extend_from_slice(packet); undamaged += 1; }
                1 => { stream.extend_from_slice(&packet[..packet.len() / 2]); stream.push(0); }
                _ => {}
            }
        }
        let mut decoder = Decoder::new();
        prop_assert_eq!(decode(&mut decoder, &stream, ignore), undamaged);
        let kept: Vec<usize> = (0..messages.len()).filter(|&index| fates[index] == 0).collect();
        let missing = kept.windows(2).map(|pair| pair[1] - pair[0] - 1).sum::<usize>();
        let cut = fates.iter().take(messages.len()).filter(|fate| **fate == 1).count();
        let expected = LinkStats { received: undamaged as u32, damaged: cut as u32, missing: missing as u32 };
        prop_assert_eq!(decoder.stats(), expected);
    }
}

#[test]
fn chunks_of_every_length_are_received() {
    // Content without zero bytes: COBS inserts an overhead byte after each run of 254 such bytes.
    let content = [255; 1024];
    for bytes in (0..=content.len()).map(|length| &content[..length]) {
        let message = ToRobot::ImageChunk(ImageChunk { image_id: u32::MAX, offset: 1, bytes });
        let mut equal = Vec::new();
        decode(&mut Decoder::new(), &packets(std::slice::from_ref(&message)).concat(), |got, _| {
            equal.push(got.as_ref() == Some(&message));
        });
        assert_eq!(equal, [true], "{} bytes", bytes.len());
    }
}

#[test]
fn overlong_packet_counts_as_one_damaged_packet() {
    let mut decoder = Decoder::<MAX_PACKET>::new();
    decode(&mut decoder, &[1; 3 * MAX_PACKET], ignore);
    decode(&mut decoder, &[0], ignore);
    assert_eq!(decoder.stats(), LinkStats { received: 0, damaged: 1, missing: 0 });
}

#[test]
fn restart_of_the_sender_counts_no_packet_as_missing() {
    let mut decoder = Decoder::<MAX_PACKET>::new();
    let old = packets(&vec![ToRobot::Describe; 40]).concat();
    decode(&mut decoder, &[old, packets(&[ToRobot::Describe]).concat()].concat(), ignore);
    assert_eq!(decoder.stats(), LinkStats { received: 41, damaged: 0, missing: 0 });
}
