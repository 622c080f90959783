//! The whole pipeline on synthetic, rendered, recorded and arbitrary frames.

mod arbitrary_input;
mod canvas;
mod detectors;
mod own_body;
mod real;
mod recorded;
mod stages;
mod tuning;
