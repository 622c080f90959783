//! Limits of the colour classes, as parameters.
//!
//! Of a pixel's chroma vector (Cb - 128, Cr - 128): its direction is the hue, in degrees from Cb towards Cr; its length in
//! percent of luma is the saturation. The defaults are those of [`profile::BUILT_IN`](bica_vision::profile::BUILT_IN).
#![expect(clippy::struct_field_names, reason = "the parameters of one component have different names")]

use bica::prelude::*;
use bica_vision::colour::{Filter, Filters};

/// The rule and the filter of a coloured class.
macro_rules! coloured {
    (
        $limits:ident: $hue_from:ident, $hue_to:ident, $saturation_min:ident, $saturation_max:ident,
        $luma_min:ident, $luma_max:ident, $chroma_min:ident
    ) => {
        impl $limits {
            const fn is_ordered(&self) -> Result<(), &'static str> {
                if self.$hue_from > self.$hue_to || self.$hue_to - self.$hue_from > 179 {
                    Err(concat!("`", stringify!($hue_to), "` must be 0 to 179 above `", stringify!($hue_from), "`"))
                } else if self.$saturation_min > self.$saturation_max {
                    Err(above!($saturation_min, $saturation_max))
                } else if self.$luma_min > self.$luma_max {
                    Err(above!($luma_min, $luma_max))
                } else {
                    Ok(())
                }
            }

            const fn filter(&self) -> Filter {
                Filter::ANY
                    .hue(self.$hue_from as i16, self.$hue_to as i16)
                    .saturation(self.$saturation_min as u16, self.$saturation_max as u16)
                    .luma(self.$luma_min as u8, self.$luma_max as u8)
                    .chroma(self.$chroma_min as u8)
            }
        }
    };
}

macro_rules! above {
    ($min:ident, $max:ident) => {
        concat!("`", stringify!($min), "` must not be above `", stringify!($max), "`")
    };
}

/// Limits of the colour class orange: the ball.
#[derive(Clone, Copy, Debug, Params, PartialEq)]
#[params(check = Self::is_ordered)]
pub struct OrangeLimits {
    /// First hue of orange.
    #[param(default = 119, range = 0..=359, unit = "deg")]
    orange_hue_from: u32,
    /// Last hue of orange, at most 179° after the first; above 359 it goes on from 0.
    #[param(default = 146, range = 0..=538, unit = "deg")]
    orange_hue_to: u32,
    /// Minimum saturation of orange.
    #[param(default = 36, range = 0..=1000, unit = "%")]
    orange_saturation_min: u32,
    /// Maximum saturation of orange.
    #[param(default = 400, range = 0..=1000, unit = "%")]
    orange_saturation_max: u32,
    /// Minimum luma of orange.
    #[param(default = 30, range = 0..=255)]
    orange_luma_min: u32,
    /// Maximum luma of orange.
    #[param(default = 235, range = 0..=255)]
    orange_luma_max: u32,
    /// Minimum length of the chroma vector of orange, in counts: below a few, hue is noise.
    #[param(default = 24, range = 0..=180)]
    orange_chroma_min: u32,
}

coloured! {
    OrangeLimits: orange_hue_from, orange_hue_to, orange_saturation_min, orange_saturation_max, orange_luma_min, orange_luma_max,
    orange_chroma_min
}

/// Limits of the colour class yellow: the yellow goal.
#[derive(Clone, Copy, Debug, Params, PartialEq)]
#[params(check = Self::is_ordered)]
pub struct YellowLimits {
    /// First hue of yellow.
    #[param(default = 154, range = 0..=359, unit = "deg")]
    yellow_hue_from: u32,
    /// Last hue of yellow, at most 179° after the first; above 359 it goes on from 0.
    #[param(default = 182, range = 0..=538, unit = "deg")]
    yellow_hue_to: u32,
    /// Minimum saturation of yellow.
    #[param(default = 34, range = 0..=1000, unit = "%")]
    yellow_saturation_min: u32,
    /// Maximum saturation of yellow.
    #[param(default = 400, range = 0..=1000, unit = "%")]
    yellow_saturation_max: u32,
    /// Minimum luma of yellow.
    #[param(default = 40, range = 0..=255)]
    yellow_luma_min: u32,
    /// Maximum luma of yellow.
    #[param(default = 245, range = 0..=255)]
    yellow_luma_max: u32,
    /// Minimum length of the chroma vector of yellow, in counts: below a few, hue is noise.
    #[param(default = 24, range = 0..=180)]
    yellow_chroma_min: u32,
}

coloured! {
    YellowLimits: yellow_hue_from, yellow_hue_to, yellow_saturation_min, yellow_saturation_max, yellow_luma_min, yellow_luma_max,
    yellow_chroma_min
}

