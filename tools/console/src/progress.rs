//! How far a series of games is: a bar on stderr, if that is a terminal.

use std::io::{self, IsTerminal, Write};
use std::time::Instant;

const WIDTH: u64 = 30;

/// A bar; gone when it is dropped.
pub struct Progress {
    shown: bool,
    began: Instant,
    all: u64,
    done: u64,
    goals: u64,
}

impl Progress {
    /// Nothing done yet.
    pub fn new(all: u64) -> Self {
        let progress = Self { shown: io::stderr().is_terminal(), began: Instant::now(), all, done: 0, goals: 0 };
        progress.draw();
        progress
    }

    /// One more game is over.
    pub fn step(&mut self, goal: bool) {
        self.done += 1;
        self.goals += u64::from(goal);
        self.draw();
    }

    fn draw(&self) {
        let full = WIDTH * self.done / self.all.max(1);
        let bar: String = (0..WIDTH).map(|n| if n < full { '#' } else { '.' }).collect();
        let left = self.began.elapsed().as_secs_f64() / self.done.max(1) as f64 * (self.all - self.done) as f64;
        let left = if self.done == 0 { String::new() } else { format!(", {left:.0} s left") };
        self.put(&format!("\r[{bar}] {}/{} games, {} goals{left}\x1b[K", self.done, self.all, self.goals));
    }

    fn put(&self, text: &str) {
        if self.shown {
            // A bar that cannot be drawn is not worth stopping for.
            let _ = io::stderr().write_all(text.as_bytes());
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.put("\r\x1b[K");
    }
}
