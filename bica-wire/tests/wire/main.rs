//! Properties that hold for every message and every kind of damage.

mod arbitrary;
mod blobs;
mod damage;
mod describe;
mod golden;
mod images;
mod lease;
mod monitor;
mod text;