/// Limits of the colour class blue: the sky-blue goal.
#[derive(Clone, Copy, Debug, Params, PartialEq)]
#[params(check = Self::is_ordered)]
pub struct BlueLimits {
    /// First hue of blue.
    #[param(default = 294, range = 0..=359, unit = "deg")]
    blue_hue_from: u32,
    /// Last hue of blue, at most 179° after the first; above 359 it goes on from 0.
    #[param(default = 333, range = 0..=538, unit = "deg")]
    blue_hue_to: u32,
    /// Minimum saturation of blue.
    #[param(default = 27, range = 0..=1000, unit = "%")]
    blue_saturation_min: u32,
    /// Maximum saturation of blue.
    #[param(default = 400, range = 0..=1000, unit = "%")]
    blue_saturation_max: u32,
    /// Minimum luma of blue.
    #[param(default = 20, range = 0..=255)]
    blue_luma_min: u32,
    /// Maximum luma of blue.
    #[param(default = 220, range = 0..=255)]
    blue_luma_max: u32,
    /// Minimum length of the chroma vector of blue, in counts: below a few, hue is noise.
    #[param(default = 14, range = 0..=180)]
    blue_chroma_min: u32,
}

coloured! {
    BlueLimits: blue_hue_from, blue_hue_to, blue_saturation_min, blue_saturation_max, blue_luma_min, blue_luma_max,
    blue_chroma_min
}

/// Limits of the colour class green: the carpet.
#[derive(Clone, Copy, Debug, Params, PartialEq)]
#[params(check = Self::is_ordered)]
pub struct GreenLimits {
    /// First hue of green.
    #[param(default = 210, range = 0..=359, unit = "deg")]
    green_hue_from: u32,
    /// Last hue of green, at most 179° after the first; above 359 it goes on from 0.
    #[param(default = 280, range = 0..=538, unit = "deg")]
    green_hue_to: u32,
    /// Minimum saturation of green.
    #[param(default = 16, range = 0..=1000, unit = "%")]
    green_saturation_min: u32,
    /// Maximum saturation of green.
    #[param(default = 400, range = 0..=1000, unit = "%")]
    green_saturation_max: u32,
    /// Minimum luma of green.
    #[param(default = 20, range = 0..=255)]
    green_luma_min: u32,
    /// Maximum luma of green.
    #[param(default = 200, range = 0..=255)]
    green_luma_max: u32,
    /// Minimum length of the chroma vector of green, in counts: below a few, hue is noise.
    #[param(default = 8, range = 0..=180)]
    green_chroma_min: u32,
}

coloured! {
    GreenLimits: green_hue_from, green_hue_to, green_saturation_min, green_saturation_max, green_luma_min, green_luma_max,
    green_chroma_min
}

/// Limits of the colour class white: lines, robots and walls.
#[derive(Clone, Copy, Debug, Params, PartialEq)]
#[params(check = Self::is_ordered)]
pub struct WhiteLimits {
    /// Maximum saturation of white.
    #[param(default = 14, range = 0..=1000, unit = "%")]
    white_saturation_max: u32,
    /// Minimum luma of white.
    #[param(default = 120, range = 0..=255)]
    white_luma_min: u32,
    /// Maximum luma of white.
    #[param(default = 255, range = 0..=255)]
    white_luma_max: u32,
}

impl WhiteLimits {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.white_luma_min > self.white_luma_max {
            Err("`white_luma_min` must not be above `white_luma_max`")
        } else {
            Ok(())
        }
    }

    const fn filter(&self) -> Filter {
        Filter::ANY
            .saturation(0, self.white_saturation_max as u16)
            .luma(self.white_luma_min as u8, self.white_luma_max as u8)
    }
}

/// Limits of all colour classes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ColourLimits {
    pub(super) orange: OrangeLimits,
    pub(super) yellow: YellowLimits,
    pub(super) blue: BlueLimits,
    pub(super) green: GreenLimits,
    pub(super) white: WhiteLimits,
}

impl ColourLimits {
    /// The default limits.
    pub(super) const DEFAULT: Self = Self {
        orange: OrangeLimits::DEFAULT,
        yellow: YellowLimits::DEFAULT,
        blue: BlueLimits::DEFAULT,
        green: GreenLimits::DEFAULT,
        white: WhiteLimits::DEFAULT,
    };

    /// The limits as filters.
    pub(super) const fn filters(&self) -> Filters {
        Filters {
            orange: self.orange.filter(),
            yellow: self.yellow.filter(),
            blue: self.blue.filter(),
            white: self.white.filter(),
            green: self.green.filter(),
        }
    }
}

#[cfg(test)]
mod tests {
    use bica_vision::profile;

    use super::*;

    #[test]
    fn default_limits_equal_built_in_profile() {
        assert_eq!(ColourLimits::DEFAULT.filters(), profile::BUILT_IN);
    }

    #[test]
    fn limits_out_of_order_break_rule() {
        let orange = OrangeLimits::DEFAULT;
        assert!(OrangeLimits { orange_hue_from: 147, ..orange }.is_ordered().is_err());
        assert!(OrangeLimits { orange_hue_to: 146 + 153, ..orange }.is_ordered().is_err());
        assert!(OrangeLimits { orange_saturation_min: 401, ..orange }.is_ordered().is_err());
        assert!(OrangeLimits { orange_luma_max: 29, ..orange }.is_ordered().is_err());
        assert!(OrangeLimits { orange_luma_max: 30, ..orange }.is_ordered().is_ok());
        assert!(WhiteLimits { white_luma_max: 119, ..WhiteLimits::DEFAULT }.is_ordered().is_err());
    }
}
