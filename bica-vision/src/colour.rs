//! Colour classes and their classifiers: thresholds here, lookup tables in [`table`](crate::table).
//!
//! Cost on a desktop core: about 6 ns per pixel with [`Filters`], 1 ns with a table.

use core::ops::BitOr;

use bica_field::GoalColour;

use crate::chroma::ChromaBox;
use crate::frame::Pixel;

/// Colour class of a pixel on a field of 2009.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Colour {
    /// Any other colour.
    #[default]
    None,
    /// Ball.
    Orange,
    /// Yellow goal.
    Yellow,
    /// Sky-blue goal.
    Blue,
    /// Lines, robots, walls.
    White,
    /// Carpet.
    Green,
}

impl Colour {
    /// Class of a goal's paint.
    #[must_use]
    pub const fn of_goal(colour: GoalColour) -> Self {
        match colour {
            GoalColour::Yellow => Self::Yellow,
            GoalColour::SkyBlue => Self::Blue,
        }
    }

    /// All classes except [`Colour::None`], in order.
    pub const ALL: [Self; 5] = [Self::Orange, Self::Yellow, Self::Blue, Self::White, Self::Green];

    /// Class of a number: 0 none, 1 orange, 2 yellow, 3 blue, 4 white, 5 green; [`Colour::None`] for any other number.
    #[inline]
    #[must_use]
    pub const fn from_index(index: u8) -> Self {
        match index {
            1 => Self::Orange,
            2 => Self::Yellow,
            3 => Self::Blue,
            4 => Self::White,
            5 => Self::Green,
            _ => Self::None,
        }
    }
}

/// Set of colour classes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ColourSet(u8);

impl ColourSet {
    /// Empty set.
    pub const EMPTY: Self = Self(0);

    /// Set of one class; empty for [`Colour::None`].
    #[must_use]
    pub const fn of(colour: Colour) -> Self {
        Self((1 << colour as u8) & !1)
    }

    /// Whether the set contains the class. It never contains [`Colour::None`].
    #[inline(always)]
    #[must_use]
    pub const fn has(self, colour: Colour) -> bool {
        self.0 >> colour as u8 & 1 != 0
    }
}

impl BitOr for ColourSet {
    type Output = Self;

    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl BitOr for Colour {
    type Output = ColourSet;

    fn bitor(self, other: Self) -> ColourSet {
        ColourSet::of(self) | ColourSet::of(other)
    }
}

/// Pixel classifier. It classifies every pixel.
pub trait Classify {
    /// Returns the class of a pixel.
    fn classify(&self, pixel: Pixel) -> Colour;

    /// Bounding box of the chroma of a class. A smaller box lets [`Runs`](crate::segment::Runs) skip more pixels.
    fn chroma(&self, _: Colour) -> ChromaBox {
        ChromaBox::ALL
    }
}

/// Thresholds of one class, on quantities that are invariant to exposure.
///
/// The chroma vector (Cb − 128, Cr − 128) and luma scale alike with exposure. So its direction (hue) and its length
/// relative to luma (saturation) stay.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Filter {
    /// First accepted direction of the chroma vector, scaled by 1024.
    from: (i16, i16),
    /// Last accepted direction.
    to: (i16, i16),
    saturation: (u16, u16),
    luma: (u8, u8),
    chroma_squared: i32,
}

impl Filter {
    /// Filter that accepts every colour.
    pub const ANY: Self =
        Self { from: (0, 0), to: (0, 0), saturation: (0, u16::MAX), luma: (0, 255), chroma_squared: 0 };

    /// Filter whose memory is zero.
    pub(crate) const ZERO: Self =
        Self { from: (0, 0), to: (0, 0), saturation: (0, 0), luma: (0, 0), chroma_squared: 0 };

    /// Filter that accepts no colour.
    pub const NOTHING: Self = Self::ANY.luma(1, 0);

    /// Accepts hues from `from` counter-clockwise to `to` only, degrees, at most 180 apart; 0 is along Cb, 90 along Cr.
    ///
    /// A ball of 2009 has hue 120–150, a yellow goal 160–185, carpet 200–285, a sky-blue goal 290–345, red plastic 90–118.
    #[must_use]
    pub const fn hue(mut self, from: i16, to: i16) -> Self {
        self.from = direction(from);
        self.to = direction(to);
        self
    }

    /// Accepts saturations (length of the chroma vector over luma) from `min` to `max` percent only.
    #[must_use]
    pub const fn saturation(mut self, min: u16, max: u16) -> Self {
        self.saturation = (min, max);
        self
    }

