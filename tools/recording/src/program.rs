//! The program that records, and its computer.

use std::env;
use std::fs::{self, File};
use std::hint::black_box;
use std::io::{self, Read};
use std::time::SystemTime;

use bica::Graph;
use serde::{Deserialize, Serialize};

/// File with the name of the host, on Linux.
const HOST_FILE: &str = "/proc/sys/kernel/hostname";

/// The program that wrote a recording.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Program {
    /// Version of the robot's package; empty if unknown.
    pub version: String,
    /// Commit of its sources; empty if unknown.
    pub git_hash: String,
    /// Whether the sources differed from the commit.
    pub git_dirty: bool,
    /// Version and commit of BICA.
    #[serde(default)]
    pub bica: String,
    /// Kind of the processor, on which results of mathematical functions depend, see [`processor`]; empty in recordings without
    /// this field.
    #[serde(default)]
    pub processor: String,
    /// Target triple.
    pub target: String,
    /// CRC-32 of the executable file, hexadecimal; empty if it cannot be read.
    pub executable: String,
}

/// Computer and time of the start of a recording.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Start {
    /// Time, RFC 3339, UTC.
    pub time: String,
    /// Name of the computer; empty if unknown.
    pub host: String,
}

impl Program {
    /// Describes this program, whose robot is one of BICA's own.
    #[must_use]
    pub fn bica() -> Self {
        let (version, git_hash) = (env!("CARGO_PKG_VERSION").to_owned(), env!("BICA_GIT_HASH").to_owned());
        let git_dirty = env!("BICA_GIT_DIRTY") == "true";
        let changed = if git_dirty { " with changes" } else { "" };
        Self {
            bica: format!("{version} {git_hash}{changed}"),
            version,
            git_hash,
            git_dirty,
            processor: processor(),
            target: env!("BICA_TARGET").to_owned(),
            executable: executable().unwrap_or_default(),
        }
    }

    /// Describes this program, whose robot has this tree.
    #[must_use]
    pub fn of(graph: &Graph) -> Self {
        let (version, commit) = (graph.version.unwrap_or_default(), graph.commit.unwrap_or_default());
        let (git_hash, git_dirty) = (commit.trim_end_matches("-dirty").to_owned(), commit.ends_with("-dirty"));
        Self { version: version.to_owned(), git_hash, git_dirty, ..Self::bica() }
    }

    /// Returns whether another program is the same build: the same file, so that its results must be equal on equal processors.
    #[must_use]
    pub fn is_same_build(&self, other: &Self) -> bool {
        !self.executable.is_empty() && self.executable == other.executable
    }

    /// Returns the kinds of both processors, if they are known and differ.
    #[must_use]
    pub fn other_processor(&self, other: &Self) -> Option<[String; 2]> {
        let [one, two] = [self, other].map(|program| &program.processor);
        (one != two && !one.is_empty() && !two.is_empty()).then(|| [one.clone(), two.clone()])
    }
}

/// Returns the kind of this processor: its architecture, on x86 whether it has fused multiplication and addition (FMA), and a checksum
/// over results of the system's mathematical functions.
///
/// The functions of glibc have variants for processors with FMA, of which few results differ in the last bit. Code of the robot
/// does not use these functions; MuJoCo does, so its games differ from one kind to another.
#[must_use]
pub fn processor() -> String {
    let mut hash = crc32fast::Hasher::new();
    for index in 1..=1000 {
        let x = black_box(f64::from(index) * 0.7321);
        for result in [x.sin(), x.cos(), x.tan(), (0.1 * x).exp(), x.ln(), x.powf(1.37)] {
            hash.update(&result.to_le_bytes());
        }
    }
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    let fused = if std::arch::is_x86_feature_detected!("fma") { " with FMA" } else { " without FMA" };
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    let fused = "";
    format!("{}{fused}, mathematical functions {:08x}", env::consts::ARCH, hash.finalize())
}

impl Start {
    /// Returns this computer and the present time.
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
