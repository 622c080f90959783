//! The thread of a camera.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use crate::device::{Device, Picture, STALL};

/// Time between two attempts to open a camera.
const RETRY: Duration = Duration::from_millis(200);

/// Camera that is read. Its thread ends with this value.
pub(crate) struct Capture {
    is_over: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Capture {
    /// Starts the thread, which opens the camera, again whenever it fails, and gives usable images to `put`. `name` is that of the device
    /// in lines for people.
    ///
    /// # Errors
    /// If there is no thread.
    pub(crate) fn start<D: Device>(
        name: String,
        mut open: impl FnMut() -> io::Result<D> + Send + 'static,
        mut put: impl FnMut(Picture) + Send + 'static,
        say: fn(&str),
    ) -> io::Result<Self> {
        let is_over = Arc::new(AtomicBool::new(false));
        let ends = Arc::clone(&is_over);
        let thread = thread::Builder::new().name("camera".to_owned()).spawn(move || {
            let mut told = None;
            while !ends.load(Ordering::Relaxed) {
                let mut count = 0_u64;
                let read = open().and_then(|camera| {
                    read(camera, &ends, |picture| {
                        if count == 0 && told.take().is_some() {
                            say(&format!("camera {name}: it gives images again"));
                        }
                        count += 1;
                        put(picture);
                    })
                });
                let Err(error) = read else { return };
                // A camera that is missing is tried for as long as it is: one line is enough.
                let error = error.to_string();
                if told.as_ref() != Some(&error) {
                    say(&format!("camera {name} is opened again: {error}"));
                    told = Some(error);
                }
                thread::sleep(RETRY);
            }
        })?;
        Ok(Self { is_over, thread: Some(thread) })
    }
}

impl Drop for Capture {
    fn drop(&mut self) {
        self.is_over.store(true, Ordering::Relaxed);
        // A panic of it has printed its message.
        _ = self.thread.take().map(JoinHandle::join);
    }
}

/// Reads images until the end of the program.
fn read(mut camera: impl Device, ends: &AtomicBool, mut put: impl FnMut(Picture)) -> io::Result<()> {
    let mut last = Instant::now();
    while !ends.load(Ordering::Relaxed) {
        let picture = camera.next()?;
        if picture.is_usable() {
            last = Instant::now();
            put(picture);
        } else if last.elapsed() >= STALL {
            return Err(io::Error::new(io::ErrorKind::InvalidData, "its images are damaged, or have another size"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;
    use std::sync::mpsc::{Receiver, channel};

    use super::*;
    use crate::device::BYTES;

    /// Longest wait for an image.
    const WAIT: Duration = Duration::from_secs(20);
    /// Lines of the tests' cameras.
    static LINES: Mutex<Vec<String>> = Mutex::new(Vec::new());

    /// What a camera does when an image is requested.
    #[derive(Clone, Copy)]
    enum Act {
        Gives,
        Damaged,
        Short,
        Stalls,
        Fails,
    }

    /// Camera that plays its acts, then gives images for ever.
    struct Fake {
        acts: Vec<Act>,
        count: u32,
        has_failed: bool,
    }

    impl Device for Fake {
        fn next(&mut self) -> io::Result<Picture> {
            assert!(!self.has_failed, "a camera is used after an error");
            thread::sleep(Duration::from_millis(10));
            let act = self.acts.pop().unwrap_or(Act::Gives);
            self.has_failed = matches!(act, Act::Stalls | Act::Fails);
            let mut picture =
                Picture { taken: Duration::from_secs(self.count.into()), is_damaged: false, pixels: vec![0; BYTES] };
            match act {
                Act::Gives => self.count += 1,
                Act::Damaged => picture.is_damaged = true,
                Act::Short => picture.pixels.truncate(100),
                Act::Stalls => return Err(io::ErrorKind::TimedOut.into()),
                Act::Fails => return Err(io::Error::other("no such device")),
            }
            Ok(picture)
        }
    }

    /// Cameras that are opened one after the other, each with its acts; `None` cannot be opened.
    fn start(name: &str, cameras: Vec<Option<Vec<Act>>>) -> (Capture, Receiver<Picture>) {
        let (pictures, received) = channel();
        let mut cameras = cameras.into_iter();
        let open = move || match cameras.next() {
            Some(None) => Err(io::ErrorKind::NotFound.into()),
            acts => Ok(Fake { acts: acts.flatten().unwrap_or_default(), count: 0, has_failed: false }),
        };
        let say = |text: &str| LINES.lock().expect("no panic").push(text.to_owned());
        let capture = Capture::start(name.to_owned(), open, move |picture| _ = pictures.send(picture), say);
        (capture.expect("a thread"), received)
    }

    /// Times of the next images, s: a camera that was opened again begins at 0.
    fn times(pictures: &Receiver<Picture>, count: usize) -> Vec<u64> {
        (0..count).map(|_| pictures.recv_timeout(WAIT).expect("an image").taken.as_secs()).collect()
    }

    fn lines_of(name: &str) -> usize {
        LINES.lock().expect("no panic").iter().filter(|line| line.contains(name)).count()
    }

    #[test]
    fn failed_camera_is_opened_again_with_two_lines() {
        for (name, act) in [("stalled", Act::Stalls), ("lost", Act::Fails)] {
            let (_capture, pictures) = start(name, vec![Some(vec![act, Act::Gives, Act::Gives])]);
            assert_eq!(times(&pictures, 5), [0, 1, 0, 1, 2], "{name}");
            assert_eq!(lines_of(name), 2, "{name}");
        }
    }

    #[test]
    fn missing_camera_is_retried_and_told_once() {
        let (_capture, pictures) = start("unplugged", vec![None, None, None]);
        assert_eq!(times(&pictures, 2), [0, 1]);
        assert_eq!(lines_of("unplugged"), 2);
    }

    #[test]
    fn unusable_images_are_dropped() {
        let (_capture, pictures) = start("noisy", vec![Some(vec![Act::Gives, Act::Short, Act::Damaged, Act::Gives])]);
        assert_eq!(times(&pictures, 3), [0, 1, 2]);
        assert_eq!(lines_of("noisy"), 0);
    }

    #[test]
    fn camera_without_usable_images_is_opened_again() {
        // 100 images of 10 ms last twice as long as a camera may be without a usable one.
        let (_capture, pictures) = start("broken", vec![Some([vec![Act::Short; 100], vec![Act::Gives]].concat())]);
        assert_eq!(times(&pictures, 3), [0, 0, 1]);
        assert_eq!(lines_of("another size"), 1);
    }
}
