//! The firmware image: build, tests, and comparison with the committed figures.

use std::fs;

use crate::cli::Firmware;
use crate::install::packages;
use crate::no_std::Toolchain;
use crate::process::{root, run, works};

const IMAGE: &str = "firmware/target/thumbv7em-none-eabihf/release/forward-an500";
/// The image with the server for monitors. Cargo gives both images one name, so this one is moved.
const MONITOR_IMAGE: &str = "firmware/target/thumbv7em-none-eabihf/release/forward-an500-monitor";
const ROBOT_IMAGE: &str = "firmware/target/thumbv7em-none-eabihf/release/forward-stm32h743";
const FIGURES: &str = "firmware/figures.txt";

/// Installs the target and QEMU, builds the image and tests it, or performs the selected option instead.
///
/// # Errors
/// If an installation, a build or a check fails.
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
        self_test(IMAGE, &["--size"])?;
        return self_test(MONITOR_IMAGE, &["--size"]);
    }
    if options.bless {
        return self_test(IMAGE, &["--bless"]);
    }
    build_for(&rust, "stm32h743", &["--features", "monitor"])?;
    build_for(&rust, "stm32h743", &[])?;
    check_fault_injection()?;
    self_test(IMAGE, &[])?;
    self_test(MONITOR_IMAGE, &["--monitors"])?;
    play()
}

fn self_test(image: &str, more: &[&str]) -> Result<(), String> {
    let test = ["run", "--quiet", "--release", "-p", "bica-firmware-test", "--", image, FIGURES];
    run("cargo", &[&test[..], more].concat(), &[])
}

/// Runs the program's tests that need an image, then ten games.
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

/// Sends damaged packets for ten minutes to the decoder, then for ten minutes to the running image.
fn fuzz() -> Result<(), String> {
    self_test(IMAGE, &["--fuzz", "600"])
}

/// Checks that the image for QEMU contains the injected faults, and the image for a robot does not.
fn check_fault_injection() -> Result<(), String> {
    /// Part of the message of an injected panic.
    const MARK: &[u8] = b"injected: ";
    for (image, expected) in [(IMAGE, true), (ROBOT_IMAGE, false)] {
        let bytes = fs::read(root().join(image)).map_err(|error| format!("{image}: {error}"))?;
        if bytes.windows(MARK.len()).any(|window| window == MARK) != expected {
            return Err(format!("{image}: fault injection is {}", if expected { "missing" } else { "built in" }));
        }
    }
    Ok(())
}

/// Builds the images for QEMU: that of constants, and that with the server for monitors.
///
/// # Errors
/// If a build fails.
pub(crate) fn build(rust: &Toolchain) -> Result<(), String> {
    build_for(rust, "an500", &["--features", "monitor"])?;
    let (image, monitor_image) = (root().join(IMAGE), root().join(MONITOR_IMAGE));
    fs::copy(image, monitor_image).map_err(|error| format!("{MONITOR_IMAGE}: {error}"))?;
    build_for(rust, "an500", &[])
}

/// Builds the image of a board. Each board is built alone, because Cargo would unify the features of both.
fn build_for(rust: &Toolchain, board: &str, more: &[&str]) -> Result<(), String> {
    let manifest = format!("firmware/boards/{board}/Cargo.toml");
    let options = ["--config", "firmware/.cargo/config.toml", "--target-dir", "firmware/target"];
    rust.build(&[&options[..], &["--manifest-path", &manifest, "--release"], more].concat())
}