    /// Accepts luma from `min` to `max` only.
    #[must_use]
    pub const fn luma(mut self, min: u8, max: u8) -> Self {
        self.luma = (min, max);
        self
    }

    /// Accepts chroma vectors of at least this length only: below a few counts hue is noise.
    #[must_use]
    pub const fn chroma(mut self, min: u8) -> Self {
        self.chroma_squared = min as i32 * min as i32;
        self
    }

    /// Accepted hues as given to [`hue`](Self::hue), the first in 0..360; `None` if all are accepted.
    #[must_use]
    pub fn hue_range(&self) -> Option<(i16, i16)> {
        let degrees = |(b, r): (i16, i16)| libm::roundf(libm::atan2f(r.into(), b.into()).to_degrees()) as i16;
        let from = degrees(self.from).rem_euclid(360);
        (self.from != (0, 0)).then(|| (from, from + (degrees(self.to) - from).rem_euclid(360)))
    }

    /// Accepted saturations, percent.
    #[must_use]
    pub const fn saturation_range(&self) -> (u16, u16) {
        self.saturation
    }

    /// Accepted luma, apart from hue and saturation.
    #[must_use]
    pub const fn luma_bounds(&self) -> (u8, u8) {
        self.luma
    }

    /// Minimum length of the chroma vector.
    #[must_use]
    pub const fn least_chroma(&self) -> u8 {
        self.chroma_squared.isqrt() as u8
    }

    /// Whether the filter accepts the pixel.
    #[must_use]
    #[inline]
    pub const fn accepts(&self, pixel: Pixel) -> bool {
        // Most pixels are of another hue, or grey.
        if !self.accepts_hue(pixel.cb as i32 - 128, pixel.cr as i32 - 128) {
            return false;
        }
        let (low, high) = self.luma_range(pixel.cb, pixel.cr);
        low <= pixel.y && pixel.y <= high
    }

    /// Whether a chroma vector is long enough and has an accepted direction.
    #[inline(always)]
    const fn accepts_hue(&self, b: i32, r: i32) -> bool {
        let ((from_b, from_r), (to_b, to_r)) = (self.from, self.to);
        b * b + r * r >= self.chroma_squared
            && from_b as i32 * r >= from_r as i32 * b
            && b * to_r as i32 >= r * to_b as i32
    }

    /// Lowest and highest luma at which the filter accepts a chroma; the lowest is above the highest if it never does.
    ///
    /// For a given chroma, saturation is a bound on luma. So thresholds are evaluated once per chroma.
    #[must_use]
    pub const fn luma_range(&self, cb: u8, cr: u8) -> (u8, u8) {
        let (b, r) = (cb as i32 - 128, cr as i32 - 128);
        let squared = b * b + r * r;
        if !self.accepts_hue(b, r) {
            return (1, 0);
        }
        let percent = (10_000 * squared as u32).isqrt();
        let (least, most) = (self.saturation.0 as u32, self.saturation.1 as u32);
        let low = if most == 0 { 256 * (squared > 0) as u32 } else { percent.div_ceil(most) };
        let high = if percent >= 255 * least { 255 } else { percent / least };
        if low > 255 {
            return (1, 0);
        }
        (if self.luma.0 as u32 > low { self.luma.0 } else { low as u8 }, smaller(self.luma.1, high as u8))
    }
}

const fn smaller(a: u8, b: u8) -> u8 {
    if a < b { a } else { b }
}

/// Unit vector of an angle in degrees, scaled by 1024. The polynomials err by less than 1/1024.
const fn direction(degrees: i16) -> (i16, i16) {
    let within = degrees.rem_euclid(360);
    let (quarter, rest) = (within / 90, within % 90);
    let a = rest as f32 * (core::f32::consts::PI / 180.0);
    let a2 = a * a;
    let sine = a * (1.0 - a2 / 6.0 * (1.0 - a2 / 20.0 * (1.0 - a2 / 42.0)));
    let cosine = 1.0 - a2 / 2.0 * (1.0 - a2 / 12.0 * (1.0 - a2 / 30.0 * (1.0 - a2 / 56.0)));
    let (s, c) = ((sine * 1024.0 + 0.5) as i16, (cosine * 1024.0 + 0.5) as i16);
    match quarter {
        0 => (c, s),
        1 => (-s, c),
        2 => (-c, -s),
        _ => (s, -c),
    }
}

