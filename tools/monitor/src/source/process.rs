//! Programs that are ended together with all processes that they have started.

use std::io::{self, BufRead, BufReader, Read};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::Sender;
use std::thread;

/// Number of the last lines of output that are kept.
const LAST_LINES: usize = 12;
/// Longest line that [`LastLines`] keeps, bytes.
const LONGEST_LINE: usize = 64 << 10;

/// Process group of a program: its process, and those that it has started.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Group(u32);

impl Group {
    /// Kills all processes of the group.
    pub(super) fn kill(self) {
        #[cfg(unix)]
        {
            use nix::sys::signal::{Signal, killpg};
            use nix::unistd::Pid;
            // The group may have ended already.
            let _ = killpg(Pid::from_raw(self.0 as i32), Signal::SIGKILL);
        }
        #[cfg(not(unix))]
        {
            let pid = self.0.to_string();
            let _ = Command::new("taskkill").args(["/T", "/F", "/PID", &pid]).status();
        }
    }
}

/// Starts a program in a new process group, with its output in pipes.
pub(super) fn start(command: &mut Command) -> io::Result<(Child, Group)> {
    // Ctrl-C ends only the server, which ends the group.
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(command, 0);
    let child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()?;
    let group = Group(child.id());
    Ok((child, group))
}

/// Sends each line of a stream. Lines end with a line feed or, in progress output, with a carriage return.
pub(super) fn send_lines(stream: impl Read + Send + 'static, lines: Sender<String>) {
    thread::spawn(move || each_line(stream, |line| lines.send(line).is_ok()));
}

/// Calls `take` with each line until it returns false, then reads on to the end so that the program never waits.
pub(super) fn each_line(stream: impl Read, mut take: impl FnMut(String) -> bool) {
    let mut reader = BufReader::new(stream);
    let (mut line, mut listens) = (Vec::new(), true);
    loop {
        let used = match reader.fill_buf() {
            Ok([]) | Err(_) => break,
            Ok(bytes) => {
                for &byte in bytes {
                    if byte == b'\n' || byte == b'\r' {
                        let text = String::from_utf8_lossy(&line).into_owned();
                        line.clear();
                        listens = listens && (text.trim().is_empty() || take(text));
                    } else if line.len() < LONGEST_LINE * 64 {
                        line.push(byte);
                    }
                }
                bytes.len()
            }
        };
        reader.consume(used);
    }
    if !line.is_empty() && listens {
        take(String::from_utf8_lossy(&line).into_owned());
    }
}

/// The last lines of a program's output.
#[derive(Debug, Default)]
pub(super) struct LastLines(Vec<String>);

impl LastLines {
    pub(super) fn add(&mut self, mut line: String) {
        if self.0.len() >= LAST_LINES {
            self.0.remove(0);
        }
        while line.len() > LONGEST_LINE {
            line.pop();
        }
        self.0.push(line);
    }

    pub(super) fn text(&self) -> String {
        self.0.join("\n")
    }
}
