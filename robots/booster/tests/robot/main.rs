//! Tests of the driver against a robot in memory, which checks each message.

#[cfg(feature = "mujoco")]
mod dynamics;
mod ends;
mod faults;
mod firmware;
mod messages;
mod random;
mod stand_in;
mod walks;
