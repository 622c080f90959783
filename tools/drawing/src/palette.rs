//! Colours of all pictures.

use super::canvas::{Ink, Rgb};

/// Background.
pub const PAPER: Rgb = [247, 246, 242];
/// Text and thin outlines.
pub const TEXT: Rgb = [36, 41, 46];
/// Secondary text.
pub const FAINT: Rgb = [150, 154, 158];
/// Latent components.
pub const GHOST: Rgb = [214, 214, 210];
/// White.
pub const WHITE: Rgb = [255, 255, 255];

/// Requirement links.
pub const REQUIRED: Rgb = [46, 120, 200];
/// Modulation links.
pub const MODULATED: Rgb = [214, 96, 40];

/// Returns ink with an opacity `alpha` from 0 to 1.
#[must_use]
pub const fn translucent(rgb: Rgb, alpha: f32) -> Ink {
    Ink { rgb, alpha }
}

/// Parses `#rrggbb`; black for any other text.
#[must_use]
pub fn hex(code: &str) -> Rgb {
    let number = code.strip_prefix('#').and_then(|digits| u32::from_str_radix(digits, 16).ok()).unwrap_or(0);
    let [_, red, green, blue] = number.to_be_bytes();
    [red, green, blue]
}
