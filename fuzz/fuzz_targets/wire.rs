//! Decoding of arbitrary bytes from the link between robot and host: every packet is decoded or rejected, without panic.
#![no_main]

use bica_wire::{Decoder, Encoder, FromRobot, ImageBuffer, MAX_PACKET, ToRobot};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let (mut decoder, mut image) = (Decoder::<MAX_PACKET>::new(), ImageBuffer::<4096>::new());
    let mut buffer = [0; MAX_PACKET];
    // The bytes as a stream, and as the content of a packet with correct framing and CRC.
    let packet = Encoder::new().encode(&bytes, &mut buffer).map(<[u8]>::to_vec).unwrap_or_default();
    for byte in bytes.iter().copied().chain([0]).chain(packet) {
        let Some(packet) = decoder.push(byte) else { continue };
        if let Ok(ToRobot::ImageChunk(chunk)) = packet.message() {
            image.add(&chunk);
        }
        let _ = format!("{:?}", packet.message::<FromRobot<'_>>());
    }
});
