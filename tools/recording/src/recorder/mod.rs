//! Recording beside a running loop.

mod measured;
mod output;
mod parts;
mod probe;
mod queue;
mod report;
mod sink;
mod syncer;
mod thread;
mod tree;
mod works;

use std::sync::Arc;
use std::thread::JoinHandle;
use std::{fmt, io};

use bica::refusal::Refusal;
use bica::runner::{ClockStep, Cycle, Observer, Request};
use bica::{Graph, Instant};
use bica_link::CostMeter;
use bica_wire::Recordable;
use bica_wire::message::LogSource;
use bica_wire::model::Modulation;
use crc32fast::Hasher;

use crate::figure::Figure;
use crate::header::{Ending, Header, ImagePolicy};
use crate::message::{Costs, LogLine, RunEvent, TreeRecord};
use crate::outputs;
use crate::part::Split;
use crate::request::RequestRecord;
use measured::Measured;
pub(crate) use output::Output;
use parts::Parts;
use queue::{BlobValues, CycleValues, Data, Entry, KeptBlob, Queue};
pub use report::Report;
pub use sink::{Sink, Syncing, create};
use tree::read_tree;
pub use tree::tree_record;
use works::Works;

/// What a recorder does when its queue is full because the disk is slow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backpressure {
    /// The loop waits: for simulations without a clock.
    Wait,
    /// The loop goes on. An image is dropped and counted; if even the values of a cycle find no room, the recording ends.
    Drop,
}

/// Reason for the end of a recording whose thread panicked.
const FAILED: &str = "the thread of the recorder failed";

/// Options of a recorder.
#[derive(Clone, Copy, Debug)]
pub struct RecorderOptions {
    /// What happens when the queue is full.
    pub backpressure: Backpressure,
    /// Number of cycles that the queue holds; at 100 Hz 6000 are a minute and 5 MB.
    pub cycles: usize,
    /// Number of images that the queue holds.
    pub images: usize,
    /// Size of a chunk, bytes before compression. Chunks are written earlier if time has passed.
    pub chunk_bytes: usize,
    /// Number of cycles from one record of outputs to the next; 0: none.
    pub outputs_every: u64,
}

impl Default for RecorderOptions {
    fn default() -> Self {
        Self { backpressure: Backpressure::Drop, cycles: 6000, images: 32, chunk_bytes: 1 << 20, outputs_every: 10 }
    }
}

/// Observer of a loop that records it.
///
/// The loop encodes the values of a cycle into a queue, copies large data without an [owner](Self::sharing_blobs), and never waits
/// for the disk, unless [`Backpressure::Wait`] says so. A thread of its own codes and writes them, at least every 0.3 s. Every
/// 0.5 s another thread asks the operating system to bring them to the disk. If writing fails, the recording ends, the
/// file keeps what is complete, and the loop goes on.
#[derive(Debug)]
pub struct Recorder {
    queue: Arc<Queue>,
    thread: Option<JoinHandle<Report>>,
    stores_values: bool,
    /// Active components and states after this cycle and after the last one.
    tree: TreeRecord,
    last_tree: TreeRecord,
    cycles: u64,
    outputs_every: u64,
    /// Size of the largest record of outputs so far, bytes.
    outputs_bytes: usize,
    /// Size of the largest sensor values and command so far, encoded.
    message_bytes: usize,
    /// Actions of the world.
    actions: Vec<Modulation>,
    works: Works,
    requests: Vec<RequestRecord>,
    sensing: Option<(Vec<u8>, BlobValues)>,
    owner: Owner,
    meter: Option<CostMeter>,
    measured: Measured,
    figures: Vec<Figure>,
}

/// Ends a recording if its thread panics: otherwise a loop would wait for the thread without end.
struct EndAtPanic<'a> {
    queue: &'a Queue,
    on_end: &'a dyn Fn(&str),
}

impl Drop for EndAtPanic<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.queue.end();
            (self.on_end)(FAILED);
        }
    }
}

/// Function that returns the owner of large data.
struct Owner(Box<OwnerOf>);

type OwnerOf = dyn Fn(&[u8]) -> Option<Arc<Vec<u8>>> + Send;

impl fmt::Debug for Owner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Owner")
    }
}

impl Recorder {
    /// Writes the header to `sink` and starts the thread. The thread calls `on_end` with the reason if the recording ends before
    /// the run.
    ///
    /// # Errors
    /// If the header cannot be written or no thread can be started.
    pub fn start(
        sink: impl Sink + 'static,
        header: &Header,
        options: RecorderOptions,
        on_end: impl Fn(&str) + Send + 'static,
    ) -> io::Result<Self> {
        let writing = thread::Writing::new(sink, header, options.chunk_bytes)?;
        Self::spawn(writing, header, options, on_end)
    }

