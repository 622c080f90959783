//! The colours of every picture.

use super::canvas::{Ink, Rgb};

pub const PAPER: Rgb = [247, 246, 242];
pub const TEXT: Rgb = [36, 41, 46];
pub const FAINT: Rgb = [150, 154, 158];
pub const GHOST: Rgb = [214, 214, 210];
pub const WHITE: Rgb = [255, 255, 255];

pub const CARPET: Rgb = [58, 125, 78];
pub const LINE: Rgb = [226, 238, 228];
pub const YELLOW: Rgb = [244, 196, 32];
pub const BLUE: Rgb = [66, 165, 245];
pub const BALL: Rgb = [245, 124, 0];
pub const ROBOT: Rgb = [236, 239, 241];
pub const OTHER: Rgb = [176, 160, 190];
pub const BELIEF: Rgb = [233, 30, 120];

/// What was recognised as a line, on an image in which lines are white.
pub const LINE_MARK: Rgb = [224, 64, 251];

/// A link that reads.
pub const REQUIRED: Rgb = [46, 120, 200];
/// A link that writes.
pub const MODULATED: Rgb = [214, 96, 40];

/// A colour that lets some of what is below through.
pub const fn sheer(rgb: Rgb, alpha: f32) -> Ink {
    Ink { rgb, alpha }
}

/// A colour as style sheets write it, `#rrggbb`; black if it is written otherwise.
pub fn hex(code: &str) -> Rgb {
    let number = code.strip_prefix('#').and_then(|digits| u32::from_str_radix(digits, 16).ok()).unwrap_or(0);
    let [_, red, green, blue] = number.to_be_bytes();
    [red, green, blue]
}
