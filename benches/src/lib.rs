//! Shared parts of the benchmarks: trees, frames, recorded games, and the judgement of the budget report.

pub mod budget;
pub mod frames;
pub mod game;
pub mod isolated;
pub mod recording;
pub mod trees;
