//! Builds of the robot's crates for a microcontroller, without the standard library and without a heap.

use crate::firmware;
use crate::install::packages;
use crate::process::{run, works};

/// The microcontroller.
pub(crate) const TARGET: &str = "thumbv7em-none-eabihf";
const CRATES: [&str; 8] =
    ["bica-core", "bica-runner", "bica-field", "bica-motion", "bica-vision", "bica-wire", "bica", "bica-player"];
const DEBIAN: [&str; 4] = ["rustc-web", "cargo-web", "rust-web-src", "lld"];

/// Builds every crate that runs on a robot for a Cortex-M, then links the firmware image without an allocator; linking
/// fails if any part needs `alloc`.
///
/// # Errors
/// If an installation or a build fails.
pub(crate) fn check() -> Result<(), String> {
    let rust = Toolchain::get()?;
    for name in CRATES {
        rust.build(&["-p", name, "--lib", "--no-default-features"])?;
    }
    rust.build(&["-p", "bica-player", "--lib", "--features", "referee"])?;
    firmware::build(&rust)
}

/// Toolchain that builds for the microcontroller.
pub(crate) enum Toolchain {
    /// Installed toolchain, with a precompiled `core` for the target.
    Rustup,
    /// Debian's toolchain, which builds `core` from source.
    Debian,
}

impl Toolchain {
    /// Returns the first of the two that is installed or can be installed.
    ///
    /// # Errors
    /// If neither can be installed.
    pub(crate) fn get() -> Result<Self, String> {
        if works("rustup", &["target", "add", TARGET]) {
            return Ok(Self::Rustup);
        }
        eprintln!("xtask: rustup cannot fetch {TARGET}; using Debian's Rust, which builds `core` from source");
        if !works("dpkg", &["-s", DEBIAN[2]]) {
            packages(&DEBIAN)?;
        }
        Ok(Self::Debian)
    }

    /// Builds for the microcontroller.
    ///
    /// # Errors
    /// If the build fails.
    pub(crate) fn build(&self, arguments: &[&str]) -> Result<(), String> {
        let common = ["build", "--quiet", "--target", TARGET];
        match self {
            Self::Rustup => run("cargo", &[&common[..], arguments].concat(), &[]),
            Self::Debian => run(
                "/usr/bin/cargo",
                &[&common[..], &["-Zbuild-std=core,alloc"], arguments].concat(),
                &[
                    ("RUSTC_BOOTSTRAP", "1"),
                    ("RUSTC", "/usr/bin/rustc"),
                    ("CARGO_TARGET_THUMBV7EM_NONE_EABIHF_LINKER", "ld.lld"),
                ],
            ),
        }
    }
}
