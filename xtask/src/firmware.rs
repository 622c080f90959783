//! The firmware image: build, tests, and comparison with the committed figures.

use std::fs;

use crate::build;
use crate::cli::Firmware;
use crate::install::packages;
use crate::no_std::{TARGET, Toolchain};
use crate::process::{root, run, works};

const IMAGE: &str = "firmware/target/thumbv7em-none-eabihf/release/forward-an500";
/// The image with the server for monitors. Cargo gives both images one name, so this one is moved.
const MONITOR_IMAGE: &str = "firmware/target/thumbv7em-none-eabihf/release/forward-an500-monitor";
/// The image for camera images of 320×240, moved too.
const MEDIUM_IMAGE: &str = "firmware/target/thumbv7em-none-eabihf/release/forward-an500-medium";
const ROBOT_IMAGE: &str = "firmware/target/thumbv7em-none-eabihf/release/forward-stm32h743";
const FIGURES: &str = "firmware/figures.txt";
const MEDIUM_FIGURES: &str = "firmware/figures-medium.txt";
/// Images without the server for monitors, and their figures.
const IMAGES: [(&str, &str); 2] = [(IMAGE, FIGURES), (MEDIUM_IMAGE, MEDIUM_FIGURES)];

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
    install_emulator()?;
    if options.fuzz {
        return fuzz();
    }
    if options.games {
        return play(IMAGE, "160x120", 10).and_then(|()| play(MEDIUM_IMAGE, "320x240", 10));
    }
    if options.size {
        return [IMAGE, MEDIUM_IMAGE, MONITOR_IMAGE]
            .into_iter()
            .try_for_each(|image| self_test(image, FIGURES, &["--size"]));
    }
    if options.bless {
        IMAGES.into_iter().try_for_each(|(image, figures)| self_test(image, figures, &["--bless"]))?;
        // Its limits are separate.
        return self_test(MONITOR_IMAGE, FIGURES, &["--monitors"]);
    }
    lint(&rust)?;
    for features in ["monitor,medium-frames", ""] {
        build_for(&rust, "stm32h743", features)?;
    }
    check_fault_injection()?;
    let lent_memory = ["test", "--quiet", "-p", "bica-player", "--lib", "--features", "medium-frames", "camera_input"];
    run("cargo", &lent_memory, &[])?;
    IMAGES.into_iter().try_for_each(|(image, figures)| self_test(image, figures, &[]))?;
    self_test(MONITOR_IMAGE, FIGURES, &["--monitors"])?;
    test_program()?;
    run_new_firmware()?;
    // Larger camera images take longer: `--games` plays ten with them too.
    play(IMAGE, "160x120", 10).and_then(|()| play(MEDIUM_IMAGE, "320x240", 3))
}

/// Installs QEMU.
///
/// # Errors
/// If the installation fails.
pub(crate) fn install_emulator() -> Result<(), String> {
    if works("qemu-system-arm", &["--version"]) { Ok(()) } else { packages(&["qemu-system-arm"]) }
}

/// Builds the images for QEMU, and installs it.
///
/// # Errors
/// If an installation or a build fails.
pub(crate) fn prepare() -> Result<(), String> {
    build(&Toolchain::get()?)?;
    install_emulator()
}

fn self_test(image: &str, figures: &str, more: &[&str]) -> Result<(), String> {
    let test =
        ["run", "--quiet", "--release", "--bin", "firmware-test", "--features", "self-test", "--", image, figures];
    run("cargo", &[&test[..], more].concat(), &[])
}

/// Runs the program's tests that need an image.
fn test_program() -> Result<(), String> {
    let image = root().join(IMAGE);
    let image = image.to_str().ok_or("the path of the workspace is not UTF-8")?;
    build::cargo("test", &["--quiet", "--test", "program", "firmware"], &[("BICA_IMAGE", image)])
}

