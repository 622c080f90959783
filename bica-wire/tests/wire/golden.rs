//! The bytes of packets, fixed: a change breaks the link to every robot in use, and must be stated here.
//!
//! The schema hash covers the names of types, variants and fields. It changed when these were renamed, and when the messages of
//! monitors were added; the bytes of the messages below did not. Then `Attached` got what the robot offers, and later the ball of a
//! simulated world could be placed, and `Identity` got the size of the largest image. Then numbers of leases got 64 bits, and outputs
//! their frames. Then any world could show its scenery and true state, images got the names of their cameras, and runs a result. Then
//! lines of the log got their source, and descriptions the schemas of the robot's messages. Then modulations said whether they
//! stop the robot, and transitions what they carry. Then links got their roles, transitions the results and parameters for
//! which they wait, and components their work. Then components got types beside their names, and
//! machines could go to states by request, and descriptions got ages, outcomes and writers. Then modulations said whether they
//! drive the robot.

use bica_core::ComponentId;
use bica_core::visual::SceneItem;
use bica_wire::message::{
    Answer, AnswerResult, Attached, BlobsInfo, Change, ClockMode, Command, ComponentCost, ComponentCosts,
    ComponentState, ComponentStates, ConditionState, Conditions, Costs, CycleInfo, ExtraKind, FaultInjection, Hello,
    Hold, Identity, ImageChunk, ImageHead, LeaseAction, LeaseState, LogLine, LogSource, Offers, OutputValue,
    RefusalCode, Request, SceneContent, SceneDeclaration, SceneKind, ScenePart, Sensors, Setting, StackUsage, Value,
    Watch, WatchOutput, WorldChange, WorldRequest, WorldState,
};
use bica_wire::{
    Decoder, Encoder, FromMonitor, FromMonitorExtra, FromRobot, MAX_PACKET, SCHEMA, ToMonitor, ToMonitorExtra, ToRobot,
};

/// Schema of these bytes.
const GOLDEN_SCHEMA: u64 = 0x5f6b_d9a4_9eba_9de0;

fn bytes(message: &impl serde::Serialize) -> Vec<u8> {
    Encoder::new().encode(message, &mut [0; MAX_PACKET]).expect("the packet fits").to_vec()
}

#[test]
fn schema_hash_is_the_committed_one() {
    assert_eq!(SCHEMA, GOLDEN_SCHEMA, "a message type changed: {SCHEMA:#018x}");
}

#[test]
fn packets_have_the_committed_bytes() {
    let hello = Hello { schema: 0x0123_4567_89ab_cdef, messages: 1, clock_mode: ClockMode::Lockstep, set_up: &[1] };
    assert_eq!(bytes(&ToRobot::Describe), [1, 1, 6, 1, 132, 233, 70, 136, 0]);
    assert_eq!(
        bytes(&ToRobot::Hello(hello)),
        [1, 1, 1, 18, 239, 155, 175, 205, 248, 172, 209, 145, 1, 1, 1, 1, 1, 199, 247, 155, 118, 0]
    );
    assert_eq!(
        bytes(&ToRobot::ImageChunk(ImageChunk { image_id: 1, offset: 1024, bytes: &[0, 1, 255] })),
        [1, 1, 6, 2, 1, 128, 8, 3, 7, 1, 255, 132, 74, 180, 15, 0]
    );
    let sensors = Sensors { time_us: 300, blobs: Some(BlobsInfo { id: 1, bytes: 1027 }), values: &[7, 8] };
    assert_eq!(postcard::to_stdvec(&ToRobot::Sensors(sensors)), Ok(vec![3, 172, 2, 1, 1, 131, 8, 2, 7, 8]));
    let command = Command { time_us: 300, values: &[7, 8] };
    assert_eq!(postcard::to_stdvec(&FromRobot::Command(command)), Ok(vec![2, 172, 2, 2, 7, 8]));
    assert_eq!(
        bytes(&ToRobot::FaultInjection(FaultInjection::Delay { component: 7, ticks: 300 })),
        [1, 1, 2, 4, 8, 7, 172, 2, 242, 253, 31, 129, 0]
    );
    assert_eq!(
        bytes(&FromRobot::StackUsage(StackUsage { max_used: 4096, size: 65536 })),
        [1, 1, 11, 4, 128, 32, 128, 128, 4, 1, 197, 188, 50, 0]
    );
}

