//! Games of the forward: one game or a series, with observers, summaries, pictures and films.

mod album;
mod event;
mod film;
mod fingerprint;
mod firmware;
mod game;
mod latency;
mod meter;
mod observer;
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

pub use album::Album;
pub use event::EventRecord;
pub use film::Film;
pub use firmware::{FirmwareImage, FirmwareSummary, InstructionCount};
pub use game::{play, play_recorded};
pub use latency::LatencySummary;
pub use observer::{GameObserver, View};
pub use recording::{RecordOptions, RecordingSummary, recording_header};
pub use replay::{ReplayOptions, Replayed, replay};
pub use rules::{Rules, WorldKind};
pub use scene::{GRAPH, Scene};
pub use series::{SeriesOptions, play_series};
pub use single::play_one;
pub use summary::{ComponentActivity, ComponentCost, GameResult, GameSummary, Wall};
pub use tuning::settings;
