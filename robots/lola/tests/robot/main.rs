//! The driver against a robot of this process: each test is both sides of the socket.
#![cfg(unix)]

mod answers;
mod encoding;
mod ends;
mod faults;
mod images;
mod pace;
mod stand_in;
