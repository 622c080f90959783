//! Strategies for arbitrary messages, and encoding and decoding of sequences of them.

use bica_field::GoalColour;
use bica_wire::message::{
    Change, ClockMode, FaultInjection, Hello, Hold, ImageChunk, ImageInfo, LeaseAction, MAX_ARGUMENTS, MAX_BATCH,
    Request, Sensors, Setting, Value, Watch, WatchInfo,
};
use bica_wire::{Decoder, Encoder, FromRobot, MAX_PACKET, ToRobot};
use proptest::prelude::*;

/// Any message of the host; `bytes` are the content of an image chunk.
pub(crate) fn to_robot(bytes: &'static [u8]) -> BoxedStrategy<ToRobot<'static>> {
    let hello = (any::<u64>(), any::<bool>(), any::<bool>()).prop_map(|(schema, free_running, yellow)| {
        let clock_mode = if free_running { ClockMode::FreeRunning } else { ClockMode::Lockstep };
        let attacks = if yellow { GoalColour::Yellow } else { GoalColour::SkyBlue };
        ToRobot::Hello(Hello { schema, clock_mode, attacks })
    });
    let chunk = (any::<u32>(), any::<u32>())
        .prop_map(move |(image_id, offset)| ToRobot::ImageChunk(ImageChunk { image_id, offset, bytes }));
    let delay = (any::<u8>(), any::<u32>()).prop_map(|(component, ticks)| FaultInjection::Delay { component, ticks });
    let panic = any::<u8>().prop_map(|component| FaultInjection::Panic { component });
    let fault = prop_oneof![delay, panic].prop_map(ToRobot::FaultInjection);
    let sensors = sensors().prop_map(ToRobot::Sensors);
    let empty =
        prop::sample::select(vec![ToRobot::Describe, ToRobot::StackUsage, ToRobot::Attach, ToRobot::ReadParams]);
    prop_oneof![empty, hello, chunk, fault, sensors, watches(), leases(), requests()].boxed()
}

fn watches() -> impl Strategy<Value = ToRobot<'static>> {
    (any::<u16>(), prop::option::of((any::<u16>(), any::<u16>()))).prop_map(|(every, info)| match info {
        None => ToRobot::Watch(Watch { every }),
        Some((component, info)) => ToRobot::WatchInfo(WatchInfo { component, info, every }),
    })
}

fn leases() -> impl Strategy<Value = ToRobot<'static>> {
    (0..4_u8, any::<u32>()).prop_map(|(action, lease)| {
        ToRobot::Lease(match action {
            0 => LeaseAction::Acquire,
            1 => LeaseAction::Take,
            2 => LeaseAction::Keep { lease },
            _ => LeaseAction::Return { lease },
        })
    })
}

fn requests() -> impl Strategy<Value = ToRobot<'static>> {
    let value = prop_oneof![
        (-1e9_f32..1e9).prop_map(Value::F32),
        any::<i32>().prop_map(Value::I32),
        any::<u32>().prop_map(Value::U32),
        any::<bool>().prop_map(Value::Bool),
        any::<u32>().prop_map(Value::Choice),
    ];
    let holds = prop::sample::select(vec![Hold::Tree, Hold::Active, Hold::Latent]);
    let hold = (any::<u16>(), holds).prop_map(|(component, hold)| Change::Hold { component, hold });
    let rate = (any::<u16>(), 0.0_f32..1e6).prop_map(|(component, hz)| Change::Rate { component, hz });
    let setting = (any::<u16>(), any::<u16>(), value.clone()).prop_map(|(component, index, value)| Setting {
        component,
        index,
        value,
    });
    let params =
        prop::collection::vec(setting, 0..=MAX_BATCH).prop_map(|batch| Change::Params(batch.into_iter().collect()));
    let arguments = prop::collection::vec(value, 0..=MAX_ARGUMENTS);
    let modulate = (any::<u16>(), any::<u16>(), arguments).prop_map(|(component, modulation, arguments)| {
        Change::Modulate { component, modulation, arguments: arguments.into_iter().collect() }
    });
    let change = prop_oneof![hold, rate, params, modulate];
    (any::<u32>(), any::<u32>(), any::<u64>(), change)
        .prop_map(|(number, lease, expires_us, change)| ToRobot::Request(Request { number, lease, expires_us, change }))
}

fn sensors() -> impl Strategy<Value = Sensors> {
    let image = (any::<u32>(), any::<bool>(), any::<u16>(), any::<u16>())
        .prop_map(|(id, bottom_camera, width, height)| ImageInfo { id, bottom_camera, width, height });
    let floats = || prop::array::uniform25(-1e6_f32..1e6);
    let joints = [floats(), floats(), floats()];
    (any::<u64>(), joints, prop::array::uniform8(any::<i16>()), any::<[bool; 3]>(), prop::option::of(image)).prop_map(
        |(time_us, [angles, temperatures, currents], small, buttons, image)| Sensors {
            time_us,
            angles,
            temperatures,
            currents,
            inertial: small.map(f32::from),
            feet: small.map(f32::from),
            buttons,
            image,
        },
    )
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
