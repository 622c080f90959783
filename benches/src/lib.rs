//! Shared parts of the benchmarks: trees, frames, and recorded games.

pub mod frames;
pub mod game;
pub mod isolated;
pub mod recording;
pub mod trees;
