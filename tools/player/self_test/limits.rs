//! Limits of the image's size, memory and time.

use std::error::Error;

use bica_sim::setup::Frame;

use crate::game::Played;
use crate::size::Sections;

const KIB: u64 = 1024;
/// Limit of flash, bytes. Ages of estimates and the monitor of camera and gyroscope need 5 KiB of it, the algorithms for a model that is
/// a value need 7 KiB: they contain the legs and arms of every humanoid, and the numbers of the robot are read, not folded.
const FLASH: u64 = 212 * KIB;
/// Limit of flash with the server for monitors and parameters that can be changed, bytes. The search of the whole field, the stop and the
/// turn of the legs need 2.4 KiB of it, what descriptions say of modulations that drive 0.2 KiB, and rules of faults that differ between
/// robots 0.1 KiB.
const FLASH_WITH_MONITORS: u64 = 278 * KIB;
/// Limit of the static memory, bytes.
const MEMORY: u64 = 256 * KIB;
/// Limit of the static memory without the memory for camera images, bytes.
const OTHER_MEMORY: u64 = 64 * KIB;
/// The same limit with the server for monitors. Ages of estimates and the monitor of camera and gyroscope need 0.3 KiB of it.
const OTHER_MEMORY_WITH_MONITORS: u64 = 65 * KIB;
const STACK: u64 = 16 * KIB;

/// Limits that depend on the image.
pub(crate) struct Limits {
    /// Flash, bytes.
    flash: u64,
    /// Size of the memory for camera images, bytes; not a limit.
    image_memory: u64,
    /// Static memory without the memory for camera images, bytes.
    other_memory: u64,
    /// Sense-think-act chain, instructions.
    chain: u64,
}

impl Limits {
    /// Returns the limits of an image for camera images of a size, with or without the server for monitors.
    pub(crate) const fn of(frame: Frame, with_monitors: bool) -> Self {
        let (images, chain) = match frame {
            Frame::Small => (2, 3_000_000),
            Frame::Medium | Frame::Large => (1, 8_000_000),
        };
        let (flash, other_memory) =
            if with_monitors { (FLASH_WITH_MONITORS, OTHER_MEMORY_WITH_MONITORS) } else { (FLASH, OTHER_MEMORY) };
        Self { flash, other_memory, image_memory: images * bytes(frame) as u64, chain }
    }
}

/// Returns the size of a camera image, bytes.
pub(crate) const fn bytes(frame: Frame) -> usize {
    let (width, height) = frame.size();
    2 * width * height
}

/// Prints the figures of image and game and compares them with the limits.
///
/// # Errors
/// The names of the figures that exceed their limit, or are zero after a failed measurement.
pub(crate) fn check(sections: &Sections, played: &Played, limits: &Limits) -> Result<(), Box<dyn Error>> {
    let chain = played.chain.last().copied().unwrap_or(0);
    let figures = [
        ("flash", sections.flash, limits.flash, "bytes"),
        ("static memory", sections.memory, MEMORY, "bytes"),
        (
            "static memory without images",
            sections.memory.saturating_sub(limits.image_memory),
            limits.other_memory,
            "bytes",
        ),
        ("maximum stack", played.stack.max_used.into(), STACK, "bytes"),
        ("longest sense-think-act chain", chain, limits.chain, "instructions"),
    ];
    for (name, value, limit, unit) in figures {
        println!("{name:<30} {value:>9} of {limit:>9} {unit}");
    }
    let wrong = figures.iter().filter(|(_, value, limit, _)| !(1..=*limit).contains(value)).map(|figure| figure.0);
    match wrong.collect::<Vec<_>>() {
        wrong if wrong.is_empty() => Ok(()),
        wrong => Err(format!("not between 1 and the limit: {}", wrong.join(", ")).into()),
    }
}
