//! The image for the microcontroller: built, tested, weighed.

use crate::no_std::Toolchain;
use crate::process::{run, works};

const IMAGE: &str = "firmware/target/thumbv7em-none-eabihf/release/forward";
const FIGURES: &str = "firmware/figures.txt";

/// Gets the target and QEMU, builds the image, and tests it; `more` is what is asked for beyond that.
///
/// # Errors
/// What could not be installed or built, or did not hold.
pub(crate) fn check(more: Option<&str>) -> Result<(), String> {
    let rust = Toolchain::get()?;
    build(&rust)?;
    if more == Some("--build") {
        return Ok(());
    }
    if !works("qemu-system-arm", &["--version"]) {
        run("apt-get", &["update", "-qq"], &[])?;
        run("apt-get", &["install", "-y", "-qq", "qemu-system-arm"], &[])?;
    }
    if more.is_none() {
        build_for(&rust, "firmware/stm32h7/Cargo.toml", "firmware/stm32h7/target")?;
    }
    let test = ["run", "--quiet", "--release", "-p", "bica-emulator", "--example", "self_test", "--", IMAGE, FIGURES];
    run("cargo", &[&test[..], more.as_slice()].concat(), &[])
}

/// Builds the image.
///
/// # Errors
/// What did not build.
pub(crate) fn build(rust: &Toolchain) -> Result<(), String> {
    build_for(rust, "firmware/Cargo.toml", "firmware/target")
}

fn build_for(rust: &Toolchain, manifest: &str, target: &str) -> Result<(), String> {
    let place = ["--config", "firmware/.cargo/config.toml", "--target-dir", target];
    rust.build(&[&place[..], &["--manifest-path", manifest, "--release"]].concat())
}
