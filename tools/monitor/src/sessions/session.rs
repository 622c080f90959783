//! A session, shared by the manager and the session's thread.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard};
use std::time::{Duration, Instant};

use bica_drawing::layout::kinds;
use bica_link::{Description, Shown};
use bica_wire::message::{LogLine, LogSource};

use super::breakpoint_target;
use super::commands;
use super::common::Common;
use super::history::{History, Limits, Told};
use super::recorded_images::read_image;
use super::robot_recording::RobotRecorder;
use super::shared::{Operator, Shared};
use super::watches::Watching;
use crate::options::Options;
use crate::pages::{DataKind, Frame, Key};
use crate::pages::{PageId, Pages, lock};
use crate::program::{Image, Program, Remembered};
use crate::protocol::binary::{PixelKind, image_frame};
use crate::protocol::{Capabilities, Connection, Control, Failed, SessionId, SessionInfo, SessionKind, ToPage};

/// Interval of checks whether a session's thread has ended.
const POLL: Duration = Duration::from_millis(5);

/// A session.
pub(super) struct Session {
    pub(super) id: SessionId,
    pub(super) kind: SessionKind,
    pub(super) name: String,
    pub(super) options: Arc<Options>,
    pub(super) pages: Arc<Pages>,
    pub(super) program: Arc<Program>,
    /// Data that extensions store.
    pub(super) remembered: Mutex<Remembered>,
    /// File in which the session is recorded from its beginning, if the command line names one.
    pub(super) record: Option<PathBuf>,
    /// Writer of that file, for a robot.
    recorder: Mutex<Option<RobotRecorder>>,
    closed: AtomicBool,
    /// Whether the thread has ended.
    ended: AtomicBool,
    commands: commands::Commands,
    shared: Mutex<Shared>,
}

impl Session {
    pub(super) fn new(
        (id, kind, name): (SessionId, SessionKind, String),
        Common { options, pages, program }: Common,
        commands: commands::Commands,
        record: Option<PathBuf>,
    ) -> Self {
        let recorder = record.clone().filter(|_| kind == SessionKind::Robot).map(RobotRecorder::new);
        let limits = limits(&options, kind);
        Self {
            id,
            kind,
            name,
            options,
            pages,
            program,
            remembered: Mutex::default(),
            record,
            recorder: Mutex::new(recorder),
            closed: AtomicBool::new(false),
            ended: AtomicBool::new(false),
            commands,
            shared: Mutex::new(Shared { history: History::new(limits, 0), ..Shared::default() }),
        }
    }

