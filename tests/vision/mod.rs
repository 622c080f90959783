//! Tests of the vision.

mod accuracy;
mod field;
mod frames;
mod hypothesis;
mod memory;
mod projection;
mod uncertainty;
