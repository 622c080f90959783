//! A V4L2 device.
//!
//! `moq-v4l` is the crate `v4l` with the kernel's constants checked in: `v4l` itself needs libclang. Its stream queues the last buffer
//! again when the next image is requested, also if the request before has timed out; then the kernel refuses the buffer. So a stream is
//! not used after an error ([`Device`]), which closes it, and with it all of its buffers.

use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::Duration;

use moq_v4l::buffer::{Flags, Type};
use moq_v4l::control::{Control, Value};
use moq_v4l::io::mmap::Stream;
use moq_v4l::io::traits::CaptureStream;
use moq_v4l::sys::{
    V4L2_CID_AUTO_WHITE_BALANCE, V4L2_CID_AUTOGAIN, V4L2_CID_EXPOSURE_ABSOLUTE, V4L2_CID_EXPOSURE_AUTO, V4L2_CID_GAIN,
    V4L2_CID_WHITE_BALANCE_TEMPERATURE,
};
use moq_v4l::video::Capture;
use moq_v4l::video::capture::Parameters;
use moq_v4l::{Format, FourCC};

use crate::device::{BYTES, Device, HEIGHT, Picture, STALL, WIDTH};
use crate::settings::{Setting, Settings};

/// Images a second.
const RATE: u32 = 30;
/// Number of buffers: one is copied, the driver fills the others.
const BUFFERS: u32 = 4;
/// `V4L2_EXPOSURE_AUTO`, `V4L2_EXPOSURE_MANUAL` and `V4L2_EXPOSURE_APERTURE_PRIORITY`: devices have one of the first and the last.
const EXPOSURE_MODES: [i64; 3] = [0, 1, 3];

/// Camera behind a device file.
pub(crate) struct Camera {
    /// `None` after it was closed.
    stream: Option<Stream<'static>>,
}

impl Camera {
    /// Opens a camera for 640×480 pixels in YUYV, 30 a second.
    ///
    /// # Errors
    /// If there is no such device, it has no such images, or refuses a setting.
    pub(crate) fn open(path: &Path, settings: &Settings) -> io::Result<Self> {
        let device = moq_v4l::Device::with_path(path)?;
        let wanted = Format::new(WIDTH.into(), HEIGHT.into(), FourCC::new(b"YUYV"));
        let format = device.set_format(&wanted)?;
        let is_packed = format.stride == 0 || format.stride == 2 * u32::from(WIDTH);
        if (format.width, format.height, format.fourcc) != (wanted.width, wanted.height, wanted.fourcc) || !is_packed {
            let what = format!("it has no images of {WIDTH}x{HEIGHT} in YUYV, but {format}");
            return Err(io::Error::new(io::ErrorKind::InvalidData, what));
        }
        device.set_params(&Parameters::with_fps(RATE))?;
        apply(&device, settings)?;
        let mut stream = Stream::with_buffers(&device, Type::VideoCapture, BUFFERS)?;
        stream.set_timeout(STALL);
        Ok(Self { stream: Some(stream) })
    }
}

impl Device for Camera {
    fn next(&mut self) -> io::Result<Picture> {
        let stream = self.stream.as_mut().ok_or(io::ErrorKind::NotConnected)?;
        let (bytes, meta) = stream.next()?;
        let used = usize::try_from(meta.bytesused).unwrap_or(BYTES).min(bytes.len());
        let is_monotonic = meta.flags & Flags::TIMESTAMP_MASK == Flags::TIMESTAMP_MONOTONIC;
        Ok(Picture {
            taken: if is_monotonic { Duration::from(meta.timestamp) } else { crate::monotonic() },
            is_damaged: meta.flags.contains(Flags::ERROR),
            pixels: bytes[..used].to_vec(),
        })
    }
}

impl Drop for Camera {
    fn drop(&mut self) {
        let stream = self.stream.take();
        // The stream panics if the driver does not let it go: then the device cannot be opened again, and that has its message.
        _ = catch_unwind(AssertUnwindSafe(move || drop(stream)));
    }
}

/// Sets what is fixed, and lets the camera choose the rest.
fn apply(device: &moq_v4l::Device, settings: &Settings) -> io::Result<()> {
    let set = |id: u32, value: i64| device.set_control(Control { id, value: Value::Integer(value) });
    let fix = |name: &str, automatic: u32, manual: i64, id: u32, value: u16| {
        // A camera without an automatic for this has no switch for it.
        _ = set(automatic, manual);
        let refused = |error: io::Error| io::Error::new(error.kind(), format!("it refuses {name}={value}: {error}"));
        set(id, value.into()).map_err(refused)
    };
    let [auto, manual, aperture] = EXPOSURE_MODES;
    match settings.exposure {
        Setting::Auto => _ = set(V4L2_CID_EXPOSURE_AUTO, aperture).or_else(|_| set(V4L2_CID_EXPOSURE_AUTO, auto)),
        Setting::Fixed(value) => {
            fix("exposure", V4L2_CID_EXPOSURE_AUTO, manual, V4L2_CID_EXPOSURE_ABSOLUTE, value)?;
        }
    }
    match settings.gain {
        Setting::Auto => _ = set(V4L2_CID_AUTOGAIN, 1),
        Setting::Fixed(value) => fix("gain", V4L2_CID_AUTOGAIN, 0, V4L2_CID_GAIN, value)?,
    }
    match settings.white_balance {
        Setting::Auto => _ = set(V4L2_CID_AUTO_WHITE_BALANCE, 1),
        Setting::Fixed(value) => {
            fix("white-balance", V4L2_CID_AUTO_WHITE_BALANCE, 0, V4L2_CID_WHITE_BALANCE_TEMPERATURE, value)?;
        }
    }
    Ok(())
}