    pub(super) fn shared(&self) -> MutexGuard<'_, Shared> {
        lock(&self.shared)
    }

    /// Sends a command to the session's thread.
    pub(super) fn command(&self, command: commands::Command) -> Result<(), Failed> {
        let ended = || Failed::new("the session has ended", "open it again");
        self.commands.send(command).then_some(()).ok_or_else(ended)
    }

    /// Returns the session as a page sees it.
    pub(super) fn info(&self, page: PageId) -> SessionInfo {
        self.info_of(&self.shared(), page)
    }

    fn info_of(&self, shared: &Shared, page: PageId) -> SessionInfo {
        let (from_us, until_us) = shared.history.span();
        let control = match shared.operator {
            _ if !shared.can.operate => Control::Unavailable,
            Operator::Nobody => Control::Free,
            Operator::Other => Control::OtherMonitor,
            Operator::Page(owner) if owner == page => Control::Yours,
            Operator::Page(_) => Control::OtherPage,
        };
        SessionInfo {
            id: self.id,
            kind: self.kind,
            name: shared.seed.map_or_else(|| self.name.clone(), |seed| format!("{}, seed {seed}", self.name)),
            seed: shared.seed,
            connection: shared.connection,
            note: shared.note.clone(),
            result: shared.result.clone(),
            from_us,
            until_us,
            gaps: shared.history.states.gaps().copied().collect(),
            paused: shared.paused,
            control,
            can: shared.can,
            recording: shared.recording.clone(),
        }
    }

    /// Returns whether a simulated world is paused.
    pub(super) fn is_paused(&self) -> bool {
        self.shared().paused
    }

    /// Sends the session to all pages. The lock is held meanwhile, so that a later announcement of another thread is newer.
    pub(super) fn announce(&self) {
        self.announce_of(&self.shared());
    }

    fn announce_of(&self, shared: &Shared) {
        if self.is_closed() {
            return;
        }
        for page in self.pages.list() {
            self.pages.state(page, ToPage::Session { session: self.info_of(shared, page) });
        }
    }

    /// Sends the session and its tree to a new page.
    pub(super) fn greet(&self, page: PageId) {
        let mut shared = self.shared();
        if !self.is_closed() {
            self.pages.state(page, ToPage::Session { session: self.info_of(&shared, page) });
            self.send_description(&mut shared, page);
        }
    }

    /// Changes the connection's state and announces it.
    pub(super) fn set_connection(&self, connection: Connection, note: impl Into<String>) {
        let note = note.into();
        let mut shared = self.shared();
        if (shared.connection, &shared.note) != (connection, &note) {
            (shared.connection, shared.note) = (connection, note);
            self.announce_of(&shared);
        }
    }

    /// Resets the session for a tree and clears the history.
    pub(super) fn describe(&self, description: Description, can: Capabilities) {
        self.begin(description, can, false);
    }

    /// Resets the session for a tree. Clears the history unless the same run continues.
    pub(super) fn begin(&self, description: Description, can: Capabilities, goes_on: bool) {
        let mut shared = self.shared();
        if goes_on {
            shared.history.interrupt();
        } else {
            shared.history = History::new(limits(&self.options, self.kind), description.components.len());
            shared.epoch += 1;
            shared.result.clear();
            shared.scenery.clear();
        }
        let own = shared.description.take().map(|tree| (tree, std::mem::take(&mut shared.breakpoints)));
        if let Some((tree, targets)) = shared.inherited.take().or(own) {
            shared.breakpoints = breakpoint_target::moved(&targets, &tree, &description, can.conditions);
        }
        shared.kinds = kinds(&description);
        let description = Some(Arc::new(description));
        (shared.begun, shared.description) = (description.clone(), description);
        shared.can = can;
        // A world of this process that was paused by a person is restarted in pause.
        shared.paused &= self.kind == SessionKind::World && !std::mem::take(&mut shared.is_over);
        shared.watching = Watching::default();
        shared.described.clear();
        for page in self.pages.list() {
            self.send_description(&mut shared, page);
        }
    }

    /// Sends the tree to a page, once, and its current state.
    fn send_description(&self, shared: &mut Shared, page: PageId) {
        let Some(description) = shared.description.as_deref().cloned().map(Box::new) else { return };
        if shared.described.insert(page) {
            // A recording may be described before its session is announced, and a page ignores unknown sessions.
            self.pages.state(page, ToPage::Session { session: self.info_of(shared, page) });
            self.pages.state(page, ToPage::Described { session: self.id, description, kinds: shared.kinds.clone() });
            if !shared.scenery.is_empty() {
                self.pages.state(page, ToPage::Scenery { session: self.id, scenery: shared.scenery.clone() });
            }
            self.pages.state(page, self.breakpoints(shared));
        }
        if let Some(update) = self.update(shared, Vec::new()) {
            self.pages.data(page, self.key(DataKind::Update), Frame::of(update));
        }
    }

    /// Sends the state after the last cycle to all pages, with the changes since the last update.
    pub(super) fn show_update(&self, changes: Vec<(usize, u64, bool, Option<u16>)>) {
        let shared = self.shared();
        if let Some(update) = self.update(&shared, changes) {
            self.pages.broadcast_data(self.key(DataKind::Update), &Frame::of(update));
        }
    }

    pub(super) const fn key(&self, kind: DataKind) -> Key {
        Key { session: self.id, kind }
    }

    /// Returns the state after the last cycle.
    fn update(&self, shared: &Shared, changes: Vec<(usize, u64, bool, Option<u16>)>) -> Option<ToPage> {
        let (time_us, cycle) = shared.history.states.last()?;
        Some(ToPage::Update {
            session: self.id,
            time_us,
            cycle,
            images: shared.images_taken,
            overruns: shared.overruns,
            components: shared.history.states.current().to_vec(),
            changes,
        })
    }

    /// Adds a line to the log and sends it to all pages.
    pub(super) fn log(&self, level: u8, source: LogSource, text: impl Into<String>) {
        let time_us = self.shared().history.span().1;
        self.add_line(LogLine { time_us, level, source, text: text.into() });
    }

    /// Stores the result of the run.
    pub(super) fn set_result(&self, text: String) {
        self.shared().result = text;
        self.announce();
    }

    /// Stores the scenery of the world, and sends it to all pages that know the tree.
    pub(super) fn show_scenery(&self, scenery: &[Shown]) {
        let mut shared = self.shared();
        scenery.clone_into(&mut shared.scenery);
        for &page in &shared.described {
            self.pages.state(page, ToPage::Scenery { session: self.id, scenery: scenery.to_vec() });
        }
    }

    pub(super) fn add_line(&self, line: LogLine<String>) {
        self.tell(line.time_us, Told::Line(line));
    }

    /// Stores an entry of the log with its time, µs, and sends the line to all pages.
    pub(super) fn tell(&self, time_us: u64, told: Told) {
        let line = {
            let mut shared = self.shared();
            shared.history.told.push(time_us, told.clone());
            told.line(time_us, &shared.description.clone().unwrap_or_default())
        };
        self.record_robot(|recorder| recorder.tell(time_us, told));
        self.pages.broadcast(&ToPage::Log { session: self.id, lines: vec![line] });
    }

    /// Calls a function with the recorder of a robot, if there is one.
    pub(super) fn record_robot<T>(&self, record: impl FnOnce(&mut RobotRecorder) -> T) -> Option<T> {
        lock(&self.recorder).as_mut().map(record)
    }

    /// Returns the description.
    ///
    /// # Errors
    /// Before the first connection.
    pub(super) fn description(&self) -> Result<Arc<Description>, Failed> {
        let none = || Failed::new("nothing is known of this session yet", "wait until it is connected");
        self.shared().description.clone().ok_or_else(none)
    }

    /// Returns the parameters that have changed since the run began, `Component.name` with the value.
    pub(super) fn tuned(&self) -> Vec<(String, String)> {
        let shared = self.shared();
        let (Some(begun), Some(now)) = (&shared.begun, &shared.description) else { return Vec::new() };
        let components = begun.components.iter().zip(&now.components);
        let params = components.flat_map(|(begun, now)| {
            let params = begun.params.iter().zip(&now.params).filter(|(begun, now)| begun.current() != now.current());
            params.map(|(_, param)| {
                (format!("{}.{}", now.name, param.name), param.kind.text(param.current()).to_string())
            })
        });
        params.collect()
    }

    /// Returns the binary frame of an image, or of the classes of its pixels.
    pub(super) fn image_frame(&self, image: &Image, (kind, pixels): (PixelKind, &[u8]), id: u32) -> Arc<[u8]> {
        image_frame(self.id, image, (kind, pixels), id).into()
    }

    /// Returns the image with this number, from memory or from the file of a recording.
    pub(super) fn image(&self, number: u32) -> Result<Image, Failed> {
        let (image, place) = {
            let shared = self.shared();
            (shared.history.images.get(number).cloned(), shared.recorded.get(number))
        };
        let gone = || Failed::new(format!("image {number} is not in memory any more"), "choose a newer one");
        match (image, place) {
            (Some(image), _) => Ok(image),
            (None, Some(place)) => read_image(&self.recording_path(), place),
            (None, None) => Err(gone()),
        }
    }

    pub(super) fn recording_path(&self) -> std::path::PathBuf {
        self.shared().recorded.path.clone()
    }

    /// Returns whether the session was closed; its threads then end.
    pub(super) fn is_closed(&self) -> bool {
        self.closed.load(Ordering::Relaxed)
    }

    /// Closes the file of a robot. The session's thread calls it at its end.
    pub(super) fn thread_ended(&self) {
        drop(lock(&self.recorder).take());
        self.ended.store(true, Ordering::Relaxed);
    }

    /// Waits until the file of a session that is recorded from its beginning is closed.
    pub(super) fn wait_for_file(&self, limit: Duration) {
        let until = Instant::now() + limit;
        while self.record.is_some() && !self.ended.load(Ordering::Relaxed) && Instant::now() < until {
            std::thread::sleep(POLL);
        }
    }

    /// Closes the session, and ends its thread.
    pub(super) fn end(&self) {
        {
            // Under the lock: nothing is announced afterwards.
            let _shared = self.shared();
            self.closed.store(true, Ordering::Relaxed);
        }
        let path = self.recording_path();
        if path.starts_with(&self.options.spool) {
            // The file of a repeated run may not exist yet.
            let _ = std::fs::remove_file(path);
        }
        // The thread may have ended already.
        let _ = self.command(commands::Command::Close);
    }
}

fn limits(options: &Options, kind: SessionKind) -> Limits {
    Limits {
        ring_us: (kind != SessionKind::Recording).then_some(options.ring.as_micros() as u64),
        output_bytes: options.output_bytes,
        image_bytes: options.image_bytes,
    }
}
