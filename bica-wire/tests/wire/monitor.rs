//! Messages between a robot and its monitors.

use bica_core::ComponentId;
use bica_wire::message::{
    Answer, AnswerResult, Change, ClockMode, ComponentCost, ComponentCosts, ComponentState, ComponentStates,
    ConditionState, Conditions, Hello, Hold, ImageChunk, LeaseAction, LogLine, LogSource, MAX_ARGUMENTS, MAX_BATCH,
    MAX_CONDITIONS, MAX_COSTS, MAX_OUTPUT_BYTES, MAX_STATES, MAX_TEXT_BYTES, MAX_VALUES, OutputSchema, OutputValue,
    ParamValues, RefusalCode, Request, SCENE_PART_BYTES, SCHEMA_PART_BYTES, SceneContent, SceneKind, ScenePart,
    Setting, Value, Watch, WatchOutput,
};
use bica_wire::{CHUNK_BYTES, Encoder, FromMonitor, FromRobot, MAX_PACKET, ToMonitor, ToMonitorExtra, ToRobot};
use proptest::prelude::*;

/// The value with the longest encoding.
const VALUE: Value = Value::U32(u32::MAX);

fn assert_to_fits(message: &ToMonitor<'_>) {
    let bytes = postcard::to_stdvec(message).expect("serializable");
    Encoder::new().encode(&FromRobot::Monitor(&bytes), &mut [0; MAX_PACKET]).expect("the packet fits");
}

fn assert_from_fits(message: &FromMonitor) {
    let bytes = postcard::to_stdvec(message).expect("serializable");
    Encoder::new().encode(&ToRobot::Monitor(&bytes), &mut [0; MAX_PACKET]).expect("the packet fits");
}

#[test]
fn largest_message_of_each_kind_fits_a_packet() {
    let (cycle, component, output) = (u64::MAX, u16::MAX, u16::MAX);
    let state = ComponentState { active: true, held: Hold::Latent, state: Some(u16::MAX), hz: Some(1.0) };
    let states = [state; MAX_STATES].into_iter().collect();
    assert_to_fits(&ToMonitor::Components(ComponentStates { cycle, first: u16::MAX, states }));
    let values = [Some(VALUE); MAX_VALUES].into_iter().collect();
    assert_to_fits(&ToMonitor::Params(ParamValues { cycle, component, first: u16::MAX, values }));
    let bytes = [1; MAX_OUTPUT_BYTES];
    assert_to_fits(&ToMonitor::Output(OutputValue { cycle, component, output, bytes: Some(&bytes) }));
    let bytes = [1; SCHEMA_PART_BYTES];
    assert_to_fits(&ToMonitor::OutputSchema(OutputSchema { component, output, last: true, bytes: &bytes }));
    let text = "x".repeat(MAX_TEXT_BYTES);
    assert_to_fits(&ToMonitor::Log(LogLine { time_us: u64::MAX, level: 4, source: LogSource::Robot, text: &text }));
    let refused = AnswerResult::Refused { code: RefusalCode::Tree, entry: u16::MAX, text: &text };
    let done = AnswerResult::Done { values: [VALUE; MAX_BATCH].into_iter().collect() };
    for result in [refused, done] {
        assert_to_fits(&ToMonitor::Answer(Answer { number: u32::MAX, cycle, arrived: cycle, result }));
    }
    for message in largest_extras() {
        let bytes = postcard::to_stdvec(&message).expect("serializable");
        let packet = Encoder::new().encode(&FromRobot::MonitorExtra(&bytes), &mut [0; MAX_PACKET]).map(<[u8]>::len);
        assert!(packet.is_ok(), "{message:?}");
    }
    let setting = Setting::new(ComponentId::new(usize::MAX), u16::MAX, VALUE);
    let batch = Change::Params([setting; MAX_BATCH].into_iter().collect());
    let arguments = [VALUE; MAX_ARGUMENTS].into_iter().collect();
    let call = Change::Modulate { component: ComponentId::new(usize::MAX), modulation: u16::MAX, arguments };
    for change in [batch, call] {
        assert_from_fits(&FromMonitor::Request(Request {
            number: u32::MAX,
            lease: u64::MAX,
            expires_us: u64::MAX,
            change,
        }));
    }
}

/// The largest message of each kind that only a computer offers.
fn largest_extras() -> Vec<ToMonitorExtra<'static>> {
    const CHUNK: &[u8] = &[1; CHUNK_BYTES];
    let (cycle, time_us, component, first) = (u64::MAX, u64::MAX, u16::MAX, u16::MAX);
    let condition = Some(ConditionState { holds: true, since_us: u64::MAX });
    let values = [condition; MAX_CONDITIONS].into_iter().collect();
    let cost = ComponentCost { runs: u32::MAX, mean_us: 1.0, max_us: 1.0, overruns: u32::MAX, overrun_us: u64::MAX };
    let costs = [cost; MAX_COSTS].into_iter().collect();
    let (scene, content) = (SceneKind::Truth, SceneContent::Values { time_us });
    let part = ScenePart { scene, number: u32::MAX, content, last: true, bytes: &[1; SCENE_PART_BYTES] };
    vec![
        ToMonitorExtra::Conditions(Conditions { cycle, time_us, component, first, values }),
        ToMonitorExtra::ComponentCosts(ComponentCosts { cycle, first, costs }),
        ToMonitorExtra::Scene(part),
        ToMonitorExtra::ImageChunk(ImageChunk { image_id: u32::MAX, offset: u32::MAX, bytes: CHUNK }),
    ]
}

