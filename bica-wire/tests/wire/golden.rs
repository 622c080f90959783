//! The bytes of packets, fixed: a change breaks the link to every robot in use, and must be stated here.
//!
//! The schema hash covers the names of types, variants and fields. It changed when these were renamed, and when the messages of
//! monitors were added; the bytes of the messages below did not.

use bica_field::GoalColour;
use bica_wire::message::{ClockMode, FaultInjection, Hello, ImageChunk, StackUsage};
use bica_wire::{Encoder, FromRobot, MAX_PACKET, SCHEMA, ToRobot};

/// Schema of these bytes.
const GOLDEN_SCHEMA: u64 = 0x6835_0a32_0564_dc8e;

fn bytes(message: &impl serde::Serialize) -> Vec<u8> {
    Encoder::new().encode(message, &mut [0; MAX_PACKET]).expect("the packet fits").to_vec()
}

#[test]
fn schema_hash_is_the_committed_one() {
    assert_eq!(SCHEMA, GOLDEN_SCHEMA, "a message type changed: {SCHEMA:#018x}");
}

#[test]
fn packets_have_the_committed_bytes() {
    let hello = Hello { schema: 0x0123_4567_89ab_cdef, clock_mode: ClockMode::Lockstep, attacks: GoalColour::SkyBlue };
    assert_eq!(bytes(&ToRobot::Describe), [1, 1, 6, 1, 132, 233, 70, 136, 0]);
    assert_eq!(
        bytes(&ToRobot::Hello(hello)),
        [1, 1, 1, 16, 239, 155, 175, 205, 248, 172, 209, 145, 1, 1, 1, 128, 92, 123, 97, 0]
    );
    assert_eq!(
        bytes(&ToRobot::ImageChunk(ImageChunk { image_id: 1, offset: 1024, bytes: &[0, 1, 255] })),
        [1, 1, 6, 2, 1, 128, 8, 3, 7, 1, 255, 132, 74, 180, 15, 0]
    );
    assert_eq!(
        bytes(&ToRobot::FaultInjection(FaultInjection::Delay { component: 7, ticks: 300 })),
        [1, 1, 2, 4, 8, 7, 172, 2, 242, 253, 31, 129, 0]
    );
    assert_eq!(
        bytes(&FromRobot::StackUsage(StackUsage { max_used: 4096, size: 65536 })),
        [1, 1, 11, 4, 128, 32, 128, 128, 4, 1, 197, 188, 50, 0]
    );
}
