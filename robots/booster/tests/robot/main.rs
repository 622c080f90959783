//! Tests of the driver against a robot in memory, which checks each message.

#[cfg(feature = "mujoco")]
mod dynamics;
mod ends;
#[cfg(feature = "mujoco")]
mod falls;
mod faults;
mod firmware;
#[cfg(feature = "mujoco")]
mod in_step;
mod messages;
mod random;
mod stand_in;
mod walks;
