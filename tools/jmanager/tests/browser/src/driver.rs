//! The program that drives a browser: chromedriver or geckodriver.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::os::unix::process::CommandExt;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::folder::target;

/// Time limit for the end of its browsers.
const END: Duration = Duration::from_secs(5);

/// Returns whether `JMANAGER_BROWSER` is `firefox`; else the browser is Chromium.
pub(crate) fn is_firefox() -> bool {
    std::env::var("JMANAGER_BROWSER").is_ok_and(|name| name == "firefox")
}

fn geckodriver() -> PathBuf {
    let installed = target().join("geckodriver/bin/geckodriver");
    if installed.exists() { installed } else { "geckodriver".into() }
}

/// Maximum number of starts of a driver that ends before it prints its port, and of a browser that ends before it has a page.
pub(crate) const STARTS: u32 = 5;

/// A driver that ends with its browsers when this is dropped.
pub(crate) struct Driver {
    child: Child,
    pub(crate) url: String,
}

impl Driver {
    pub(crate) fn start() -> Self {
        // Chromedriver chooses a free port of IPv4, and ends if another program has the same port of IPv6.
        (0..STARTS)
            .find_map(|_| Self::try_start())
            .unwrap_or_else(|| panic!("the driver printed no port {STARTS} times"))
    }

    /// Starts it; `None` if it ends before it has printed its port.
    fn try_start() -> Option<Self> {
        let (program, before) = if is_firefox() {
            (geckodriver(), "Listening on 127.0.0.1:")
        } else {
            ("chromedriver".into(), "successfully on port ")
        };
        let mut child = Command::new(&program)
            .arg("--port=0")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .process_group(0)
            .spawn()
            .unwrap_or_else(|error| panic!("{}: {error}; `cargo xtask browser` installs it", program.display()));
        let output = BufReader::new(child.stdout.take().expect("the output is a pipe"));
        let mut lines = output.lines().map_while(Result::ok);
        let port = lines.find_map(|line| line.split_once(before)?.1.trim_end_matches('.').parse::<u16>().ok());
        let Some(port) = port else {
            child.wait().expect("it has closed its output");
            return None;
        };
        // The rest is read, so that a full pipe never blocks the driver.
        std::thread::spawn(move || lines.for_each(drop));
        Some(Self { child, url: format!("http://127.0.0.1:{port}") })
    }

    /// Requests that it ends its browsers and then itself. If it were killed, the browsers would go on.
    fn shut_down(&self) -> std::io::Result<()> {
        if is_firefox() {
            // Geckodriver has no such request. It and its browser are one process group.
            let group = format!("-{}", self.child.id());
            return Command::new("kill").args(["-TERM", "--", &group]).status().map(drop);
        }
        let address = self.url.trim_start_matches("http://");
        let mut stream = TcpStream::connect(address)?;
        stream.set_read_timeout(Some(END))?;
        write!(stream, "GET /shutdown HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n")?;
        stream.read_to_end(&mut Vec::new()).map(drop)
    }
}

impl Drop for Driver {
    fn drop(&mut self) {
        if self.shut_down().is_ok() {
            let begin = Instant::now();
            while begin.elapsed() < END && matches!(self.child.try_wait(), Ok(None)) {
                std::thread::sleep(Duration::from_millis(10));
            }
        }
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
