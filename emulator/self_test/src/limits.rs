//! Limits of the image's size, memory and time.

use std::error::Error;

use crate::game::Played;
use crate::size::Sections;

const KIB: u64 = 1024;
/// Limit of flash, bytes.
pub(crate) const FLASH: u64 = 192 * KIB;
/// Limit of flash with the server for monitors and parameters that can be changed, bytes.
pub(crate) const FLASH_WITH_MONITORS: u64 = 256 * KIB;
/// Limit of the static memory without the two image buffers: the camera input's and the link's.
const MEMORY_LIMIT: u64 = 64 * KIB;
/// Size of the two image buffers, bytes.
const IMAGE_BUFFERS: u64 = 2 * 160 * 120 * 2;
const STACK_LIMIT: u64 = 16 * KIB;
/// Limit of the sense-think-act chain, instructions: about 50 ms at 400 MHz.
const CHAIN_LIMIT: u64 = 20_000_000;

/// Prints what image and game used and compares it with the limits.
///
/// # Errors
/// The names of the figures that are above their limit, or zero, which only a failed measurement can be.
pub(crate) fn check(sections: &Sections, played: &Played, flash_limit: u64) -> Result<(), Box<dyn Error>> {
    let chain = played.chain.last().copied().unwrap_or(0);
    let figures = [
        ("flash", sections.flash, flash_limit, "bytes"),
        ("static memory without images", sections.memory.saturating_sub(IMAGE_BUFFERS), MEMORY_LIMIT, "bytes"),
        ("maximum stack", played.stack.max_used.into(), STACK_LIMIT, "bytes"),
        ("longest sense-think-act chain", chain, CHAIN_LIMIT, "instructions"),
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
