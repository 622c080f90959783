//! The program that drives a browser: chromedriver or geckodriver.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::os::unix::process::CommandExt;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::server::target;

/// Longest time in which it ends its browsers.
const END: Duration = Duration::from_secs(5);

/// A browser.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Browser {
    Chromium,
    Firefox,
}

impl Browser {
    /// The browser that `JMANAGER_BROWSER` names, `chromium` or `firefox`; else Chromium.
    pub(crate) fn wanted() -> Self {
        match std::env::var("JMANAGER_BROWSER").as_deref() {
            Err(_) | Ok("chromium") => Self::Chromium,
            Ok("firefox") => Self::Firefox,
            Ok(other) => panic!("JMANAGER_BROWSER is `{other}`: it names chromium or firefox"),
        }
    }

    /// The driver, its argument, and the words before the port in what it prints.
    fn driver(self) -> (PathBuf, &'static str, &'static str) {
        match self {
            Self::Chromium => ("chromedriver".into(), "--port=0", "successfully on port "),
            Self::Firefox => {
                let installed = target().join("geckodriver/bin/geckodriver");
                let program = if installed.exists() { installed } else { "geckodriver".into() };
                (program, "--port=0", "Listening on 127.0.0.1:")
            }
        }
    }
}

/// A driver that ends with its browsers when this is dropped.
pub(crate) struct Driver {
    child: Child,
    browser: Browser,
    pub(crate) url: String,
}

impl Driver {
    pub(crate) fn start(browser: Browser) -> Self {
        let (program, argument, before) = browser.driver();
        let name = program.display();
        let mut child = Command::new(&program)
            .arg(argument)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .process_group(0)
            .spawn()
            .unwrap_or_else(|error| panic!("{name}: {error}; `cargo xtask browser` installs it"));
        let output = BufReader::new(child.stdout.take().expect("the output is a pipe"));
        let mut lines = output.lines().map_while(Result::ok);
        let port = lines
            .find_map(|line| line.split_once(before)?.1.trim_end_matches('.').parse::<u16>().ok())
            .unwrap_or_else(|| panic!("{name} prints no port"));
        // The rest is read, so that the driver never waits for a reader.
        std::thread::spawn(move || lines.for_each(drop));
        Self { child, browser, url: format!("http://127.0.0.1:{port}") }
    }

    /// Asks it to end its browsers and then itself. Killed, it would leave them behind.
    fn shut_down(&self) -> std::io::Result<()> {
        if self.browser == Browser::Firefox {
            // Geckodriver knows no such request. It and its browser are one group.
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
