//! Requests to end: Ctrl-C, SIGTERM and SIGHUP (on Windows: the events of the console). The first one lets the program end
//! in order, with summaries printed and recordings complete; a later one ends it at once.

use std::process;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Requests within this time after the first are part of it: shells and `timeout` send a signal to the process and to its
/// group, and a terminal that closes sends SIGHUP twice.
const ONE_REQUEST: Duration = Duration::from_secs(1);

static REQUESTED: OnceLock<Instant> = OnceLock::new();

/// Whether later requests end nothing, either.
static IN_ORDER: AtomicBool = AtomicBool::new(false);

/// Installs the handler of the signals. Where none can be installed, they end the program at once.
pub fn listen() {
    let _ = ctrlc::set_handler(|| {
        if REQUESTED.get_or_init(Instant::now).elapsed() > ONE_REQUEST && !IN_ORDER.load(Ordering::Relaxed) {
            process::exit(130);
        }
    });
}

/// Lets the program end in order even if the end is requested again: a real robot would fall if its program ended at once.
pub fn end_in_order() {
    IN_ORDER.store(true, Ordering::Relaxed);
}

/// Whether the end was requested.
#[must_use]
pub fn requested() -> bool {
    REQUESTED.get().is_some()
}
