//! The whole pipeline on synthetic, rendered, recorded and arbitrary frames.

mod canvas;
mod detectors;
mod nonsense;
mod own_body;
mod real;
mod shelf;
mod stages;
mod world;
