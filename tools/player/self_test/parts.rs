//! Independent parts of the test, of which two run at a time.

use std::error::Error;
use std::path::Path;
use std::sync::Mutex;
use std::thread;
use std::time::Duration;

use bica_player_program::emulator::Transport;
use bica_sim::setup::Frame;

use crate::{images, link_fuzz, scenarios, sequences};

/// Duration of the fuzzing in every test; `--fuzz` sets another one.
const FUZZ: Duration = Duration::from_secs(10);

/// A part of the test: its name, and the check, which returns a summary.
pub(crate) type Part<'a> = (String, Box<dyn FnOnce() -> Result<String, Box<dyn Error>> + Send + 'a>);

/// Returns all parts for a firmware image with camera images of a size. Most parts run only for the smallest size,
/// which takes the least time: the firmware images are otherwise equal.
pub(crate) fn list(image: &Path, frame: Frame) -> Vec<Part<'_>> {
    let mut parts: Vec<Part<'_>> = Vec::new();
    parts.push((images::NAME.to_owned(), Box::new(move || images::check(image, frame).map(|()| "passed".to_owned()))));
    if frame != Frame::Small {
        return parts;
    }
    for sequence in &sequences::ALL {
        let check = move || Ok(format!("{} cycles, each equal to the host's", sequence.run(image)?));
        parts.push((format!("sequence: {}", sequence.name), Box::new(check)));
    }
    for (name, transport, scenario) in scenarios::ALL {
        let check = move || scenario(image, transport).map(|()| "passed".to_owned());
        parts.push((format!("scenario: {name}"), Box::new(check)));
    }
    for (name, transport) in [("pipe", Transport::Pipe), ("serial port", Transport::Serial)] {
        parts.push((format!("fuzz: {name}"), Box::new(move || link_fuzz::run(image, transport, FUZZ, 0))));
    }
    parts
}

/// Runs all parts and prints their summaries.
///
/// # Errors
/// The error of a part that failed.
pub(crate) fn run_all(parts: Vec<Part<'_>>) -> Result<(), Box<dyn Error>> {
    let queue = Mutex::new(parts.into_iter());
    let work = || -> Result<(), String> {
        loop {
            let next = queue.lock().map_err(|error| error.to_string())?.next();
            let Some((name, check)) = next else { return Ok(()) };
            let summary = check().map_err(|error| format!("failed: {name}: {error}"))?;
            println!("{name}: {summary}");
        }
    };
    thread::scope(|scope| {
        let workers = [scope.spawn(work), scope.spawn(work)];
        for worker in workers {
            worker.join().map_err(|_| "a part panicked")??;
        }
        Ok(())
    })
}
