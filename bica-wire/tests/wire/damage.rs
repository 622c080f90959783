//! Whatever happens to the bytes: no panic, nothing wrong accepted, everything counted.

use bica_wire::{Losses, MAX_PACKET, Receiver, ToRobot};
use proptest::prelude::*;

use crate::arbitrary::{hear, packets, to_robot};

static PIECE: [u8; 1024] = {
    let mut piece = [0; 1024];
    let mut index = 0;
    while index < piece.len() {
        piece[index] = (index * 7 % 256) as u8;
        index += 1;
    }
    piece
};

fn messages() -> impl Strategy<Value = Vec<ToRobot<'static>>> {
    let message = (0..=PIECE.len()).prop_flat_map(|length| to_robot(&PIECE[..length]));
    prop::collection::vec(message, 1..8)
}

/// Says nothing when shown a message.
fn silent(_: Option<ToRobot<'_>>, _: Option<bica_wire::FromRobot<'_>>) {}

proptest! {
    #[test]
    fn what_is_sent_is_heard(messages in messages()) {
        let (mut receiver, mut heard) = (Receiver::new(), 0);
        let stream = packets(&messages).concat();
        hear(&mut receiver, &stream, |message, _| {
            assert_eq!(message.as_ref(), messages.get(heard));
            heard += 1;
        });
        prop_assert_eq!(heard, messages.len());
        prop_assert_eq!(receiver.losses(), Losses { whole: heard as u32, damaged: 0, missing: 0 });
    }

    #[test]
    fn any_bytes_are_survived(noise in prop::collection::vec(any::<u8>(), 0..4000), message in to_robot(&PIECE)) {
        let mut receiver = Receiver::new();
        prop_assert_eq!(hear(&mut receiver, &noise, silent), 0, "noise passed the check");
        hear(&mut receiver, &[0], silent);
        let mut heard = 0;
        hear(&mut receiver, &packets(std::slice::from_ref(&message)).concat(), |got, _| {
            assert_eq!(got.as_ref(), Some(&message));
            heard += 1;
        });
        prop_assert_eq!(heard, 1);
    }

    /// Bursts of up to four bytes are noticed without exception; a zero among them makes two damaged packets of one.
    #[test]
    fn a_damaged_packet_is_noticed_and_its_neighbours_live(
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
        let (mut receiver, mut heard) = (Receiver::new(), Vec::new());
        hear(&mut receiver, &packets.concat(), |message, _| {
            heard.push(messages.iter().position(|sent| Some(sent) == message.as_ref()).expect("one that was sent"));
        });
        prop_assert_eq!(heard.len(), messages.len() - 1);
        prop_assert!(receiver.losses().damaged >= 1);
        let seen_gap = u32::from(which > 0 && which + 1 < messages.len());
        prop_assert_eq!(receiver.losses().missing, seen_gap);
    }

    #[test]
    fn lost_and_cut_packets_are_counted(messages in messages(), fates in prop::collection::vec(0..3_u8, 8)) {
        let (mut stream, mut whole) = (Vec::new(), 0);
        for (packet, fate) in packets(&messages).iter().zip(&fates) {
            match fate {
                0 => { stream.extend_from_slice(packet); whole += 1; }
                1 => { stream.extend_from_slice(&packet[..packet.len() / 2]); stream.push(0); }
                _ => {}
            }
        }
        let mut receiver = Receiver::new();
        prop_assert_eq!(hear(&mut receiver, &stream, silent), whole);
        let kept: Vec<usize> = (0..messages.len()).filter(|&index| fates[index] == 0).collect();
        let missing = kept.windows(2).map(|pair| pair[1] - pair[0] - 1).sum::<usize>();
        let cut = fates.iter().take(messages.len()).filter(|fate| **fate == 1).count();
        let expected = Losses { whole: whole as u32, damaged: cut as u32, missing: missing as u32 };
        prop_assert_eq!(receiver.losses(), expected);
    }
}

#[test]
fn pieces_of_every_length_are_heard() {
    // Without a zero in it: where a stretch of 254 bytes ends, the stuffing changes.
    let piece = [255; 1024];
    for bytes in (0..=piece.len()).map(|length| &piece[..length]) {
        let message = ToRobot::Chunk(bica_wire::message::Chunk { image: u32::MAX, at: 1, bytes });
        let mut heard = Vec::new();
        hear(&mut Receiver::new(), &packets(std::slice::from_ref(&message)).concat(), |got, _| {
            heard.push(got.as_ref() == Some(&message));
        });
        assert_eq!(heard, [true], "{} bytes", bytes.len());
    }
}

#[test]
fn more_than_a_packet_without_an_end_is_one_damaged_packet() {
    let mut receiver = Receiver::<MAX_PACKET>::new();
    hear(&mut receiver, &[1; 3 * MAX_PACKET], silent);
    hear(&mut receiver, &[0], silent);
    assert_eq!(receiver.losses(), Losses { whole: 0, damaged: 1, missing: 0 });
}

#[test]
fn an_end_that_begins_anew_counts_nothing_missing() {
    let mut receiver = Receiver::<MAX_PACKET>::new();
    let old = packets(&vec![ToRobot::Describe; 40]).concat();
    hear(&mut receiver, &[old, packets(&[ToRobot::Describe]).concat()].concat(), silent);
    assert_eq!(receiver.losses(), Losses { whole: 41, damaged: 0, missing: 0 });
}
