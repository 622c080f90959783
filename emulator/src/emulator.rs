//! QEMU with a firmware image, and a pipe to it.

use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use crate::error::Error;
use crate::line::Line;

/// QEMU's name for the memory word that tells the image to speak through the pipe, and its content: "PIPE", "LINE".
const JUMPERS: [&str; 2] =
    ["loader,addr=0x203ffffc,data=0x45504950,data-len=4", "loader,addr=0x203ffffc,data=0x454e494c,data-len=4"];

/// What carries the messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carrier {
    /// A pipe: fast, and the microcontroller's time stands still while it waits.
    Pipe,
    /// A pipe that brings no more than 1.2 MB in a second of the microcontroller's time, 30 images: that time goes on
    /// while there is something to read. Whoever falls silent stops it.
    Line,
    /// The board's serial port: a byte at a time, slow in QEMU; time goes on while the microcontroller waits.
    Serial,
}

impl Carrier {
    fn arguments(self) -> &'static [&'static str] {
        match self {
            Self::Pipe => &["-icount", "shift=0,sleep=off", "-device", JUMPERS[0], "-serial", "null"],
            Self::Line => &["-icount", "shift=0,sleep=off", "-device", JUMPERS[1], "-serial", "null"],
            Self::Serial => &["-icount", "shift=0,sleep=on", "-serial", "stdio"],
        }
    }
}

/// A running image. It ends with this value.
#[derive(Debug)]
pub struct Emulator {
    child: Child,
    line: Line<ChildStdout, ChildStdin>,
}

impl Emulator {
    /// Starts an image; its log (defmt, not decoded) goes to a file, if one is named.
    ///
    /// # Errors
    /// [`Error::NoImage`], [`Error::NoEmulator`].
    pub fn start(image: &Path, carrier: Carrier, log: Option<&Path>) -> Result<Self, Error> {
        if !image.is_file() {
            return Err(Error::NoImage(image.to_owned()));
        }
        let log = log.map_or_else(|| "null".to_owned(), |path| format!("file:{}", path.display()));
        let mut command = Command::new("qemu-system-arm");
        // In a group of its own: Ctrl-C is for the program, which ends the emulator when it has summed up.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command
            .args(["-M", "mps2-an500", "-cpu", "cortex-m7", "-display", "none", "-monitor", "none"])
            .args(["-semihosting-config", "enable=on,target=native"])
            .args(carrier.arguments())
            .args(["-serial", &log])
            .arg("-kernel")
            .arg(image)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(Error::NoEmulator)?;
        let (Some(to), Some(from)) = (child.stdin.take(), child.stdout.take()) else {
            return Err(Error::Unexpected("no pipes".to_owned()));
        };
        Ok(Self { child, line: Line::new(from, to) })
    }

    /// The pipe.
    pub const fn line(&mut self) -> &mut Line<ChildStdout, ChildStdin> {
        &mut self.line
    }
}

impl Drop for Emulator {
    fn drop(&mut self) {
        // An emulator that has already ended needs no end.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