#[test]
fn identity_of_another_version_can_be_read() {
    let schema = |bytes: &[u8]| {
        let mut decoder = Decoder::<MAX_PACKET>::new();
        bytes.iter().find_map(|&byte| decoder.push(byte).map(|packet| packet.identity_schema())).expect("a packet")
    };
    assert_eq!(schema(&bytes(&(0_u32, 300_u64))), Some(300), "fewer fields");
    assert_eq!(schema(&bytes(&(0_u32, u64::MAX, "Forward", [1.5_f32; 8]))), Some(u64::MAX), "other fields");
    assert_eq!(schema(&bytes(&(1_u32, 300_u64))), None, "another message");
    assert_eq!(schema(&bytes(&0_u8)), None, "no schema");
    let identity = Identity {
        schema: 300,
        messages: 400,
        name: "Forward",
        cycle_hz: 100.0,
        components: 34,
        counter_hz: 1_000_000,
        image_bytes: 38_400,
        restarts: 0,
        last_panic: "",
    };
    assert_eq!(schema(&bytes(&FromRobot::Identity(identity))), Some(300));
}

/// The bytes as `docs/link.md` states them.
#[test]
fn messages_of_monitors_have_the_documented_bytes() {
    let from = |message: &FromMonitor| postcard::to_stdvec(message).expect("serializable");
    assert_eq!(from(&FromMonitor::Attach), [0]);
    assert_eq!(from(&FromMonitor::Watch(Watch { every: 300 })), [1, 172, 2]);
    assert_eq!(from(&FromMonitor::WatchOutput(WatchOutput { component: 1, output: 2, every: 3 })), [2, 1, 2, 3]);
    assert_eq!(from(&FromMonitor::ReadParams), [3]);
    assert_eq!(from(&FromMonitor::Lease(LeaseAction::Take)), [4, 1]);
    assert_eq!(from(&FromMonitor::Lease(LeaseAction::Keep { lease: 128 })), [4, 2, 128, 1]);
    let request = |change| from(&FromMonitor::Request(Request { number: 1, lease: 2, expires_us: 3, change }));
    assert_eq!(request(Change::Hold { component: ComponentId::new(4), hold: Hold::Latent }), [5, 1, 2, 3, 0, 4, 2]);
    assert_eq!(
        request(Change::Rate { component: ComponentId::new(4), hz: Some(1.0) }),
        [5, 1, 2, 3, 1, 4, 1, 0, 0, 128, 63]
    );
    let setting = Setting::new(ComponentId::new(4), 5, Value::Bool(true));
    assert_eq!(request(Change::Params([setting].into_iter().collect())), [5, 1, 2, 3, 2, 1, 4, 5, 3, 1]);
    let arguments = [Value::I32(-1), Value::Choice(6)].into_iter().collect();
    let call = Change::Modulate { component: ComponentId::new(4), modulation: 5, arguments };
    assert_eq!(request(call), [5, 1, 2, 3, 3, 4, 5, 2, 1, 1, 4, 6]);
    let arguments = [Value::Bool(true)].into_iter().collect();
    assert_eq!(request(Change::World { action: 5, arguments }), [5, 1, 2, 3, 4, 5, 1, 3, 1]);
    assert_eq!(request(Change::Go { component: ComponentId::new(4), state: 300 }), [5, 1, 2, 3, 5, 4, 172, 2]);

    let to = |message: &ToMonitor<'_>| postcard::to_stdvec(message).expect("serializable");
    let info = CycleInfo { cycle: 1, time_us: 2, sensed: 3, images: 4, overruns: 5 };
    assert_eq!(to(&ToMonitor::Cycle(info)), [1, 1, 2, 3, 4, 5]);
    let state = ComponentState { active: true, held: Hold::Active, state: Some(7), hz: None };
    let states = [state].into_iter().collect();
    let states = ComponentStates { cycle: 1, first: 2, states };
    assert_eq!(to(&ToMonitor::Components(states)), [2, 1, 2, 1, 1, 1, 1, 7, 0]);
    let value = OutputValue { cycle: 1, component: 2, output: 3, bytes: Some(&[9]) };
    assert_eq!(to(&ToMonitor::Output(value)), [3, 1, 2, 3, 1, 1, 9]);
    let lease = LeaseState { lease: 1, owned: true, yours: false, time_us: 2 };
    assert_eq!(to(&ToMonitor::Lease(lease)), [6, 1, 1, 0, 2]);
    let result = AnswerResult::Refused { code: RefusalCode::Tree, entry: 4, text: "a" };
    assert_eq!(
        to(&ToMonitor::Answer(Answer { number: 1, cycle: 2, arrived: 3, result })),
        [7, 1, 2, 3, 1, 2, 4, 1, 97]
    );
    assert_eq!(
        to(&ToMonitor::Log(LogLine { time_us: 1, level: 2, source: LogSource::Operator, text: "a" })),
        [8, 1, 2, 2, 1, 97]
    );
    assert_eq!(to(&ToMonitor::Closing { reason: "a" }), [9, 1, 97]);
    assert_eq!(postcard::to_stdvec(&ToRobot::Monitor(&[0])), Ok(vec![6, 1, 0]));
    assert_eq!(postcard::to_stdvec(&FromRobot::Monitor(&[0])), Ok(vec![5, 1, 0]));
}

