//! Messages between a robot and its monitors.

use bica_field::GoalColour;
use bica_wire::message::{
    Answer, AnswerResult, Change, ClockMode, ComponentState, ComponentStates, Hello, Hold, InfoSchema, InfoValue,
    LeaseAction, LogLine, MAX_ARGUMENTS, MAX_BATCH, MAX_INFO_BYTES, MAX_STATES, MAX_TEXT_BYTES, MAX_VALUES,
    ParamValues, RefusalCode, Request, SCHEMA_PART_BYTES, Setting, Value, Watch,
};
use bica_wire::{Encoder, FromRobot, MAX_PACKET, ToRobot};

/// The value with the longest encoding.
const VALUE: Value = Value::U32(u32::MAX);

fn assert_fits(message: &impl serde::Serialize) {
    Encoder::new().encode(message, &mut [0; MAX_PACKET]).expect("the packet fits");
}

#[test]
fn the_largest_message_of_each_kind_fits_into_a_packet() {
    let (cycle, component, info) = (u64::MAX, u16::MAX, u16::MAX);
    let state = ComponentState { active: true, held: Hold::Latent, state: Some(u16::MAX), hz: Some(1.0) };
    let states = [state; MAX_STATES].into_iter().collect();
    assert_fits(&FromRobot::Components(ComponentStates { cycle, first: u16::MAX, states }));
    let values = [Some(VALUE); MAX_VALUES].into_iter().collect();
    assert_fits(&FromRobot::Params(ParamValues { cycle, component, first: u16::MAX, values }));
    let bytes = [1; MAX_INFO_BYTES];
    assert_fits(&FromRobot::Info(InfoValue { cycle, component, info, bytes: Some(&bytes) }));
    let bytes = [1; SCHEMA_PART_BYTES];
    assert_fits(&FromRobot::InfoSchema(InfoSchema { component, info, last: true, bytes: &bytes }));
    let text = "x".repeat(MAX_TEXT_BYTES);
    assert_fits(&FromRobot::Log(LogLine { time_us: u64::MAX, level: 4, text: &text }));
    let refused = AnswerResult::Refused { code: RefusalCode::Tree, entry: u16::MAX, text: &text };
    let done = AnswerResult::Done { values: [VALUE; MAX_BATCH].into_iter().collect() };
    for result in [refused, done] {
        assert_fits(&FromRobot::Answer(Answer { number: u32::MAX, cycle, arrived: cycle, result }));
    }
    let setting = Setting { component, index: u16::MAX, value: VALUE };
    let batch = Change::Params([setting; MAX_BATCH].into_iter().collect());
    let arguments = [VALUE; MAX_ARGUMENTS].into_iter().collect();
    let call = Change::Modulate { component, modulation: u16::MAX, arguments };
    for change in [batch, call] {
        assert_fits(&ToRobot::Request(Request { number: u32::MAX, lease: u32::MAX, expires_us: u64::MAX, change }));
    }
}

#[test]
fn a_batch_that_is_longer_than_the_largest_is_no_message() {
    // A request with 33 settings, written by hand: variant 11, number, lease, expiry, variant 2 of the change, length.
    let mut bytes = vec![11, 1, 1, 1, 2, MAX_BATCH as u8 + 1];
    bytes.extend([0, 0, 3, 1].repeat(MAX_BATCH + 1));
    assert!(postcard::from_bytes::<ToRobot<'_>>(&bytes).is_err());
    bytes[5] -= 1;
    bytes.truncate(bytes.len() - 4);
    assert!(matches!(postcard::from_bytes(&bytes), Ok(ToRobot::Request(Request { change: Change::Params(_), .. }))));
}

#[test]
fn only_messages_of_the_body_show_that_sensor_values_arrive() {
    let hello = Hello { schema: 0, clock_mode: ClockMode::Lockstep, attacks: GoalColour::Yellow };
    assert!(ToRobot::Hello(hello).is_from_body());
    let monitor = [
        ToRobot::Attach,
        ToRobot::Describe,
        ToRobot::StackUsage,
        ToRobot::ReadParams,
        ToRobot::Watch(Watch { every: 1 }),
        ToRobot::Lease(LeaseAction::Keep { lease: 1 }),
    ];
    assert!(!monitor.iter().any(ToRobot::is_from_body));
}
