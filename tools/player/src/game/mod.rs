//! Games of the forward: one game or a series, with observers, summaries, pictures and films.

#[cfg(feature = "evaluation")]
mod album;
mod control;
mod event;
#[cfg(feature = "evaluation")]
pub(crate) mod film;
mod fingerprint;
mod firmware;
mod latency;
mod link;
mod meter;
#[cfg(not(feature = "evaluation"))]
mod no_pictures;
mod observer;
#[cfg(feature = "evaluation")]
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

#[cfg(feature = "evaluation")]
use self::{album::Album, film::Film};
#[cfg(not(feature = "evaluation"))]
use self::{no_pictures::NoPictures as Album, no_pictures::NoPictures as Film};
pub use bica_recording::{ReplayOptions, ReplayReport};
pub use control::{GameControl, NextStep};
pub use firmware::FirmwareImage;
pub use link::ServeOptions;
pub use observer::GameObserver;
pub use play::{play_controlled, play_recorded};
pub use recording::{RecordOptions, recording_header};
pub use replay::{replay, rerun};
pub use rules::{Rules, WorldKind};
pub use scene::{GRAPH, Scene};
pub(crate) use series::{SeriesOptions, play_series};
pub(crate) use single::play_one;
pub use summary::{FaultRecord, GameResult, GameSummary};
pub use tuning::settings;
pub(crate) use world_factory::OPTIONS;
#[cfg(feature = "referee")]
pub(crate) use world_factory::open as open_world;
