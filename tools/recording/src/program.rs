//! The program that records, and its computer.

use std::env;
use std::fs::{self, File};
use std::io::{self, Read};
use std::time::SystemTime;

use serde::{Deserialize, Serialize};

/// Name of the host, on Linux.
const HOST_FILE: &str = "/proc/sys/kernel/hostname";

/// The program that wrote a recording.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Program {
    /// Version of the package.
    pub version: String,
    /// Commit of the sources; empty if unknown.
    pub git_hash: String,
    /// Whether the sources differed from the commit.
    pub git_dirty: bool,
    /// Target triple.
    pub target: String,
    /// CRC-32 of the executable file, hexadecimal; empty if it cannot be read.
    pub executable: String,
}

/// Where and when a recording was begun.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Start {
    /// Time, RFC 3339, UTC.
    pub time: String,
    /// Name of the computer; empty if unknown.
    pub host: String,
}

impl Program {
    /// This program.
    #[must_use]
    pub fn current() -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            git_hash: env!("BICA_GIT_HASH").to_owned(),
            git_dirty: env!("BICA_GIT_DIRTY") == "true",
            target: env!("BICA_TARGET").to_owned(),
            executable: executable().unwrap_or_default(),
        }
    }

    /// Returns whether another program is the same build, so that its results must be equal.
    #[must_use]
    pub fn is_same_build(&self, other: &Self) -> bool {
        let same_file = !self.executable.is_empty() && self.executable == other.executable;
        let same_commit = !self.git_hash.is_empty() && self.git_hash == other.git_hash;
        same_file || (same_commit && !self.git_dirty && !other.git_dirty)
    }
}

impl Start {
    /// This computer, now.
    #[must_use]
    pub fn now() -> Self {
        let host = fs::read_to_string(HOST_FILE).or_else(|_| env::var("COMPUTERNAME")).unwrap_or_default();
        Self { time: humantime::format_rfc3339_millis(SystemTime::now()).to_string(), host: host.trim().to_owned() }
    }
}

/// Returns the CRC-32 of the running executable.
fn executable() -> io::Result<String> {
    let mut file = File::open(env::current_exe()?)?;
    let (mut hash, mut buffer) = (crc32fast::Hasher::new(), vec![0; 1 << 18]);
    loop {
        match file.read(&mut buffer)? {
            0 => return Ok(format!("{:08x}", hash.finalize())),
            count => hash.update(&buffer[..count]),
        }
    }
}
