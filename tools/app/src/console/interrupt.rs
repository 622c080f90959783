//! Requests to end the program: Ctrl-C, SIGTERM and SIGHUP (on Windows: console events). After the first request the
//! program ends in order: it prints summaries and completes recordings. A later request ends it at once.

use std::process;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Time after the first request in which further requests count as the same one. Shells and `timeout` send a signal to
/// the process and to its group, and a closing terminal sends SIGHUP twice.
const ONE_REQUEST: Duration = Duration::from_secs(1);

static REQUESTED: OnceLock<Instant> = OnceLock::new();

/// Whether later requests are ignored, too.
static IN_ORDER: AtomicBool = AtomicBool::new(false);

/// Installs the signal handler. If that fails, a signal ends the program at once.
pub fn listen() {
    let _ = ctrlc::set_handler(|| {
        if REQUESTED.get_or_init(Instant::now).elapsed() > ONE_REQUEST && !IN_ORDER.load(Ordering::Relaxed) {
            process::exit(130);
        }
    });
}

/// Makes the program end in order even if the end is requested again: a real robot would fall if its program ended at once.
pub fn end_in_order() {
    IN_ORDER.store(true, Ordering::Relaxed);
}

/// Returns whether the end was requested.
#[must_use]
pub fn requested() -> bool {
    REQUESTED.get().is_some()
}
