//! Drawn frames, real frames and nonsense frames through the whole pipeline.

mod canvas;
mod detectors;
mod nonsense;
mod own_body;
mod real;
mod shelf;
mod stages;
mod world;
