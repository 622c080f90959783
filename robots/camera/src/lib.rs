#![doc = include_str!("../README.md")]
#![cfg(unix)]
#![cfg_attr(
    not(all(feature = "v4l", target_os = "linux")),
    expect(dead_code, reason = "without devices, tests read cameras only")
)]

mod cameras;
mod capture;
mod device;
mod frames;
mod images;
mod settings;
mod upright;
#[cfg(all(feature = "v4l", target_os = "linux"))]
mod v4l;

use std::time::Duration;

use nix::time::{ClockId, clock_gettime};

pub use frames::{Frame, Header};
pub use images::{Images, Origin};
pub use settings::{Setting, Settings};

/// Time of `CLOCK_MONOTONIC`, with which drivers of cameras stamp their images; zero on a system without this clock.
#[must_use]
pub fn monotonic() -> Duration {
    clock_gettime(ClockId::CLOCK_MONOTONIC).map_or(Duration::ZERO, Duration::from)
}
