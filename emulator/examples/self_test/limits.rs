//! What the image may take.

use std::error::Error;

use crate::game::Played;
use crate::size::Sections;

const KIB: u64 = 1024;
const FLASH: u64 = 192 * KIB;
/// Without the two images: the eye's and the link's.
const MEMORY: u64 = 64 * KIB;
const IMAGES: u64 = 2 * 160 * 120 * 2;
const STACK: u64 = 16 * KIB;
/// Instructions from sensing to acting: about 50 ms at 400 MHz.
const CHAIN: u64 = 20_000_000;

/// Tells what image and game took, and refuses what is too much.
pub(crate) fn check(sections: &Sections, played: &Played) -> Result<(), Box<dyn Error>> {
    let chain = played.chain.last().copied().unwrap_or(0);
    let taken = [
        ("flash", sections.flash, FLASH, "bytes"),
        ("static memory without images", sections.memory.saturating_sub(IMAGES), MEMORY, "bytes"),
        ("deepest stack", played.stack.deepest.into(), STACK, "bytes"),
        ("longest sense-think-act chain", chain, CHAIN, "instructions"),
    ];
    for (name, value, limit, unit) in taken {
        println!("{name:<30} {value:>9} of {limit:>9} {unit}");
    }
    match taken.iter().filter(|(_, value, limit, _)| value > limit).map(|taken| taken.0).collect::<Vec<_>>() {
        over if over.is_empty() => Ok(()),
        over => Err(format!("too much: {}", over.join(", ")).into()),
    }
}