/// The bytes as `docs/link.md` states them.
#[test]
fn computer_messages_have_the_documented_bytes() {
    let (offers, name) = (Offers::PAUSE.with(Offers::IMAGES), "a");
    let attached = Attached { schema: 1, tree_hash: 2, name, realtime: true, silence_ms: 3, offers };
    assert_eq!(postcard::to_stdvec(&ToMonitor::Attached(attached)), Ok(vec![0, 1, 2, 1, 97, 1, 3, 34]));

    let from = |message: &FromMonitorExtra| postcard::to_stdvec(message).expect("serializable");
    let watch = |kind| from(&FromMonitorExtra::Watch { kind, every: 9 });
    assert_eq!(watch(ExtraKind::Conditions { component: 4 }), [0, 0, 4, 9]);
    assert_eq!(watch(ExtraKind::Costs), [0, 1, 9]);
    assert_eq!(watch(ExtraKind::Truth), [0, 2, 9]);
    assert_eq!(watch(ExtraKind::Images), [0, 3, 9]);
    assert_eq!(from(&FromMonitorExtra::ImageTaken { number: 5 }), [1, 5]);
    let world = |change| from(&FromMonitorExtra::World(WorldRequest { number: 1, lease: 2, expires_us: 3, change }));
    assert_eq!(world(WorldChange::Pause), [2, 1, 2, 3, 0]);
    assert_eq!(world(WorldChange::Resume), [2, 1, 2, 3, 1]);
    assert_eq!(world(WorldChange::Step { cycles: 7 }), [2, 1, 2, 3, 2, 7]);

    let to = |message: &ToMonitorExtra<'_>| postcard::to_stdvec(message).expect("serializable");
    let values = [None, Some(ConditionState { holds: true, since_us: 5 })].into_iter().collect();
    let conditions = Conditions { cycle: 1, time_us: 2, component: 3, first: 4, values };
    assert_eq!(to(&ToMonitorExtra::Conditions(conditions)), [0, 1, 2, 3, 4, 2, 0, 1, 1, 5]);
    let costs = Costs { cycle: 1, time_us: 2, window_us: 3, mean_us: 0.0, max_us: 1.0, worst_us: 4 };
    assert_eq!(to(&ToMonitorExtra::Costs(costs)), [1, 1, 2, 3, 0, 0, 0, 0, 0, 0, 128, 63, 4]);
    let cost = ComponentCost { runs: 1, mean_us: 0.0, max_us: 1.0, overruns: 2, overrun_us: 3 };
    let costs = ComponentCosts { cycle: 1, first: 2, costs: [cost].into_iter().collect() };
    assert_eq!(to(&ToMonitorExtra::ComponentCosts(costs)), [2, 1, 2, 1, 1, 0, 0, 0, 0, 0, 0, 128, 63, 2, 3]);
    let content = SceneContent::Values { time_us: 2 };
    let part = ScenePart { scene: SceneKind::Truth, number: 1, content, last: true, bytes: &[9] };
    assert_eq!(to(&ToMonitorExtra::Scene(part)), [3, 1, 1, 1, 2, 1, 1, 9]);
    let item = SceneItem::new("a", "b").child("c").colour([1, 2, 3]).line_width(1.0);
    let declaration = postcard::to_stdvec(&SceneDeclaration { item, shape: "e", schema: &[9] }).expect("serializable");
    let (names, colour) = ([1, 97, 1, 98, 1, 1, 99], [1, 1, 2, 3]);
    assert_eq!(declaration, [&names[..], &colour, &[1, 0, 0, 128, 63, 1, 101, 1, 9]].concat());
    let head = ImageHead { number: 1, time_us: 2, camera: "a", width: 3, height: 4 };
    assert_eq!(to(&ToMonitorExtra::Image(head)), [4, 1, 2, 1, 97, 3, 4]);
    let chunk = ImageChunk { image_id: 1, offset: 2, bytes: &[9] };
    assert_eq!(to(&ToMonitorExtra::ImageChunk(chunk)), [5, 1, 2, 1, 9]);
    assert_eq!(to(&ToMonitorExtra::World(WorldState { paused: true, steps: 1, cycle: 2 })), [6, 1, 1, 2]);
    assert_eq!(to(&ToMonitorExtra::Result("a")), [9, 1, 97]);
    assert_eq!(to(&ToMonitorExtra::MessageSchema { command: true, last: true, bytes: &[9] }), [10, 1, 1, 1, 9]);
    assert_eq!(postcard::to_stdvec(&ToRobot::MonitorExtra(&[0])), Ok(vec![7, 1, 0]));
    assert_eq!(postcard::to_stdvec(&FromRobot::MonitorExtra(&[0])), Ok(vec![6, 1, 0]));
}