    /// Starts a recording as [`start`](Self::start), which continues in another file when a part has reached a limit. `file`
    /// creates the file of the part with a number, from 1.
    ///
    /// # Errors
    /// As [`start`](Self::start).
    pub fn start_split<S: Sink + 'static>(
        mut file: impl FnMut(u32) -> io::Result<S> + Send + 'static,
        split: Split,
        header: &Header,
        options: RecorderOptions,
        on_end: impl Fn(&str) + Send + 'static,
    ) -> io::Result<Self> {
        let (first, header) = (file(1)?, parts::first(header));
        let parts = Parts::new(split, Box::new(file));
        let writing = thread::Writing::new(first, &header, options.chunk_bytes)?.in_parts(parts);
        Self::spawn(writing, &header, options, on_end)
    }

    fn spawn<S: Sink + 'static>(
        writing: thread::Writing<S>,
        header: &Header,
        options: RecorderOptions,
        on_end: impl Fn(&str) + Send + 'static,
    ) -> io::Result<Self> {
        let queue = Arc::new(Queue::new(options));
        let shared = Arc::clone(&queue);
        let work = move || {
            let _end = EndAtPanic { queue: &shared, on_end: &on_end };
            writing.run(&shared, &on_end)
        };
        let thread = std::thread::Builder::new().name("recorder".to_owned()).spawn(work)?;
        Ok(Self {
            queue,
            thread: Some(thread),
            stores_values: header.images == ImagePolicy::All,
            tree: TreeRecord::default(),
            last_tree: TreeRecord::default(),
            cycles: 0,
            outputs_every: options.outputs_every,
            outputs_bytes: 0,
            message_bytes: 0,
            actions: header.tree.actions.clone(),
            works: Works::of(&header.tree),
            requests: Vec::new(),
            sensing: None,
            owner: Owner(Box::new(|_| None)),
            meter: None,
            measured: Measured::new(options.backpressure),
            figures: Vec::new(),
        })
    }

    /// Sets a function that returns the owner of large data, such as the pixels of an image, if it has one that is never changed
    /// again. Then the recorder keeps the owner, and the loop copies nothing.
    #[must_use]
    pub fn sharing_blobs(mut self, owner: impl Fn(&[u8]) -> Option<Arc<Vec<u8>>> + Send + 'static) -> Self {
        self.owner = Owner(Box::new(owner));
        self
    }

    /// Measures the components of a tree, and records the results as [`measured`](Self::measured) does.
    #[must_use]
    pub fn measuring(mut self, graph: &'static Graph) -> Self {
        let mut meter = CostMeter::new(graph);
        meter.switch(true);
        self.meter = Some(meter);
        self
    }

    /// Records what a meter measured in the last cycle: once a second the costs of the components, and in a loop with a clock a line of the
    /// log about each component that exceeded its budget, at most one a second.
    pub fn measured(&mut self, meter: &CostMeter) {
        for line in self.measured.overruns(meter) {
            self.log(line);
        }
        if let Some(costs) = self.measured.costs(meter) {
            self.costs(costs);
        }
    }

    /// Records a request that the observed loop has not applied itself.
    pub(crate) fn add_request(&mut self, request: RequestRecord) {
        self.requests.push(request);
    }

    /// Records an event of the run.
    pub fn event(&self, event: RunEvent) {
        self.queue.push(Entry::Event(event));
    }

    /// Records a line of text.
    pub fn log(&self, line: LogLine) {
        self.queue.push(Entry::Log(line));
    }

    /// Returns a function that records a line of text; it belongs to the cycle that has not [ended](Observer::acted).
    pub fn lines(&self) -> impl Fn(LogLine) + Send + use<> {
        let queue = Arc::clone(&self.queue);
        move |line| queue.push(Entry::Log(line))
    }

    /// Records the time of the components since the last call.
    pub fn costs(&self, costs: Costs) {
        self.queue.push(Entry::Costs(costs));
    }

    /// Sets the numbers of the result.
    pub fn set_figures(&mut self, figures: Vec<Figure>) {
        self.figures = figures;
    }

    /// Writes what is queued and closes the file. `result` is the result of the run, as text.
    #[must_use]
    pub fn finish(mut self, result: &str) -> Report {
        self.close(result)
    }

    fn close(&mut self, result: &str) -> Report {
        let (result, figures) = (result.to_owned(), std::mem::take(&mut self.figures));
        self.queue.close(Ending { result, figures, ..Ending::default() });
        let report = self.thread.take().map(JoinHandle::join);
        let failed = || Report { reason: Some(FAILED.to_owned()), ..Report::default() };
        report.map_or_else(Report::default, |report| report.unwrap_or_else(|_| failed()))
    }

    /// Adds large data, whose format is at a position of the sensor values, to the large data of the same cycle.
    fn take_blob(&self, blobs: &mut BlobValues, at: usize, bytes: &[u8]) {
        let owner = match blobs {
            // All large data of a cycle is kept, or none.
            BlobValues::Digest(hash) => return hash.update(bytes),
            _ => (self.owner.0)(bytes),
        };
        if matches!(blobs, BlobValues::None) {
            let has_room = match (self.stores_values, &owner) {
                (true, _) => self.queue.make_room(),
                // The thread computes the digest.
                (false, Some(_)) => self.queue.try_make_room(),
                (false, None) => false,
            };
            *blobs = if has_room { BlobValues::Kept(Vec::new()) } else { BlobValues::Digest(Hasher::new()) };
        }
        match blobs {
            BlobValues::Kept(kept) => {
                let data = owner.map_or_else(|| Data::Copy(self.copy(bytes)), Data::Shared);
                kept.push(KeptBlob { at, data });
            }
            BlobValues::Digest(hash) => hash.update(bytes),
            BlobValues::None => {}
        }
    }

    fn copy(&self, bytes: &[u8]) -> Vec<u8> {
        let mut copy = self.queue.take_buffer();
        copy.clear();
        copy.extend_from_slice(bytes);
        copy
    }
}

