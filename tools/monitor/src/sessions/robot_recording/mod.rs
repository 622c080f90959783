//! Recordings of a robot behind a link, made of the data that this server has received.

mod file;
mod writer;

pub(super) use file::{received, unused};
pub(super) use writer::RobotRecorder;
