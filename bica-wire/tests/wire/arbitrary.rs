//! Strategies for arbitrary messages, and encoding and decoding of sequences of them.

use bica_wire::message::{BlobsInfo, ClockMode, FaultInjection, Hello, ImageChunk, Sensors};
use bica_wire::{Decoder, Encoder, FromRobot, MAX_PACKET, ToRobot};
use proptest::prelude::*;

/// Any message of the host; `bytes` are the content of an image chunk.
pub(crate) fn to_robot(bytes: &'static [u8]) -> BoxedStrategy<ToRobot<'static>> {
    let hello = (any::<u64>(), any::<u64>(), any::<bool>()).prop_map(move |(schema, messages, free_running)| {
        let clock_mode = if free_running { ClockMode::FreeRunning } else { ClockMode::Lockstep };
        ToRobot::Hello(Hello { schema, messages, clock_mode, set_up: &bytes[..bytes.len().min(8)] })
    });
    let chunk = (any::<u32>(), any::<u32>())
        .prop_map(move |(image_id, offset)| ToRobot::ImageChunk(ImageChunk { image_id, offset, bytes }));
    let delay = (any::<u8>(), any::<u32>()).prop_map(|(component, ticks)| FaultInjection::Delay { component, ticks });
    let panic = any::<u8>().prop_map(|component| FaultInjection::Panic { component });
    let fault = prop_oneof![delay, panic].prop_map(ToRobot::FaultInjection);
    let sensors = sensors(bytes).prop_map(ToRobot::Sensors);
    let monitor = [ToRobot::Monitor(bytes), ToRobot::MonitorExtra(bytes)];
    let empty = prop::sample::select([[ToRobot::Describe, ToRobot::StackUsage], monitor].concat());
    prop_oneof![empty, hello, chunk, fault, sensors].boxed()
}

fn sensors(values: &'static [u8]) -> impl Strategy<Value = Sensors<'static>> {
    let blobs = (any::<u32>(), any::<u32>()).prop_map(|(id, bytes)| BlobsInfo { id, bytes });
    (any::<u64>(), prop::option::of(blobs)).prop_map(move |(time_us, blobs)| Sensors { time_us, blobs, values })
}

/// Encodes messages as packets with consecutive sequence numbers.
pub(crate) fn packets(messages: &[ToRobot<'_>]) -> Vec<Vec<u8>> {
    let mut encoder = Encoder::new();
    let mut buffer = [0; MAX_PACKET];
    messages.iter().map(|message| encoder.encode(message, &mut buffer).expect("the packet fits").to_vec()).collect()
}

/// Decodes a stream, passes each packet's message to `observe`, and returns the number of packets.
pub(crate) fn decode(
    decoder: &mut Decoder<MAX_PACKET>,
    bytes: &[u8],
    mut observe: impl FnMut(Option<ToRobot<'_>>, Option<FromRobot<'_>>),
) -> usize {
    let mut received = 0;
    for &byte in bytes {
        if let Some(packet) = decoder.push(byte) {
            received += 1;
            observe(packet.message().ok(), packet.message().ok());
        }
    }
    received
}