impl Drop for Recorder {
    fn drop(&mut self) {
        if self.thread.is_some() {
            self.close("");
        }
    }
}

impl<R: Recordable> Observer<R> for Recorder {
    fn clock_stepped(&mut self, _now: Instant, step: &ClockStep) {
        self.log(LogLine { level: 3, source: LogSource::Robot, text: step.to_string() });
    }

    fn requested(&mut self, _now: Instant, request: &Request<'_>) {
        self.requests.push(RequestRecord::new(*request, &self.actions));
    }

    fn refused(&mut self, _now: Instant, _request: &Request<'_>, refusal: &Refusal) {
        self.log(LogLine { level: 3, source: LogSource::Operator, text: format!("request refused: {refusal}") });
    }

    fn sensing(&mut self, _now: Instant, sensors: &R::Sensors<'_>) {
        if self.queue.has_ended() {
            return;
        }
        if let Some((_, blobs)) = self.sensing.take() {
            // The robot refused the values of the last cycle.
            self.queue.give_back(blobs);
        }
        let (mut blobs, out) = (BlobValues::None, Vec::with_capacity(self.message_bytes));
        let message = R::encode_sensors(sensors, out, |at, bytes| self.take_blob(&mut blobs, at, bytes));
        self.sensing = message.map(|message| (message, blobs));
    }

    fn acted(&mut self, cycle: &Cycle<'_, R>) {
        let Some((sensors, blobs)) = self.sensing.take() else { return };
        let sensor_bytes = sensors.len();
        // postcard refuses a type in every cycle or in none: the recording of a robot with such a type has no cycles.
        let Some(message) = R::encode_command(cycle.command, sensors) else { return self.queue.give_back(blobs) };
        self.message_bytes = self.message_bytes.max(message.len());
        read_tree(cycle.robot, &mut self.tree);
        // Offset by half a period: in a simulated world cycle 0 and each tenth cycle after it already have an image.
        let every = self.outputs_every;
        let due = every > 0 && (self.cycles + every / 2).is_multiple_of(every);
        let outputs = due.then(|| {
            let mut bytes = Vec::with_capacity(self.outputs_bytes);
            outputs::append(cycle.robot, &mut bytes);
            self.outputs_bytes = self.outputs_bytes.max(bytes.len());
            bytes
        });
        self.cycles += 1;
        let changed = self.tree != self.last_tree;
        if changed {
            self.last_tree.clone_from(&self.tree);
        }
        self.queue.push(Entry::Cycle(CycleValues {
            instant: cycle.now.as_ticks(),
            requests: std::mem::take(&mut self.requests),
            message,
            sensor_bytes,
            blobs,
            outputs,
            tree: changed.then(|| self.tree.clone()),
        }));
        if let Some(meter) = self.meter.take() {
            self.measured(&meter);
            self.meter = Some(meter);
        }
    }
}
