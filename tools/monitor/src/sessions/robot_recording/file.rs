//! A file that is written while data of a robot are received.

use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use bica::{Blob, Format};
use bica_recording::{Header, MonitorRecorder, RecordedCycle, create};

use crate::pages::lock;
use crate::program::Image;

/// Largest number of cycles and images that wait for the disk: 40 s at 100 Hz.
const QUEUE: usize = 4096;
/// Largest number of images that wait for the disk.
const IMAGES: usize = 32;
/// Interval of checks whether data have waited long enough to be written.
const POLL: Duration = Duration::from_millis(50);

/// Returns the first of `FILE`, `FILE-2`, `FILE-3` and so on that does not exist.
pub(in crate::sessions) fn unused(path: &Path) -> PathBuf {
    let (stem, ending) = (path.file_stem().unwrap_or_default(), path.extension().unwrap_or_default());
    let (stem, ending) = (stem.to_string_lossy(), ending.to_string_lossy());
    let numbered = |number: u32| path.with_file_name(format!("{stem}-{number}.{ending}"));
    std::iter::once(path.to_owned()).chain((2..=u32::MAX).map(numbered)).find(|path| !path.exists()).unwrap_or_default()
}

/// Writes an image of a session.
pub(in crate::sessions) fn write_image(recorder: &mut MonitorRecorder<File>, image: &Image) -> io::Result<()> {
    let Image { number, time_us, ref camera, width, height, ref yuyv } = *image;
    recorder.image(number, time_us, &Blob { bytes: yuyv, format: Format::Yuyv { width, height }, frame: camera })
}

enum Entry {
    Cycle(Box<RecordedCycle>),
    Image(Image),
}

/// State that the session's thread and the writing thread share.
#[derive(Debug, Default)]
struct Progress {
    bytes: AtomicU64,
    /// Number of images that wait.
    waiting: AtomicUsize,
    dropped: AtomicU64,
    /// Why the file has ended early.
    ended: Mutex<Option<String>>,
}

/// A file that is written by its own thread.
pub(super) struct WrittenFile {
    pub(super) path: PathBuf,
    entries: Option<SyncSender<Entry>>,
    thread: Option<JoinHandle<()>>,
    progress: Arc<Progress>,
}

impl WrittenFile {
    /// Creates a file that does not exist yet. If that fails, [`note`](Self::note) contains the reason.
    pub(super) fn new(path: PathBuf, header: Header) -> Self {
        let (entries, received) = sync_channel(QUEUE);
        let progress = Arc::<Progress>::default();
        let (own, file) = (Arc::clone(&progress), path.clone());
        let work = move || {
            let result = create(&file, false)
                .map_err(|error| format!("cannot make the file: {error}"))
                .and_then(|file| write(file, &header, &received, &own));
            if let Err(reason) = result {
                lock(&own.ended).get_or_insert(reason);
            }
        };
        let started = thread::Builder::new().name("robot recorder".to_owned()).spawn(work);
        let thread = started.map_err(|error| *lock(&progress.ended) = Some(error.to_string())).ok();
        Self { path, entries: Some(entries), thread, progress }
    }

    pub(super) fn cycle(&mut self, cycle: RecordedCycle) {
        self.send(Entry::Cycle(Box::new(cycle)));
    }

    /// Adds an image. If too many images wait, it is dropped and counted.
    pub(super) fn image(&mut self, image: Image) {
        if self.progress.waiting.fetch_add(1, Ordering::Relaxed) < IMAGES {
            self.send(Entry::Image(image));
        } else {
            self.progress.waiting.fetch_sub(1, Ordering::Relaxed);
            self.progress.dropped.fetch_add(1, Ordering::Relaxed);
        }
    }

    /// Passes an entry to the thread, without waiting for the disk.
    fn send(&mut self, entry: Entry) {
        let Some(entries) = &self.entries else { return };
        match entries.try_send(entry) {
            Ok(()) => return,
            Err(TrySendError::Full(_)) => {
                lock(&self.progress.ended).get_or_insert_with(|| "the disk is too slow".to_owned());
            }
            // The thread has stored the reason.
            Err(TrySendError::Disconnected(_)) => {}
        }
        self.entries = None;
    }

    /// Returns the length so far, bytes.
    pub(super) fn bytes(&self) -> u64 {
        self.progress.bytes.load(Ordering::Relaxed)
    }

    /// Returns why the file has ended early, or which data were lost; empty if there is no problem.
    pub(super) fn note(&self) -> String {
        let path = self.path.display();
        match (&*lock(&self.progress.ended), self.progress.dropped.load(Ordering::Relaxed)) {
            (Some(reason), _) => format!("the recording in `{path}` has ended: {reason}"),
            (None, 0) => String::new(),
            (None, count) => format!("{count} images are not in `{path}`, as the disk is slow"),
        }
    }
}

impl Drop for WrittenFile {
    fn drop(&mut self) {
        self.entries = None;
        if let Some(thread) = self.thread.take() {
            // A thread that has panicked leaves all complete chunks in the file.
            let _ = thread.join();
        }
    }
}

/// Writes until there are no more entries; the error is the reason of an earlier end.
fn write(file: File, header: &Header, entries: &Receiver<Entry>, progress: &Progress) -> Result<(), String> {
    let failed = |error: io::Error| format!("cannot write: {error}");
    let mut recorder = MonitorRecorder::new(file, header).map_err(failed)?;
    let reason = loop {
        let result = match entries.recv_timeout(POLL) {
            Ok(Entry::Cycle(cycle)) => recorder.cycle(&cycle),
            Ok(Entry::Image(image)) => {
                progress.waiting.fetch_sub(1, Ordering::Relaxed);
                write_image(&mut recorder, &image)
            }
            Err(RecvTimeoutError::Timeout) => Ok(()),
            Err(RecvTimeoutError::Disconnected) => break lock(&progress.ended).clone().map_or(Ok(()), Err),
        };
        if let Err(error) = result.and_then(|()| recorder.write_if_due()) {
            break Err(failed(error));
        }
        progress.bytes.store(recorder.length(), Ordering::Relaxed);
    };
    if let Err(reason) = &reason {
        // Pages receive the reason before the file is closed, which may take long.
        lock(&progress.ended).get_or_insert_with(|| reason.clone());
    }
    let report = recorder.finish(reason.err(), progress.dropped.load(Ordering::Relaxed));
    report.reason.map_or(Ok(()), Err)
}
