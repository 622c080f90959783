//! Games of the forward, in whichever world.

pub mod album;
mod event;
pub mod film;
mod fingerprint;
mod firmware;
mod game_loop;
mod latency;
mod meter;
pub mod observer;
pub mod scene;
mod series;
mod series_summary;
mod single;
mod story;
mod summary;
mod summary_text;
mod world_factory;

pub use firmware::Image;
pub use game_loop::Rules;
pub use series::{Plan, run as run_series};
pub use single::run as run_one;
pub use world_factory::WorldKind;
