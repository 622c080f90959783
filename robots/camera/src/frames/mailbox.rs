//! The newest images of both cameras.

use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use bica_motion::robot::{CameraId, Image};

use super::header::Header;

/// Number of images of a camera that wait for their cycle.
const WAITING: usize = 3;

/// An image with its pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Its header.
    pub header: Header,
    /// When it was taken, of `CLOCK_MONOTONIC`; `None`: at the sensor map of its number.
    pub taken: Option<Duration>,
    /// YUYV 4:2:2, rows from the top: [`Header::pixel_bytes`].
    pub pixels: Vec<u8>,
}

impl Frame {
    /// The image for a robot program.
    #[must_use]
    pub fn image(&self) -> Image<'_> {
        let Header { camera, width, height, .. } = self.header;
        Image { camera, width, height, yuyv: &self.pixels }
    }
}

/// Mailbox between the thread that reads images and the cycles.
#[derive(Debug, Default)]
pub(crate) struct Mailbox(Mutex<Waiting>);

#[derive(Debug, Default)]
struct Waiting {
    frames: Vec<Frame>,
    /// Number of the robot's maps before the first one that this program received.
    missed: u32,
    /// Whether an image was too new in the last cycle.
    was_early: bool,
}

impl Mailbox {
    /// Adds an image; drops the oldest one of its camera if too many wait.
    pub(crate) fn put(&self, frame: Frame) {
        let frames = &mut self.0.lock().unwrap_or_else(PoisonError::into_inner).frames;
        let is_same = |other: &Frame| other.header.camera == frame.header.camera;
        if frames.iter().filter(|other| is_same(other)).count() >= WAITING
            && let Some(oldest) = frames.iter().position(is_same)
        {
            frames.remove(oldest);
        }
        frames.push(frame);
    }

    /// Takes the newest image of a camera that belongs to the map of this number, counted from 0 by this program, or to an earlier one.
    /// Older images of both cameras are dropped.
    ///
    /// The robot may have sent maps that were not received, so its count is ahead: an image that is too new in two cycles in a row shows
    /// by how many.
    pub(crate) fn take(&self, camera: CameraId, number: u32) -> Option<Frame> {
        let waiting = &mut *self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let newest = waiting.frames.iter().map(|frame| frame.header.number).max()?;
        let is_early = newest > number.saturating_add(waiting.missed);
        let is_learnt = is_early && waiting.was_early;
        if is_learnt {
            waiting.missed = newest.saturating_sub(number);
        }
        waiting.was_early = is_early && !is_learnt;
        let due = number.saturating_add(waiting.missed);
        let is_due = |frame: &Frame| frame.header.number <= due;
        let taken = waiting.frames.iter().rposition(|frame| is_due(frame) && frame.header.camera == camera);
        let taken = taken.map(|index| waiting.frames.remove(index));
        waiting.frames.retain(|frame| !is_due(frame));
        taken
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn put(mailbox: &Mailbox, camera: CameraId, number: u32) {
        let header = Header { camera, width: 320, height: 240, number };
        mailbox.put(Frame { header, taken: None, pixels: vec![0; header.pixel_bytes()] });
    }

    fn take(mailbox: &Mailbox, camera: CameraId, number: u32) -> Option<u32> {
        mailbox.take(camera, number).map(|frame| frame.header.number)
    }

    #[test]
    fn newest_due_image_of_the_camera_is_taken_once() {
        let mailbox = Mailbox::default();
        put(&mailbox, CameraId::Top, 0);
        put(&mailbox, CameraId::Top, 3);
        put(&mailbox, CameraId::Bottom, 3);
        put(&mailbox, CameraId::Top, 5);
        assert_eq!(take(&mailbox, CameraId::Top, 4), Some(3));
        assert_eq!(take(&mailbox, CameraId::Bottom, 5), None, "it was older than what was taken");
        put(&mailbox, CameraId::Bottom, 6);
        assert_eq!(take(&mailbox, CameraId::Bottom, 6), Some(6));
        assert_eq!(take(&mailbox, CameraId::Bottom, 7), None);
    }

    #[test]
    fn count_of_a_running_robot_is_learnt() {
        let mailbox = Mailbox::default();
        put(&mailbox, CameraId::Top, 5000);
        assert_eq!(take(&mailbox, CameraId::Top, 0), None, "it may belong to the next map");
        assert_eq!(take(&mailbox, CameraId::Top, 1), Some(5000));
        put(&mailbox, CameraId::Top, 5003);
        assert_eq!(take(&mailbox, CameraId::Top, 3), None);
        assert_eq!(take(&mailbox, CameraId::Top, 4), Some(5003));
    }

    #[test]
    fn waiting_images_are_few() {
        let mailbox = Mailbox::default();
        (100..200).for_each(|number| put(&mailbox, CameraId::Top, number));
        assert_eq!(mailbox.0.lock().expect("no panic").frames.len(), WAITING);
    }
}
