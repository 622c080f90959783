//! The link between a running loop and its monitors, over sockets and pseudo terminals.
//!
//! The loops here run as fast as they can, and their robot's time advances by 10 ms in a cycle. So the tests compare cycles; the
//! clock of the computer only limits how long a failing test waits.

mod actions;
mod attacks;
mod extras;
mod faults;
mod microcontroller;
mod monitors;
mod operators;
mod proxy;
mod robot;
#[cfg(target_os = "linux")]
mod serial;
mod session;
mod stops;
mod wall;
