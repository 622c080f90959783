//! Recordings of a robot behind a link, made of the data that this server has received.

mod file;
mod writer;

pub(super) use file::{unused, write_image};
pub(super) use writer::RobotRecorder;
