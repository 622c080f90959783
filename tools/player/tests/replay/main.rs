//! Replays of games: equal bit for bit, and every change is found.

mod damaged_firmware;
mod files;
mod flips;
mod games;
mod placements;
mod repository;
mod requests;
