//! Tests of the runner in one program, which is linked once.

mod cycle;
mod harness;
mod jobs;
mod realtime;
mod requests;
mod schedule;