#[test]
fn batch_longer_than_the_largest_is_refused() {
    // A request with 33 settings, written by hand: variant 5, number, lease, expiry, variant 2 of the change, length.
    let mut bytes = vec![5, 1, 1, 1, 2, MAX_BATCH as u8 + 1];
    bytes.extend([0, 0, 3, 1].repeat(MAX_BATCH + 1));
    assert!(postcard::from_bytes::<FromMonitor>(&bytes).is_err());
    bytes[5] -= 1;
    bytes.truncate(bytes.len() - 4);
    assert!(matches!(
        postcard::from_bytes(&bytes),
        Ok(FromMonitor::Request(Request { change: Change::Params(_), .. }))
    ));
}

#[test]
fn only_body_messages_count_as_sensor_values() {
    let hello = Hello { schema: 0, messages: 0, clock_mode: ClockMode::Lockstep, set_up: &[] };
    assert!(ToRobot::Hello(hello).is_from_body());
    let monitor = [ToRobot::Monitor(&[0]), ToRobot::MonitorExtra(&[0]), ToRobot::Describe, ToRobot::StackUsage];
    assert!(!monitor.iter().any(ToRobot::is_from_body));
}

proptest! {
    #[test]
    fn a_message_of_a_monitor_survives_the_wire(message in prop_oneof![watches(), leases(), requests()]) {
        let bytes = postcard::to_stdvec(&message).expect("serializable");
        prop_assert_eq!(postcard::from_bytes(&bytes), Ok(message));
    }

    #[test]
    fn arbitrary_bytes_are_a_message_or_none(bytes in prop::collection::vec(any::<u8>(), 0..1024)) {
        let _ = postcard::from_bytes::<FromMonitor>(&bytes);
        let _ = postcard::from_bytes::<ToMonitor<'_>>(&bytes);
    }
}

fn watches() -> impl Strategy<Value = FromMonitor> {
    (any::<u16>(), prop::option::of((any::<u16>(), any::<u16>()))).prop_map(|(every, output)| match output {
        None => FromMonitor::Watch(Watch { every }),
        Some((component, output)) => FromMonitor::WatchOutput(WatchOutput { component, output, every }),
    })
}

fn leases() -> impl Strategy<Value = FromMonitor> {
    (0..4_u8, any::<u64>()).prop_map(|(action, lease)| {
        FromMonitor::Lease(match action {
            0 => LeaseAction::Acquire,
            1 => LeaseAction::Take,
            2 => LeaseAction::Keep { lease },
            _ => LeaseAction::Return { lease },
        })
    })
}

fn requests() -> impl Strategy<Value = FromMonitor> {
    let value = prop_oneof![
        (-1e9_f32..1e9).prop_map(Value::F32),
        any::<i32>().prop_map(Value::I32),
        any::<u32>().prop_map(Value::U32),
        any::<bool>().prop_map(Value::Bool),
        any::<u32>().prop_map(Value::Choice),
    ];
    let holds = prop::sample::select(vec![Hold::Tree, Hold::Active, Hold::Latent]);
    let component = || any::<u16>().prop_map(|index| ComponentId::new(index.into()));
    let hold = (component(), holds).prop_map(|(component, hold)| Change::Hold { component, hold });
    let rate = (component(), prop::option::of(0.0_f32..1e6)).prop_map(|(component, hz)| Change::Rate { component, hz });
    let setting = (any::<u16>(), any::<u16>(), value.clone())
        .prop_map(|(component, index, value)| Setting::new(ComponentId::new(component.into()), index, value));
    let params =
        prop::collection::vec(setting, 0..=MAX_BATCH).prop_map(|batch| Change::Params(batch.into_iter().collect()));
    let arguments = prop::collection::vec(value, 0..=MAX_ARGUMENTS);
    let modulate = (component(), any::<u16>(), arguments).prop_map(|(component, modulation, arguments)| {
        Change::Modulate { component, modulation, arguments: arguments.into_iter().collect() }
    });
    let go = (component(), any::<u16>()).prop_map(|(component, state)| Change::Go { component, state });
    let change = prop_oneof![hold, rate, params, modulate, go];
    (any::<u32>(), any::<u64>(), any::<u64>(), change).prop_map(|(number, lease, expires_us, change)| {
        FromMonitor::Request(Request { number, lease, expires_us, change })
    })
}
