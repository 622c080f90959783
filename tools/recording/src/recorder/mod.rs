//! Recording beside a running loop.

mod output;
mod queue;
mod sink;
mod syncer;
mod thread;

use std::sync::Arc;
use std::thread::JoinHandle;
use std::{fmt, io};

use bica::refusal::Refusal;
use bica::runner::{Cycle, Observer, Request, Robot};
use bica::{ComponentId, Instant, Probe, Tree};
use bica_motion::robot::{self, CameraId};
use bica_wire::message::{Command, Sensors};

use crate::digest::image_digest;
use crate::header::{Header, ImagePolicy};
use crate::information;
use crate::message::{Costs, LogLine, RefereeEvent, TreeRecord};
use crate::request::RequestRecord;
pub(crate) use output::Output;
use queue::{CycleValues, Entry, ImageValues, Queue};
pub use sink::{Sink, Syncing, create};
pub(crate) use thread::{begin, compression, encode, write_ending};

/// What a recorder does when its queue is full because the disk is slow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backpressure {
    /// The loop waits: for simulations without a clock.
    Wait,
    /// The loop goes on. An image is dropped and counted; if even the values of a cycle find no room, the recording ends.
    Drop,
}

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
    /// Number of cycles from one record of information to the next; 0: none.
    pub information_every: u64,
}

impl Default for RecorderOptions {
    fn default() -> Self {
        Self { backpressure: Backpressure::Drop, cycles: 6000, images: 32, chunk_bytes: 1 << 20, information_every: 10 }
    }
}

/// Result of a recording.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// Number of cycles in the file.
    pub cycles: u64,
    /// Length of the file, bytes.
    pub bytes: u64,
    /// Number of images that were dropped because the disk was slow.
    pub dropped_images: u64,
    /// Why the recording ended before the run; none if it did not.
    pub reason: Option<String>,
}

/// Observer of a loop that records it.
///
/// The loop copies the values of a cycle into a queue, images without an [owner](Self::sharing_images) included, and never waits
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
    information_every: u64,
    /// Size of the largest record of information so far.
    information_bytes: usize,
    next_image: u32,
    requests: Vec<RequestRecord>,
    sensing: Option<(Sensors, ImageValues)>,
    owner: Owner,
}

/// Function that returns the owner of the pixels of an image.
struct Owner(Box<OwnerOf>);

type OwnerOf = dyn Fn(&[u8]) -> Option<Arc<Vec<u8>>> + Send;

impl fmt::Debug for Owner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Owner")
    }
}

impl Recorder {
    /// Writes the header to `sink` and starts the thread. `on_end` is called there with the reason if the recording ends
    /// before the run.
    ///
    /// # Errors
    /// If the header cannot be written or no thread can be started.
    pub fn start(
        sink: impl Sink + 'static,
        header: &Header,
        options: RecorderOptions,
        on_end: impl Fn(&str) + Send + 'static,
    ) -> io::Result<Self> {
        let queue = Arc::new(Queue::new(options));
        let writing = thread::Writing::new(sink, header, options.chunk_bytes)?;
        let shared = Arc::clone(&queue);
        let work = move || writing.run(&shared, &on_end);
        let thread = std::thread::Builder::new().name("recorder".to_owned()).spawn(work)?;
        Ok(Self {
            queue,
            thread: Some(thread),
            stores_values: header.images == ImagePolicy::All,
            tree: TreeRecord::default(),
            last_tree: TreeRecord::default(),
            cycles: 0,
            information_every: options.information_every,
            information_bytes: 0,
            next_image: 0,
            requests: Vec::new(),
            sensing: None,
            owner: Owner(Box::new(|_| None)),
        })
    }

    /// Sets a function that returns the owner of the pixels of an image, if they have one that is never changed again. Then the
    /// recorder keeps the owner, and the loop copies nothing.
    #[must_use]
    pub fn sharing_images(mut self, owner: impl Fn(&[u8]) -> Option<Arc<Vec<u8>>> + Send + 'static) -> Self {
        self.owner = Owner(Box::new(owner));
        self
    }

    /// Records that the ball of the simulated world was placed before the next cycle, m, field frame.
    pub fn ball_placed(&mut self, [x, y]: [f32; 2]) {
        self.requests.push(RequestRecord::Ball { x, y });
    }

    /// Records an event of the referee.
    pub fn event(&self, event: RefereeEvent) {
        self.queue.push(Entry::Event(event));
    }

