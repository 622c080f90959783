//! Ctrl-C: the first ends what is being done and sums it up, the second ends the program.

use std::process;
use std::sync::atomic::{AtomicBool, Ordering};

static ASKED: AtomicBool = AtomicBool::new(false);

/// Listens for Ctrl-C from now on.
pub fn listen() {
    // Where no handler can be had, Ctrl-C ends the program at once, as ever.
    let _ = ctrlc::set_handler(|| {
        if ASKED.swap(true, Ordering::Relaxed) {
            process::exit(130);
        }
    });
}

/// Whether someone pressed Ctrl-C.
pub fn requested() -> bool {
    ASKED.load(Ordering::Relaxed)
}
