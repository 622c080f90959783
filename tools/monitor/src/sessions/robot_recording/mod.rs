//! Recordings of a robot behind a link: what this server has received of it.

mod file;
mod writer;

pub(super) use file::{received, unused};
pub(super) use writer::RobotRecorder;
