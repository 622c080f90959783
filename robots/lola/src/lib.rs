#![doc = include_str!("../README.md")]

mod actuator_map;
mod buffer;
#[cfg(unix)]
mod connection;
#[cfg(unix)]
mod cycle;
#[cfg(unix)]
mod driver;
mod ending;
#[cfg(unix)]
mod guard;
#[cfg(unix)]
mod heads;
mod identity;
mod limiter;
mod mistake;
#[cfg(unix)]
mod options;
#[cfg(unix)]
mod pace;
mod phase;
mod posture;
mod reader;
mod sensor_map;
#[cfg(unix)]
mod world;
mod writer;

pub use actuator_map::ActuatorMap;
#[cfg(unix)]
pub use bica_camera as camera;
pub use buffer::{Found, MapBuffer};
pub use ending::{Reason, Watch};
#[cfg(unix)]
pub use guard::guard;
pub use identity::Identity;
pub use limiter::Limiter;
pub use mistake::{Mistake, Undecoded};
#[cfg(unix)]
pub use options::{Options, PATIENCE, Standing};
pub use posture::{SITTING_HEIGHT, hip_height};
pub use sensor_map::{SENSOR_MAP_BYTES, SensorMap};
#[cfg(unix)]
pub use world::LolaWorld;

/// Time from one sensor map to the next, µs: 83.3 Hz. Source: B-Human 2023 `motionCycleTime`.
pub const CYCLE_MICROS: u64 = 12_000;

/// The same in seconds.
pub const CYCLE_SECONDS: f32 = CYCLE_MICROS as f32 * 1e-6;
