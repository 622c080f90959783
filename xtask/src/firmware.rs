//! The firmware image: build, tests, and comparison with the committed figures.

use crate::cli::Firmware;
use crate::install::packages;
use crate::no_std::Toolchain;
use crate::process::{root, run, works};

const IMAGE: &str = "firmware/target/thumbv7em-none-eabihf/release/forward";
const FIGURES: &str = "firmware/figures.txt";

/// Installs the target and QEMU, builds the image and tests it, or performs the selected option instead.
///
/// # Errors
/// What could not be installed or built, or a check that fails.
pub(crate) fn check(options: &Firmware) -> Result<(), String> {
    let rust = Toolchain::get()?;
    build(&rust)?;
    if options.build {
        return Ok(());
    }
    if !works("qemu-system-arm", &["--version"]) {
        packages(&["qemu-system-arm"])?;
    }
    if options.fuzz {
        return fuzz();
    }
    if options.size {
        return self_test(&["--size"]);
    }
    if options.bless {
        return self_test(&["--bless"]);
    }
    build_for(&rust, "firmware/stm32h7/Cargo.toml", "firmware/stm32h7/target")?;
    self_test(&[])?;
    play()
}

fn self_test(more: &[&str]) -> Result<(), String> {
    let test = ["run", "--quiet", "--release", "-p", "bica-firmware-test", "--", IMAGE, FIGURES];
    run("cargo", &[&test[..], more].concat(), &[])
}

/// The program's tests that need an image, then ten games.
fn play() -> Result<(), String> {
    let image = root().join(IMAGE);
    let image = image.to_str().ok_or("the path of the workspace is not UTF-8")?;
    run(
        "cargo",
        &["test", "--quiet", "-p", "bica-player-program", "--test", "program", "firmware"],
        &[("BICA_IMAGE", image)],
    )?;
    let games = ["play", "--world", "firmware", "--image", IMAGE, "--games", "10", "--at-least", "9"];
    run("cargo", &[&["run", "--quiet", "--release", "--"], &games[..]].concat(), &[])
}

/// Ten minutes of injected errors for the decoder, then ten for the running image.
fn fuzz() -> Result<(), String> {
    const SECONDS: &str = "600";
    run("cargo", &["run", "--quiet", "--release", "-p", "bica-wire", "--example", "fuzz", "--", SECONDS], &[])?;
    self_test(&["--fuzz", SECONDS])
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
