//! Thread of a program.

use std::process::ExitCode;
use std::thread;

use bica::runner::STACK_BYTES;

use crate::console::{Failure, Outcome, interrupt};

/// Runs a program on a thread with a stack large enough for a large tree; returns the exit code.
pub(crate) fn start(work: impl FnOnce() -> Result<Outcome, Failure> + Send + 'static) -> ExitCode {
    interrupt::listen();
    match thread::Builder::new().stack_size(STACK_BYTES).spawn(work).map(thread::JoinHandle::join) {
        Ok(Ok(outcome)) => outcome.map_or_else(ExitCode::from, ExitCode::from),
        // The panic has printed its message.
        Ok(Err(_)) => ExitCode::from(101),
        Err(error) => Failure::new(format!("cannot start a thread: {error}"), "is there memory left?").into(),
    }
}
