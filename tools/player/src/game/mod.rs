//! Games of the forward: one game or a series, with observers, summaries, pictures and films.

mod album;
mod control;
mod event;
pub(crate) mod film;
mod fingerprint;
mod firmware;
mod latency;
mod link;
mod meter;
mod observer;
mod pictures;
mod play;
mod recording;
mod replay;
mod rules;
mod scene;
mod series;
mod series_summary;
mod single;
mod story;
mod summary;
mod summary_text;
mod tuning;
mod world_factory;

pub use bica_recording::{ReplayOptions, ReplayReport};
pub use control::{GameControl, NextStep};
pub use firmware::FirmwareImage;
pub use link::ServeOptions;
pub use play::{play_controlled, play_recorded};
pub use recording::{RecordOptions, recording_header};
pub use replay::{replay, rerun};
pub use rules::{Rules, WorldKind};
pub use scene::GRAPH;
pub(crate) use series::{SeriesOptions, play_series};
pub(crate) use single::play_one;
pub use tuning::settings;
