//! Encoding of the messages.

use std::env;
use std::io::Write;
use std::process::{Command, Stdio};

use bica_booster::message::{
    FallDownState, LowCmd, LowState, MotorCmd, MotorState, Odometer, RpcReqMsg, RpcRespMsg, SERIAL,
};
use byteorder::LittleEndian;
use cdr_encoding::{from_bytes, to_vec};
use proptest::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Numbers of random messages that are compared with the peer's: where the package happens to be installed, and in CI.
const MESSAGES: [usize; 2] = [500, 10_000];

#[test]
fn messages_have_the_makers_sizes() {
    let motors = vec![MotorState::default(); 23];
    let state = LowState { motor_state_parallel: motors.clone(), motor_state_serial: motors, ..LowState::default() };
    let bytes = to_vec::<LowState, LittleEndian>(&state).expect("it is encoded");
    assert_eq!(bytes.len(), 1700);
    assert_eq!(from_bytes::<LowState, LittleEndian>(&bytes).expect("it is decoded").0, state);
    let command = LowCmd { cmd_type: SERIAL, motor_cmd: vec![MotorCmd::default(); 23] };
    let bytes = to_vec::<LowCmd, LittleEndian>(&command).expect("it is encoded");
    assert_eq!((bytes.len(), &bytes[..8]), (652, &[1, 0, 0, 0, 23, 0, 0, 0][..]));
}

proptest! {
    #[test]
    fn no_bytes_make_the_decoder_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        _ = from_bytes::<LowState, LittleEndian>(&bytes);
        _ = from_bytes::<RpcRespMsg, LittleEndian>(&bytes);
        _ = from_bytes::<FallDownState, LittleEndian>(&bytes);
    }
}

/// Compares a message of the peer, its encoding and its values, with ours; returns our encoding and values.
fn again<T: Serialize + DeserializeOwned + PartialEq + std::fmt::Debug>(bytes: &[u8], text: &str) -> (Vec<u8>, String) {
    let message: T = serde_json::from_str(text).expect("the fields are the same");
    let (decoded, size) = from_bytes::<T, LittleEndian>(bytes).expect("it is decoded");
    assert_eq!((&decoded, size), (&message, bytes.len()));
    let encoded = to_vec::<T, LittleEndian>(&message).expect("it is encoded");
    (encoded, serde_json::to_string(&message).expect("it is JSON"))
}

/// Messages of Cyclone DDS are read and written as it does. `BICA_CYCLONE` names a Python with its package.
#[test]
fn peer_cyclone_agrees_in_every_field() {
    let python = env::var("BICA_CYCLONE");
    let program = python.as_deref().unwrap_or("python3");
    let has_module = Command::new(program).args(["-c", "import cyclonedds"]).output();
    if !has_module.is_ok_and(|output| output.status.success()) {
        assert!(python.is_err(), "{program} has no package `cyclonedds`");
        eprintln!("skipped: python3 with cyclonedds is not installed");
        return;
    }
    let count = MESSAGES[usize::from(python.is_ok())].to_string();
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/messages.py");
    let run = |arguments: &[&str]| Command::new(program).arg(script).args(arguments).output().expect("it runs");
    let random = run(&["random", &count, "7"]);
    assert!(random.status.success(), "{}", String::from_utf8_lossy(&random.stderr));
    let mut ours = String::new();
    for line in String::from_utf8(random.stdout).expect("text").lines() {
        let parts: Vec<_> = line.split('\t').collect();
        let [kind, hex, text] = parts[..] else { panic!("{line}") };
        let bytes: Vec<_> = (0..hex.len()).step_by(2).map(|at| u8::from_str_radix(&hex[at..at + 2], 16)).collect();
        let bytes = bytes.into_iter().collect::<Result<Vec<_>, _>>().expect("hexadecimal");
        let (encoded, text) = match kind {
            "LowState" => again::<LowState>(&bytes, text),
            "LowCmd" => again::<LowCmd>(&bytes, text),
            "Odometer" => again::<Odometer>(&bytes, text),
            "FallDownState" => again::<FallDownState>(&bytes, text),
            "RpcReqMsg" => again::<RpcReqMsg>(&bytes, text),
            "RpcRespMsg" => again::<RpcRespMsg>(&bytes, text),
            other => panic!("{other}"),
        };
        assert!(encoded == bytes, "{kind} is encoded in another way");
        // The same encoding, as compared above.
        ours.extend([kind, "\t", hex, "\t", &text, "\n"]);
    }
    let mut check = Command::new(program);
    check.args([script, "check"]).stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut check = check.spawn().expect("it runs");
    let mut input = check.stdin.take().expect("an input");
    input.write_all(ours.as_bytes()).expect("it reads");
    drop(input);
    let output = check.wait_with_output().expect("it ends");
    assert!(output.status.success());
    assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), count);
}
