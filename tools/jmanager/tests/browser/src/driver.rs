//! The program that drives a browser: chromedriver or geckodriver.

use std::io::{BufRead, BufReader};
use std::os::unix::process::CommandExt;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::LazyLock;
use std::time::{Duration, Instant};

use fantoccini::wd::Capabilities;
use fantoccini::{Client, ClientBuilder};
use hyper_util::client::legacy::connect::HttpConnector;
use tokio::runtime::{Builder, Handle};

use crate::folder::target;

/// Starts a driver, and ends it with its browsers and their files when the program that started it closes the pipe or ends. If the driver
/// alone were killed, its browsers would go on; a stopped one ends after it is continued.
const WATCHED: &str = "dir=$(mktemp -d); TMPDIR=$dir \"$0\" --port=0 & exec >&-; read -r end; \
    trap '' TERM; kill -TERM 0; kill -CONT 0; wait; rm -rf \"$dir\"";
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
const STARTS: u32 = 5;

/// Runtime of the connections to browsers, which last longer than that of a story.
static RUNTIME: LazyLock<Handle> = LazyLock::new(|| {
    let runtime = Builder::new_current_thread().enable_all().build().expect("a runtime");
    let handle = runtime.handle().clone();
    std::thread::spawn(move || runtime.block_on(std::future::pending::<()>()));
    handle
});

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
            .unwrap_or_else(|| panic!("the driver printed no port {STARTS} times; `cargo xtask browser` installs it"))
    }

    /// Starts a browser.
    pub(crate) async fn browser(&self, capabilities: Capabilities) -> Client {
        let mut builder = ClientBuilder::new(HttpConnector::new());
        builder.capabilities(capabilities);
        let url = self.url.clone();
        let connect = async move {
            let mut client = builder.connect(&url).await;
            // A browser sometimes ends while it starts, before it has a page.
            for _ in 1..STARTS {
                let Err(error) = &client else { break };
                eprintln!("the browser is started again: {error}");
                client = builder.connect(&url).await;
            }
            client.expect("a browser")
        };
        RUNTIME.spawn(connect).await.expect("a browser")
    }

    /// Starts it; `None` if it ends before it has printed its port.
    fn try_start() -> Option<Self> {
        let (program, before) = if is_firefox() {
            (geckodriver(), "Listening on 127.0.0.1:")
        } else {
            ("chromedriver".into(), "successfully on port ")
        };
        let mut child = Command::new("sh")
            .args(["-c", WATCHED])
            .arg(program)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .process_group(0)
            .spawn()
            .expect("a shell");
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
}

impl Drop for Driver {
    fn drop(&mut self) {
        drop(self.child.stdin.take());
        let begin = Instant::now();
        while begin.elapsed() < END && matches!(self.child.try_wait(), Ok(None)) {
            std::thread::sleep(Duration::from_millis(10));
        }
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
