//! Replays of games: they must be equal bit for bit, and must find every change.

mod damaged_firmware;
mod files;
mod flips;
mod games;
mod placements;
mod repository;
mod requests;
