//! The bytes themselves: who changes one of these breaks every robot out there, and has to say so here.

use bica_field::GoalColour;
use bica_wire::message::{Chunk, Hello, Pace, Stack, Trial};
use bica_wire::{FromRobot, MAX_PACKET, SCHEMA, Sender, ToRobot};

/// The schema of these bytes.
const GOLDEN: u64 = 0xdac9_1218_8cf8_d70e;

fn bytes(message: &impl serde::Serialize) -> Vec<u8> {
    Sender::new().pack(message, &mut [0; MAX_PACKET]).expect("it fits").to_vec()
}

#[test]
fn the_schema_is_the_one_that_these_bytes_belong_to() {
    assert_eq!(SCHEMA, GOLDEN, "a message changed: {SCHEMA:#018x}");
}

#[test]
fn packets_are_these_bytes() {
    let hello = Hello { schema: 0x0123_4567_89ab_cdef, pace: Pace::Lockstep, attack: GoalColour::SkyBlue };
    assert_eq!(bytes(&ToRobot::Describe), [1, 1, 6, 1, 132, 233, 70, 136, 0]);
    assert_eq!(
        bytes(&ToRobot::Hello(hello)),
        [1, 1, 1, 16, 239, 155, 175, 205, 248, 172, 209, 145, 1, 1, 1, 128, 92, 123, 97, 0]
    );
    assert_eq!(
        bytes(&ToRobot::Chunk(Chunk { image: 1, at: 1024, bytes: &[0, 1, 255] })),
        [1, 1, 6, 2, 1, 128, 8, 3, 7, 1, 255, 132, 74, 180, 15, 0]
    );
    assert_eq!(
        bytes(&ToRobot::Trial(Trial::Slow { component: 7, ticks: 300 })),
        [1, 1, 2, 4, 8, 7, 172, 2, 242, 253, 31, 129, 0]
    );
    assert_eq!(
        bytes(&FromRobot::Stack(Stack { deepest: 4096, room: 65536 })),
        [1, 1, 11, 4, 128, 32, 128, 128, 4, 1, 197, 188, 50, 0]
    );
}
