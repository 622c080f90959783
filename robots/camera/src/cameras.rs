//! Both cameras of a robot.

use std::io;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use bica_motion::robot::CameraId;

use crate::capture::Capture;
use crate::device::{Device, HEIGHT, Picture, STALL, WIDTH};
use crate::frames::{Frame, Header};
#[cfg(all(feature = "v4l", target_os = "linux"))]
use crate::settings::Settings;
use crate::upright;

/// Newest image of each camera.
type Newest = Arc<Mutex<[Option<Frame>; 2]>>;

/// Top and bottom camera, each read by a thread of its own, which ends with this value.
pub(crate) struct Cameras {
    newest: Newest,
    _captures: [Capture; 2],
}

impl Cameras {
    /// Starts to read two devices: the top camera, which is built in upside down, and the bottom one. A device that is missing or fails is
    /// opened again, for as long as this value lives.
    ///
    /// # Errors
    /// If there is no thread.
    #[cfg(all(feature = "v4l", target_os = "linux"))]
    pub(crate) fn start(devices: [PathBuf; 2], settings: Settings, say: fn(&str)) -> io::Result<Self> {
        Self::start_with(devices, move |path| crate::v4l::Camera::open(path, &settings), say)
    }

    pub(crate) fn start_with<D: Device>(
        devices: [PathBuf; 2],
        open: impl Fn(&PathBuf) -> io::Result<D> + Clone + Send + 'static,
        say: fn(&str),
    ) -> io::Result<Self> {
        let newest = Newest::default();
        let start = |camera: CameraId, path: PathBuf| {
            let (open, newest) = (open.clone(), Arc::clone(&newest));
            let name = path.display().to_string();
            Capture::start(name, move || open(&path), move |picture| put(&newest, camera, picture), say)
        };
        let [top, bottom] = devices;
        let captures = [start(CameraId::Top, top)?, start(CameraId::Bottom, bottom)?];
        Ok(Self { newest, _captures: captures })
    }

    /// Takes the newest image of a camera, if it is new and not older than half a second at the time `now` of `CLOCK_MONOTONIC`.
    pub(crate) fn take(&self, camera: CameraId, now: Duration) -> Option<Frame> {
        let mut newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
        newest[camera as usize]
            .take()
            .filter(|frame| frame.taken.is_some_and(|taken| now.saturating_sub(taken) <= STALL))
    }
}

fn put(newest: &Newest, camera: CameraId, picture: Picture) {
    let Picture { taken, mut pixels, .. } = picture;
    if camera == CameraId::Top {
        upright::turn(&mut pixels);
    }
    let header = Header { camera, width: WIDTH, height: HEIGHT, number: 0 };
    let frame = Frame { header, taken: Some(taken), pixels };
    newest.lock().unwrap_or_else(PoisonError::into_inner)[camera as usize] = Some(frame);
}

#[cfg(test)]
mod tests {
    use std::thread;
    use std::time::Instant;

    use super::*;
    use crate::device::BYTES;

    /// Camera with one image, whose first byte is 9.
    struct Once(bool);

    impl Device for Once {
        fn next(&mut self) -> io::Result<Picture> {
            if std::mem::replace(&mut self.0, true) {
                thread::sleep(Duration::from_millis(10));
                return Err(io::ErrorKind::TimedOut.into());
            }
            let mut pixels = vec![0; BYTES];
            pixels[0] = 9;
            Ok(Picture { taken: Duration::from_secs(7), is_damaged: false, pixels })
        }
    }

    /// Takes an image, at most 20 s after it was requested.
    fn take(cameras: &Cameras, camera: CameraId, now: u64) -> Option<Frame> {
        let start = Instant::now();
        while cameras.newest.lock().expect("no panic")[camera as usize].is_none() {
            assert!(start.elapsed() < Duration::from_secs(20), "no image");
            thread::sleep(Duration::from_millis(5));
        }
        cameras.take(camera, Duration::from_millis(now))
    }

    fn start() -> Cameras {
        let open = |_: &PathBuf| Ok(Once(false));
        Cameras::start_with(["top".into(), "bottom".into()], open, |_| ()).expect("threads")
    }

    #[test]
    fn top_camera_is_turned_and_the_bottom_one_is_not() {
        let cameras = start();
        for (camera, at) in [(CameraId::Top, BYTES - 2), (CameraId::Bottom, 0)] {
            let taken = take(&cameras, camera, 7000).expect("an image");
            let image = taken.image();
            assert_eq!((image.camera, image.width, image.height), (camera, 640, 480));
            assert_eq!(taken.taken, Some(Duration::from_secs(7)));
            assert_eq!(image.yuyv.iter().position(|&byte| byte == 9), Some(at), "{camera:?}");
        }
    }

    #[test]
    fn old_image_is_not_given() {
        let cameras = start();
        assert!(take(&cameras, CameraId::Top, 7501).is_none());
        assert!(take(&cameras, CameraId::Bottom, 7500).is_some());
    }
}
