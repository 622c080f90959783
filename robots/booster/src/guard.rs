//! A process that outlives the program: a robot whose program was killed gets back to its firmware.

use std::io::{self, Read, Write};
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use crate::driver::Driver;
use crate::run::exchange;
use crate::transport::Transport;

/// Time between two looks at the topics: the guard needs the newest state only.
const LOOK: Duration = Duration::from_millis(10);
/// Longest wait for the end of a guard that is not needed any more.
const LONGEST_END: Duration = Duration::from_secs(1);
/// What the program tells its guard: whether it has the robot.
const FREE: u8 = 0;
const HELD: u8 = 1;
/// What the guard notes: the program ended without the robot, or with it.
const ENDED: u8 = 2;
const KILLED: u8 = 3;

/// The program's side: a guard, and whether it knows that the program has the robot.
pub(crate) struct Guard {
    child: Child,
    is_held: bool,
}

impl Guard {
    /// Starts the process; `command` runs [`guard`].
    ///
    /// # Errors
    /// If it cannot be started.
    pub(crate) fn start(mut command: Command) -> io::Result<Self> {
        // A terminal sends Ctrl-C, and a person a signal, to the group of the program.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let child = command.stdin(Stdio::piped()).stdout(Stdio::null()).spawn()?;
        Ok(Self { child, is_held: false })
    }

    /// Tells the guard whether the program has the robot, if that has changed.
    pub(crate) fn tell(&mut self, is_held: bool) {
        if let Some(pipe) = &mut self.child.stdin
            && self.is_held != is_held
        {
            self.is_held = is_held;
            // Without a guard, a killed program leaves the robot to its firmware.
            _ = pipe.write_all(&[if is_held { HELD } else { FREE }]);
        }
    }
}

impl Drop for Guard {
    fn drop(&mut self) {
        self.tell(false);
        // The end of the pipe lets the guard end.
        drop(self.child.stdin.take());
        let start = Instant::now();
        while start.elapsed() < LONGEST_END && self.child.try_wait().is_ok_and(|status| status.is_none()) {
            thread::sleep(LOOK);
        }
        // A guard that cannot be ended has ended.
        _ = self.child.kill();
        _ = self.child.wait();
    }
}

/// Waits until the program, which holds the other end of the standard input, is gone. If it has the robot then, it was killed: `driver`,
/// a [`Driver::guarding`], gives the robot to its firmware. `say` says something to people.
pub fn guard(transport: impl Transport, driver: Driver, say: fn(&str)) {
    watch(transport, driver, io::stdin(), say);
}

fn watch(mut transport: impl Transport, mut driver: Driver, mut pipe: impl Read + Send + 'static, say: fn(&str)) {
    let program = Arc::new(AtomicU8::new(FREE));
    let told = Arc::clone(&program);
    thread::spawn(move || {
        let mut byte = [FREE];
        while pipe.read_exact(&mut byte).is_ok() {
            told.store(byte[0], Ordering::Relaxed);
        }
        told.store(if byte == [HELD] { KILLED } else { ENDED }, Ordering::Relaxed);
    });
    let start = Instant::now();
    while !driver.is_over() {
        let state = program.load(Ordering::Relaxed);
        if state == ENDED {
            return;
        }
        exchange(&mut transport, &mut driver, start.elapsed(), None, state == KILLED, say);
        thread::sleep(LOOK);
    }
}