/// One colour filter per class: the thresholds that the paper tunes by hand.
///
/// The classes are tried in the order orange, yellow, blue, green, white. The first filter that accepts decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Filters {
    /// Ball.
    pub orange: Filter,
    /// Yellow goal.
    pub yellow: Filter,
    /// Sky-blue goal.
    pub blue: Filter,
    /// Lines, robots, walls.
    pub white: Filter,
    /// Carpet.
    pub green: Filter,
}

impl Filters {
    /// Filters with their classes, in the order of decision.
    #[must_use]
    pub const fn in_order(&self) -> [(Colour, &Filter); 5] {
        [
            (Colour::Orange, &self.orange),
            (Colour::Yellow, &self.yellow),
            (Colour::Blue, &self.blue),
            (Colour::Green, &self.green),
            (Colour::White, &self.white),
        ]
    }
}

impl Classify for Filters {
    fn classify(&self, pixel: Pixel) -> Colour {
        let mut accepting = self.in_order().into_iter().filter(|(_, filter)| filter.accepts(pixel));
        accepting.next().map_or(Colour::None, |(colour, _)| colour)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use proptest::prelude::*;

    #[test]
    fn direction_is_unit_vector_of_its_angle() {
        for degrees in -720..=720_i16 {
            let (c, s) = direction(degrees);
            let angle = f64::from(degrees).to_radians();
            assert!((f64::from(c) - 1024.0 * libm::cos(angle)).abs() <= 1.0, "cos {degrees}");
            assert!((f64::from(s) - 1024.0 * libm::sin(angle)).abs() <= 1.0, "sin {degrees}");
        }
    }

    #[test]
    fn set_contains_exactly_its_members() {
        let set = Colour::Orange | Colour::Green;
        for colour in Colour::ALL {
            assert_eq!(set.has(colour), matches!(colour, Colour::Orange | Colour::Green));
            assert_eq!(Colour::from_index(colour as u8), colour);
        }
        assert!(!set.has(Colour::None) && ColourSet::of(Colour::None) == ColourSet::EMPTY);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        /// Compares with floating-point hue and saturation, except close to a threshold.
        #[test]
        fn filter_equals_floating_point_colour(
            (y, cb, cr) in any::<(u8, u8, u8)>(), from in -180_i16..360, wide in 1_i16..180,
            (least, span) in (0_u16..100, 0_u16..200), (dark, light) in any::<(u8, u8)>(), chroma in 0_u8..60,
        ) {
            let most = least + span;
            let filter = Filter::ANY.hue(from, from + wide).saturation(least, most).luma(dark, light).chroma(chroma);
            let (b, r) = (f64::from(cb) - 128.0, f64::from(cr) - 128.0);
            let length = libm::hypot(b, r);
            let hue = (libm::atan2(r, b).to_degrees() - f64::from(from)).rem_euclid(360.0);
            let percent = 100.0 * length / f64::from(y);
            let near = |a: f64, b: f64| (a - b).abs() < 0.1;
            prop_assume!(length > 1.0 && !near(hue, 0.0) && !near(hue, f64::from(wide)) && !near(hue, 360.0));
            prop_assume!(!near(percent, f64::from(least)) && !near(percent, f64::from(most)));
            let expected = hue < f64::from(wide) && length >= f64::from(chroma) && (dark..=light).contains(&y)
                && percent > f64::from(least) && percent < f64::from(most);
            prop_assert_eq!(filter.accepts(Pixel::new(y, cb, cr)), expected);
        }

        #[test]
        fn filter_returns_its_thresholds(
            from in 0_i16..360, wide in 1_i16..180, saturation in any::<(u16, u16)>(), luma in any::<(u8, u8)>(),
            chroma in any::<u8>(),
        ) {
            let any = Filter::ANY.saturation(saturation.0, saturation.1).luma(luma.0, luma.1).chroma(chroma);
            let filter = any.hue(from, from + wide);
            prop_assert_eq!((filter.hue_range(), any.hue_range()), (Some((from, from + wide)), None));
            prop_assert_eq!((filter.saturation_range(), filter.luma_bounds()), (saturation, luma));
            prop_assert_eq!(filter.least_chroma(), chroma);
        }

        #[test]
        fn hue_and_saturation_are_invariant_to_exposure(cb in 100_u8..156, cr in 100_u8..156, from in 0_i16..360) {
            let doubled = |c: u8| (2 * i16::from(c) - 128) as u8;
            let filter = Filter::ANY.hue(from, from + 60).saturation(10, 90);
            let (dim, bright) = (Pixel::new(60, cb, cr), Pixel::new(120, doubled(cb), doubled(cr)));
            prop_assert_eq!(filter.accepts(dim), filter.accepts(bright));
        }
    }
}
