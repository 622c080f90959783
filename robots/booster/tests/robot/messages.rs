//! Encoding of the messages.

use bica_booster::message::{LowCmd, LowState, MotorCmd, MotorState, SERIAL};
use byteorder::LittleEndian;
use cdr_encoding::{from_bytes, to_vec};

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
