//! Tests of the runner in one program, which is linked once.

mod cycle;
mod harness;
mod realtime;
mod requests;
mod schedule;
