//! QEMU with a firmware image, and a link to it.

use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use bica_wire::model::Invalid;

use super::link::Link;

/// QEMU devices that write a word after the program's memory. The image selects its transport by that word: "PIPE" or
/// "LINE" in ASCII.
const SELECT_PIPE: &str = "loader,addr=0x203ffffc,data=0x45504950,data-len=4";
const SELECT_PACED_PIPE: &str = "loader,addr=0x203ffffc,data=0x454e494c,data-len=4";

/// Transport of the packets between program and image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Transport {
    /// A pipe: fast. The microcontroller's time stands still while it waits for bytes.
    Pipe,
    /// A pipe limited to 1.2 MB per second of the microcontroller's time, which corresponds to 30 images per second.
    /// The microcontroller's time advances as long as the program sends; it stands still when the pipe is empty.
    PacedPipe,
    /// The board's serial port: one byte at a time, slow in QEMU. Time advances while the microcontroller waits.
    Serial,
}

impl Transport {
    fn arguments(self) -> &'static [&'static str] {
        match self {
            Self::Pipe => &["-icount", "shift=0,sleep=off", "-device", SELECT_PIPE, "-serial", "null"],
            Self::PacedPipe => &["-icount", "shift=0,sleep=off", "-device", SELECT_PACED_PIPE, "-serial", "null"],
            Self::Serial => &["-icount", "shift=0,sleep=on", "-serial", "stdio"],
        }
    }
}

/// A running image. Dropping it ends the emulator.
#[derive(Debug)]
pub struct Emulator {
    child: Child,
    link: Link<ChildStdout, ChildStdin>,
    monitors: Option<SocketAddr>,
}

impl Emulator {
    /// Starts an image. Its log (defmt, encoded) is written to the file `log`, if there is one.
    ///
    /// # Errors
    /// If the image does not exist, or QEMU cannot be started.
    pub fn start(image: &Path, transport: Transport, log: Option<&Path>) -> Result<Self, Invalid> {
        Self::run(image, transport, log, None)
    }

    /// Starts an image as [`start`](Self::start), with its serial port for monitors as a TCP server on this computer, for one monitor at
    /// a time.
    ///
    /// # Errors
    /// As [`start`](Self::start), or if there is no free port.
    pub fn start_with_monitors(image: &Path, transport: Transport, log: Option<&Path>) -> Result<Self, Invalid> {
        let port = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).and_then(|listener| listener.local_addr());
        Self::run(image, transport, log, Some(port.map_err(|error| unavailable(&error))?))
    }

    fn run(
        image: &Path,
        transport: Transport,
        log: Option<&Path>,
        monitors: Option<SocketAddr>,
    ) -> Result<Self, Invalid> {
        if !image.is_file() {
            return Err(super::error(format!("the firmware image `{}` does not exist", image.display())));
        }
        let log = log.map_or_else(|| "null".to_owned(), |path| format!("file:{}", path.display()));
        let port = monitors.map_or_else(|| "null".to_owned(), |address| format!("tcp:{address},server=on,wait=off"));
        let mut command = Command::new("qemu-system-arm");
        // A separate process group: Ctrl-C stops the program only, which ends the emulator after its summary.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command
            .args(["-M", "mps2-an500", "-cpu", "cortex-m7", "-display", "none", "-monitor", "none"])
            .args(["-semihosting-config", "enable=on,target=native"])
            .args(transport.arguments())
            .args(["-serial", &log])
            .args(["-serial", &port])
            .arg("-kernel")
            .arg(image)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| unavailable(&error))?;
        let (Some(tx), Some(rx)) = (child.stdin.take(), child.stdout.take()) else {
            return Err(super::unexpected("the emulator has no pipes"));
        };
        Ok(Self { child, link: Link::new(rx, tx), monitors })
    }

    /// Returns the address of the serial port for monitors, if it was started with one.
    #[must_use]
    pub const fn monitors(&self) -> Option<SocketAddr> {
        self.monitors
    }

    /// Returns the link to the image.
    pub const fn link(&mut self) -> &mut Link<ChildStdout, ChildStdin> {
        &mut self.link
    }
}

fn unavailable(error: &io::Error) -> Invalid {
    super::error(format!("cannot start qemu-system-arm ({error})"))
}

impl Drop for Emulator {
    fn drop(&mut self) {
        // Both calls fail only if the emulator has already ended.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
