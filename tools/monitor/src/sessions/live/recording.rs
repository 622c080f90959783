//! State of the recording of a live session, for pages.

use std::time::{Duration, Instant};

use super::attached::Attached;
use crate::protocol::RecordingState;
use bica_wire::message::LogSource;

/// Interval of messages to the pages about the size of the recording.
const ANNOUNCE: Duration = Duration::from_secs(2);

impl Attached<'_> {
    /// Updates size and end of the recording, and announces a change.
    pub(super) fn look_at_recording(&mut self) {
        let now = if self.world.is_some() { self.of_world() } else { self.of_robot() };
        let before = std::mem::replace(&mut self.session.shared().recording, now.clone());
        if !now.note.is_empty() && before.note.is_empty() {
            self.session.log(3, LogSource::Monitor, now.note.clone());
        }
        let changed = (before.on, &before.note, &before.file) != (now.on, &now.note, &now.file);
        if changed || (before != now && self.announced.elapsed() >= ANNOUNCE) {
            self.announced = Instant::now();
            self.session.announce();
        }
    }

    /// Returns the state of a world's recording, which begins with the first cycle of its run.
    fn of_world(&self) -> RecordingState {
        let ended = self.world.as_ref().and_then(|world| world.run.recording_ended());
        let file = &self.session.shared().recording_file.clone();
        RecordingState {
            on: ended.is_none(),
            from_us: 0,
            bytes: std::fs::metadata(file).map_or(0, |file| file.len()),
            note: ended.map_or_else(String::new, |reason| format!("the recording has ended: {reason}")),
            file: self.session.record.as_ref().map_or_else(String::new, |_| file.display().to_string()),
        }
    }

    /// Returns the state of a robot's recording: its file, or its history in memory.
    fn of_robot(&self) -> RecordingState {
        let written = self.session.record_robot(|recorder| recorder.state());
        let shared = self.session.shared();
        let (file, bytes, note) =
            written.unwrap_or_else(|| (String::new(), shared.history.bytes() as u64, String::new()));
        RecordingState { on: true, from_us: shared.history.span().0, bytes, note, file }
    }
}
