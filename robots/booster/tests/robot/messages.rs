//! Encoding of the messages.

use bica_booster::message::{
    FallDownState, LowCmd, LowState, MotorCmd, MotorState, Odometer, RpcReqMsg, RpcRespMsg, SERIAL,
};
use bica_test_data::peer::Peer;
use byteorder::LittleEndian;
use cdr_encoding::{from_bytes, to_vec};
use proptest::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;

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

/// Messages of Cyclone DDS are read and written as it does.
#[test]
fn peer_cyclone_agrees_in_every_field() {
    let Some(peer) = Peer::find("cyclonedds", concat!(env!("CARGO_MANIFEST_DIR"), "/messages.py")) else { return };
    peer.compare(|kind, bytes, text| {
        let (encoded, text) = match kind {
            "LowState" => again::<LowState>(bytes, text),
            "LowCmd" => again::<LowCmd>(bytes, text),
            "Odometer" => again::<Odometer>(bytes, text),
            "FallDownState" => again::<FallDownState>(bytes, text),
            "RpcReqMsg" => again::<RpcReqMsg>(bytes, text),
            "RpcRespMsg" => again::<RpcRespMsg>(bytes, text),
            other => panic!("{other}"),
        };
        assert!(encoded == bytes, "{kind} is encoded in another way");
        (encoded, text)
    });
}
