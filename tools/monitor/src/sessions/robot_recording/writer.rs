//! Recording of a robot while it is received.

use std::path::PathBuf;

use bica_link::{Description, Snapshot};
use bica_recording::{Header, RecordedCycle};
use serde_json::Value;

use super::file::{WrittenFile, unused};
use super::{Cycles, add_line, add_value};
use crate::program::Image;
use crate::protocol::{ComponentNow, LogLine};

/// Largest number of lines before the first cycle of a connection.
const MAX_EARLY: usize = 1000;

/// Recording of a robot while it is received. A connection that is restored while the robot runs continues the file; a robot
/// that has begun again, or another tree, begins the next one.
pub(in crate::sessions) struct RobotRecorder {
    /// The first file; others have a number in their names.
    path: PathBuf,
    /// Header of a connection of which nothing was received yet.
    connected: Option<Header>,
    file: Option<(WrittenFile, String)>,
    cycles: Cycles,
    /// The last cycle: what belongs to it may still come.
    last: Option<RecordedCycle>,
    last_us: u64,
    /// Lines that came before the first cycle of a connection.
    early: Vec<LogLine>,
}

impl RobotRecorder {
    pub(in crate::sessions) fn new(path: PathBuf) -> Self {
        Self { path, connected: None, file: None, cycles: Cycles::default(), last: None, last_us: 0, early: Vec::new() }
    }

    /// Begins with a connection.
    pub(in crate::sessions) fn connected(&mut self, address: &str, description: &Description) {
        self.connected = Some(Header::of_monitor(address, description));
    }

    /// Adds the state after a cycle.
    pub(in crate::sessions) fn snapshot(&mut self, Snapshot { info, states }: &Snapshot) {
        if let Some(header) = self.connected.take() {
            let goes_on = |(_, hash): &(WrittenFile, String)| *hash == header.tree.hash && info.time_us > self.last_us;
            if !self.file.as_ref().is_some_and(goes_on) {
                self.finish();
                let hash = header.tree.hash.clone();
                self.file = Some((WrittenFile::new(unused(&self.path), header), hash));
                self.cycles = Cycles::default();
            }
        } else if info.time_us <= self.last_us {
            // Times of a recording increase.
            return;
        }
        self.hand_over();
        let states = states.iter().map(|one| ComponentNow(one.active, one.held, one.state, one.hz, 0));
        let mut cycle = self.cycles.cycle(info.time_us, info.cycle, states);
        self.early.drain(..).for_each(|line| add_line(&mut cycle, &line));
        self.last = Some(cycle);
        self.last_us = info.time_us;
    }

    pub(in crate::sessions) fn info(&mut self, component: usize, info: usize, value: &Value) {
        if let (None, Some(cycle)) = (&self.connected, &mut self.last) {
            add_value(cycle, component, info, value);
        }
    }

    pub(in crate::sessions) fn line(&mut self, line: &LogLine) {
        match &mut self.last {
            Some(cycle) if self.connected.is_none() => add_line(cycle, line),
            _ if self.early.len() < MAX_EARLY => self.early.push(line.clone()),
            _ => {}
        }
    }

    pub(in crate::sessions) fn image(&mut self, image: &Image) {
        if let (None, Some((file, _))) = (&self.connected, &mut self.file) {
            file.image(image.clone());
        }
    }

    /// Name and length of the file, and why it has ended early, or what was lost.
    pub(in crate::sessions) fn state(&self) -> (String, u64, String) {
        let path = || self.path.display().to_string();
        self.file.as_ref().map_or_else(
            || (path(), 0, String::new()),
            |(file, _)| (file.path.display().to_string(), file.bytes(), file.note()),
        )
    }

    /// Closes the file.
    pub(in crate::sessions) fn finish(&mut self) {
        self.hand_over();
        self.file = None;
    }

    fn hand_over(&mut self) {
        if let (Some(cycle), Some((file, _))) = (self.last.take(), &mut self.file) {
            file.cycle(cycle);
        }
    }
}

impl Drop for RobotRecorder {
    fn drop(&mut self) {
        self.finish();
    }
}
