//! Recording of a robot while its data are received.

use std::path::PathBuf;

use bica_link::{Client, Description, Snapshot};
use bica_recording::{Header, RecordedCycle};

use super::file::{WrittenFile, unused};
use crate::program::Image;
use crate::sessions::history::Told;

/// Largest number of lines, requests and events that wait for their cycle.
const MAX_TOLD: usize = 1000;
/// Largest number of cycles that wait for the schemas of all outputs: a microcontroller sends each before its first value.
const MAX_WAITING: usize = 1000;

/// Recording of a robot while its data are received. A connection that is restored while the robot runs continues the file; a
/// restarted robot, or another tree, begins the next one.
pub(in crate::sessions) struct RobotRecorder {
    /// The first file; others have a number in their names.
    path: PathBuf,
    /// Whether the connection is new: none of its cycles was received yet.
    connected: bool,
    /// Hash of the recorded tree.
    hash: String,
    /// Header of a file that waits for schemas.
    header: Option<Header>,
    file: Option<WrittenFile>,
    /// Cycles that wait for the file.
    waiting: Vec<RecordedCycle>,
    /// The last cycle: data that belong to it may still come.
    last: Option<RecordedCycle>,
    last_us: u64,
    /// Entries of the log that wait for their cycle, with their times, µs.
    told: Vec<(u64, Told)>,
}

impl RobotRecorder {
    pub(in crate::sessions) const fn new(path: PathBuf) -> Self {
        Self {
            path,
            connected: false,
            hash: String::new(),
            header: None,
            file: None,
            waiting: Vec::new(),
            last: None,
            last_us: 0,
            told: Vec::new(),
        }
    }

    /// Marks the beginning of a connection.
    pub(in crate::sessions) const fn connected(&mut self) {
        self.connected = true;
    }

    /// Adds the state after a cycle of the robot at an address.
    pub(in crate::sessions) fn snapshot(&mut self, snapshot: &Snapshot, address: &str, client: &Client) {
        let Snapshot { info, states } = snapshot;
        let tree = client.description();
        if std::mem::take(&mut self.connected) {
            if self.hash != tree.hash || info.time_us <= self.last_us {
                self.finish();
                self.hash.clone_from(&tree.hash);
                self.header = Some(Header::of_monitor(address, tree, client.offers()));
            }
        } else if info.time_us <= self.last_us {
            // Times of a recording increase.
            return;
        }
        if let Some(header) = self.header.as_mut().filter(|header| !has_schemas(&header.tree)) {
            header.tree = tree.clone();
        }
        let is_due = |header: &mut Header| has_schemas(&header.tree) || self.waiting.len() >= MAX_WAITING;
        if let Some(header) = self.header.take_if(is_due) {
            self.file = Some(WrittenFile::new(unused(&self.path), header));
        }
        self.hand_over();
        self.last = Some(RecordedCycle::received(info.cycle, info.time_us, states.iter().copied()));
        self.last_us = info.time_us;
    }

    /// Adds a value of an output; none if it is too large.
    pub(in crate::sessions) fn output(&mut self, component: usize, output: usize, value: Option<&[u8]>) {
        if let (false, Some(cycle)) = (self.connected, &mut self.last) {
            cycle.add_output(component, output, value);
        }
    }

    /// Adds an entry of the log with its time, µs.
    pub(in crate::sessions) fn tell(&mut self, time_us: u64, told: Told) {
        if self.told.len() < MAX_TOLD {
            self.told.push((time_us, told));
        }
    }

    pub(in crate::sessions) fn image(&mut self, image: &Image) {
        if let (false, Some(file)) = (self.connected, &mut self.file) {
            file.image(image.clone());
        }
    }

    /// Returns name and length, bytes, of the file, and why it has ended early, or which data were lost.
    pub(in crate::sessions) fn state(&self) -> (String, u64, String) {
        let path = || self.path.display().to_string();
        self.file.as_ref().map_or_else(
            || (path(), 0, String::new()),
            |file| (file.path.display().to_string(), file.bytes(), file.note()),
        )
    }

    /// Closes the file.
    pub(in crate::sessions) fn finish(&mut self) {
        if let Some(header) = self.header.take() {
            self.file = Some(WrittenFile::new(unused(&self.path), header));
        }
        self.hand_over();
        self.file = None;
    }

    fn hand_over(&mut self) {
        if let Some(mut cycle) = self.last.take() {
            let of_cycle = |(time_us, _): &mut (u64, Told)| *time_us <= self.last_us;
            self.told.extract_if(.., of_cycle).for_each(|(_, told)| told.record(&mut cycle));
            self.waiting.push(cycle);
        }
        if let Some(file) = &mut self.file {
            self.waiting.drain(..).for_each(|cycle| file.cycle(cycle));
        }
    }
}

/// Returns whether the schemas of all outputs of a tree are known.
fn has_schemas(tree: &Description) -> bool {
    tree.components.iter().flat_map(|component| &component.outputs).all(|output| output.schema.is_some())
}

impl Drop for RobotRecorder {
    fn drop(&mut self) {
        self.finish();
    }
}
