//! The robot's side of the topics with this crate's messages, for a comparison with the maker's wheel: see `check_wheel.py`.
//!
//! `as_robot DOMAIN SECONDS` sends states on loopback, answers requests, and prints what it has received.

use std::env;
use std::error::Error;
use std::thread;
use std::time::{Duration, Instant};

use bica_booster::message::{FallDownState, LowCmd, LowState, MotorState, Odometer, RpcReqMsg, RpcRespMsg};
use rustdds::no_key::{DataReaderCdr, DataWriterCdr};
use rustdds::policy::{Durability, History, Reliability};
use rustdds::{DomainParticipantBuilder, QosPolicies, QosPolicyBuilder, TopicKind};

fn qos(reliability: Reliability, durability: Durability) -> QosPolicies {
    let builder = QosPolicyBuilder::new().reliability(reliability).durability(durability);
    builder.history(History::KeepLast { depth: 16 }).build()
}

/// State whose values tell their places.
fn state() -> LowState {
    let motor = |index: u8| MotorState {
        mode: index,
        q: 0.01 * f32::from(index),
        dq: 1.0 + f32::from(index),
        ddq: 100.0 + f32::from(index),
        tau_est: -f32::from(index),
        temperature: 40 + index,
        lost: 1000 + u32::from(index),
        reserve: [7, 8],
    };
    let mut state = LowState { motor_state_serial: (0..23).map(motor).collect(), ..LowState::default() };
    state.motor_state_parallel = (100..123).map(motor).collect();
    state.imu_state.rpy = [0.1, 0.2, 0.3];
    state.imu_state.gyro = [1.0, 2.0, 3.0];
    state.imu_state.acc = [0.5, 0.25, 9.75];
    state
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let domain = arguments.next().ok_or("give a domain")?.parse()?;
    let seconds = Duration::from_secs(arguments.next().ok_or("give a duration, s")?.parse()?);
    let participant =
        DomainParticipantBuilder::new(domain).with_only_networks([std::net::Ipv4Addr::LOCALHOST]).build()?;
    let reliable = Reliability::Reliable { max_blocking_time: rustdds::Duration::from_millis(5) };
    let (effort, reliable) = (qos(Reliability::BestEffort, Durability::Volatile), qos(reliable, Durability::Volatile));
    let publisher = participant.create_publisher(&effort)?;
    let subscriber = participant.create_subscriber(&reliable)?;
    let topic = |name: &str, of: &str, qos| participant.create_topic(name.into(), of.into(), qos, TopicKind::NoKey);
    let interface = |name: &str, of: &str| topic(name, &format!("booster_interface::msg::dds_::{of}_"), &effort);
    let service = |name: &str, of: &str| topic(name, &format!("booster_msgs::msg::dds_::{of}_"), &reliable);
    let (low, odometer) = (interface("rt/low_state", "LowState")?, interface("rt/odometer_state", "Odometer")?);
    let (fall, command) = (interface("rt/fall_down", "FallDownState")?, interface("rt/joint_ctrl", "LowCmd")?);
    let states: DataWriterCdr<LowState> = publisher.create_datawriter_no_key_cdr(&low, None)?;
    let odometers: DataWriterCdr<Odometer> = publisher.create_datawriter_no_key_cdr(&odometer, None)?;
    let falls: DataWriterCdr<FallDownState> = publisher.create_datawriter_no_key_cdr(&fall, None)?;
    let mut commands: DataReaderCdr<LowCmd> = subscriber.create_datareader_no_key_cdr(&command, None)?;
    let (request, response) =
        (service("rt/LocoApiTopicReq", "RpcReqMsg")?, service("rt/LocoApiTopicResp", "RpcRespMsg")?);
    let mut requests: DataReaderCdr<RpcReqMsg> = subscriber.create_datareader_no_key_cdr(&request, None)?;
    let answers: DataWriterCdr<RpcRespMsg> =
        publisher.create_datawriter_no_key_cdr(&response, Some(reliable.clone()))?;
    let start = Instant::now();
    while start.elapsed() < seconds {
        states.write(state(), None)?;
        odometers.write(Odometer { x: 1.5, y: -2.5, theta: 0.75 }, None)?;
        falls.write(FallDownState { fall_down_state: 2, is_recovery_available: true }, None)?;
        while let Ok(Some(sample)) = commands.take_next_sample() {
            let LowCmd { cmd_type, motor_cmd } = sample.into_value();
            println!("command {cmd_type} {} {:?}", motor_cmd.len(), motor_cmd.last());
        }
        while let Ok(Some(sample)) = requests.take_next_sample() {
            let RpcReqMsg { uuid, header, body } = sample.into_value();
            println!("request {header} {body}");
            let answer = RpcRespMsg { uuid, header: r#"{"status":0}"#.into(), body: r#"{"mode":3}"#.into() };
            answers.write(answer, None)?;
        }
        thread::sleep(Duration::from_millis(10));
    }
    Ok(())
}
