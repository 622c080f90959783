//! Images of a robot, wherever they come from.

use std::io;
use std::path::PathBuf;

use bica_motion::robot::CameraId;

use crate::cameras::Cameras;
use crate::frames::{Frame, Socket};
use crate::settings::Settings;

/// Where a robot's images come from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A Unix stream socket that the robot's side serves.
    Socket(PathBuf),
    /// V4L2 devices of the robot itself, top and bottom camera.
    Cameras([PathBuf; 2], Settings),
}

/// Images of a robot, read by threads that end with this value.
pub struct Images(Source);

enum Source {
    Socket(Socket),
    Cameras(Cameras),
}

impl Images {
    /// Starts the threads. A socket or a device that is missing, or fails, is opened again for as long as this value lives.
    ///
    /// # Errors
    /// If there is no thread, or this program was built without cameras: they need Linux and the feature `v4l`.
    pub fn start(origin: Origin, say: fn(&str)) -> io::Result<Self> {
        Ok(Self(match origin {
            Origin::Socket(path) => Source::Socket(Socket::start(path, say)?),
            #[cfg(all(feature = "v4l", target_os = "linux"))]
            Origin::Cameras(devices, settings) => Source::Cameras(Cameras::start(devices, settings, say)?),
            #[cfg(not(all(feature = "v4l", target_os = "linux")))]
            Origin::Cameras(..) => {
                return Err(io::Error::new(io::ErrorKind::Unsupported, "this program was built without cameras"));
            }
        }))
    }

    /// Takes the newest image of a camera that belongs to the sensor map of this number, counted from 0 by this program, or to an earlier
    /// one. Older images are dropped. With `is_complete` those of a socket are read first that the robot has sent before, so that the
    /// result does not depend on the speed of the computer.
    #[must_use]
    pub fn take(&self, camera: CameraId, number: u32, is_complete: bool) -> Option<Frame> {
        match &self.0 {
            Source::Socket(socket) => socket.take(camera, number, is_complete),
            Source::Cameras(cameras) => cameras.take(camera, crate::monotonic()),
        }
    }
}
