//! Any bytes on the line between robot and host: whatever is heard can be read, or is refused.
#![no_main]

use bica_wire::{Frame, FromRobot, MAX_PACKET, Receiver, Sender, ToRobot};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let (mut receiver, mut frame) = (Receiver::<MAX_PACKET>::new(), Frame::<4096>::new());
    let mut room = [0; MAX_PACKET];
    // As they are, and as a packet whose length and sum are right.
    let packed = Sender::new().pack(&bytes, &mut room).map(<[u8]>::to_vec).unwrap_or_default();
    for byte in bytes.iter().copied().chain([0]).chain(packed) {
        let Some(heard) = receiver.push(byte) else { continue };
        if let Ok(ToRobot::Chunk(chunk)) = heard.read() {
            frame.add(&chunk);
        }
        let _ = format!("{:?}", heard.read::<FromRobot<'_>>());
    }
});