    /// Records a line of text.
    pub fn log(&self, line: LogLine) {
        self.queue.push(Entry::Log(line));
    }

    /// Records the time of the components since the last call.
    pub fn costs(&self, costs: Costs) {
        self.queue.push(Entry::Costs(costs));
    }

    /// Writes what is queued and closes the file. `result` is the result of the run, as text.
    #[must_use]
    pub fn finish(mut self, result: &str) -> Report {
        self.close(result)
    }

    fn close(&mut self, result: &str) -> Report {
        self.queue.close(result);
        let report = self.thread.take().map(JoinHandle::join);
        let failed = || Report { reason: Some("the thread of the recorder failed".to_owned()), ..Report::default() };
        report.map_or_else(Report::default, |report| report.unwrap_or_else(|_| failed()))
    }

    fn image(&self, image: &robot::Image<'_>) -> ImageValues {
        let robot::Image { camera, width, height, yuyv } = *image;
        let bottom = camera == CameraId::Bottom;
        let digest = || ImageValues::Digest(image_digest(bottom, width, height, yuyv));
        let owner = (self.owner.0)(yuyv);
        let has_room = match (self.stores_values, &owner) {
            (true, _) => self.queue.make_room(),
            // The thread computes the digest.
            (false, Some(_)) => self.queue.try_make_room(),
            (false, None) => false,
        };
        if !has_room {
            return digest();
        }
        owner.map_or_else(
            || {
                let mut pixels = self.queue.take_buffer();
                pixels.clear();
                pixels.extend_from_slice(yuyv);
                ImageValues::Pixels(pixels)
            },
            ImageValues::Shared,
        )
    }
}

impl Drop for Recorder {
    fn drop(&mut self) {
        if self.thread.is_some() {
            self.close("");
        }
    }
}

impl Probe for Recorder {}

impl<R> Observer<R> for Recorder
where
    R: for<'a> Robot<Sensors<'a> = robot::Sensors<'a>> + Robot<Command = robot::Command>,
{
    fn requested(&mut self, _now: Instant, request: &Request<'_>) {
        self.requests.push(RequestRecord::from(request));
    }

    fn refused(&mut self, _now: Instant, _request: &Request<'_>, refusal: &Refusal) {
        self.log(LogLine { level: 3, text: format!("request refused: {refusal}") });
    }

    fn sensing(&mut self, now: Instant, sensors: &robot::Sensors<'_>) {
        if self.queue.has_ended() {
            return;
        }
        if let Some((_, image)) = self.sensing.take() {
            // The robot refused the values of the last cycle.
            self.queue.give_back(image);
        }
        let image = sensors.image.as_ref().map_or(ImageValues::None, |image| self.image(image));
        self.next_image = self.next_image.wrapping_add(u32::from(sensors.image.is_some()));
        self.sensing = Some((Sensors::new(now.as_micros(), sensors, self.next_image), image));
    }

    fn acted(&mut self, cycle: &Cycle<'_, R>) {
        let Some((sensors, image)) = self.sensing.take() else { return };
        read_tree(cycle.robot, &mut self.tree);
        // Half a period later: in a simulated world cycle 0 and each tenth after it have an image already.
        let every = self.information_every;
        let due = every > 0 && (self.cycles + every / 2).is_multiple_of(every);
        let information = due.then(|| {
            let mut bytes = Vec::with_capacity(self.information_bytes);
            information::append(cycle.robot, &mut bytes);
            self.information_bytes = self.information_bytes.max(bytes.len());
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
            sensors,
            image,
            command: Command::new(cycle.now.as_micros(), cycle.command),
            information,
            tree: changed.then(|| self.tree.clone()),
        }));
    }
}

/// Returns active components and states of a tree.
#[must_use]
pub fn tree_record<T: Tree>(tree: &T) -> TreeRecord {
    let mut record = TreeRecord::default();
    read_tree(tree, &mut record);
    record
}

/// Reads active components and states of a tree into a record whose memory is used again.
fn read_tree<T: Tree>(tree: &T, record: &mut TreeRecord) {
    record.active.clear();
    record.active.resize(T::COUNT.div_ceil(8), 0);
    record.states.clear();
    for index in 0..T::COUNT {
        let id = ComponentId::new(index);
        record.active[index / 8] |= u8::from(tree.is_active_at(id)) << (index % 8);
        record.states.push(tree.state(id).map_or(u8::MAX, |state| state as u8));
    }
}