/// Runs the firmware that `bica new --embassy` writes; it ends by itself, with an error if the robot has not halted before the wall.
fn run_new_firmware() -> Result<(), String> {
    const CRATE: &str = "target/tmp/new-firmware";
    let old = root().join(CRATE);
    if old.exists() {
        fs::remove_dir_all(&old).map_err(|error| format!("{CRATE}: {error}"))?;
    }
    fs::create_dir_all(root().join("target/tmp")).map_err(|error| format!("target/tmp: {error}"))?;
    run("cargo", &["run", "--quiet", "-p", "bica-app", "--bin", "bica", "--", "new", "--embassy", CRATE], &[])?;
    let (config, manifest) = (format!("{CRATE}/.cargo/config.toml"), format!("{CRATE}/Cargo.toml"));
    run("cargo", &["--config", &config, "run", "--quiet", "--release", "--manifest-path", &manifest], &[])
}

/// Plays games with camera images of a size; each must be won.
fn play(image: &str, size: &str, games: u32) -> Result<(), String> {
    let games = games.to_string();
    let world = ["--", "play", "--world", "firmware", "--image", image];
    let program = [&["run", "--quiet", "--release"], build::release(), &world].concat();
    run("cargo", &[&program[..], &["--size", size, "--games", &games, "--at-least", &games]].concat(), &[])
}

/// Sends damaged packets to the running image for ten minutes; `cargo xtask fuzz` sends them to the decoder.
fn fuzz() -> Result<(), String> {
    self_test(IMAGE, FIGURES, &["--fuzz", "600"])
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

/// Checks the image for QEMU with Clippy, which Debian's toolchain lacks.
fn lint(rust: &Toolchain) -> Result<(), String> {
    let Toolchain::Rustup = rust else { return Ok(()) };
    let clippy = ["clippy", "--quiet", "--target", TARGET, "--target-dir", "firmware/target"];
    let package = ["--manifest-path", "firmware/Cargo.toml", "--features", "an500,monitor", "--", "-D", "warnings"];
    run("cargo", &[&clippy[..], &package].concat(), &[])
}

/// Builds the images for QEMU: that of constants for each size of camera images, and that with the server for monitors.
///
/// # Errors
/// If a build fails.
pub(crate) fn build(rust: &Toolchain) -> Result<(), String> {
    for (feature, moved) in [("monitor", MONITOR_IMAGE), ("medium-frames", MEDIUM_IMAGE)] {
        build_for(rust, "an500", feature)?;
        fs::copy(root().join(IMAGE), root().join(moved)).map_err(|error| format!("{moved}: {error}"))?;
    }
    build_for(rust, "an500", "")
}

/// Builds the image of a board with further features.
fn build_for(rust: &Toolchain, board: &str, more: &str) -> Result<(), String> {
    let features = format!("{board},{more}");
    // The image contains the paths of sources for its panics: its size must not depend on the folder of the checkout.
    let home = std::env::var("CARGO_HOME").or_else(|_| std::env::var("HOME").map(|home| format!("{home}/.cargo")));
    let home = home.unwrap_or_default();
    let registries = std::fs::read_dir(format!("{home}/registry/src")).into_iter().flatten().flatten();
    let registries = registries.map(|registry| registry.path().display().to_string());
    // The last prefix that fits is the one that is removed.
    let folders = [root().display().to_string(), home.clone()].into_iter().chain(registries);
    let flags = folders.filter(|folder| !folder.is_empty()).map(|folder| format!("'--remap-path-prefix={folder}/='"));
    let flags = flags.collect::<Vec<_>>().join(",");
    let paths = format!("target.thumbv7em-none-eabihf.rustflags=[{flags}]");
    let options = ["--config", "firmware/.cargo/config.toml", "--config", &paths, "--target-dir", "firmware/target"];
    let package = ["--manifest-path", "firmware/Cargo.toml", "--release", "--features", &features];
    rust.build(&[&options[..], &package].concat())
}
