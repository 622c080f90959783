//! Limits of one colour class, and their adjustment to picked pixels.

use bica_vision::colour::Filter;
use bica_vision::frame::Pixel;
use serde::Serialize;

/// Largest angle between two hues of a class, degrees.
const MAX_WIDTH: i16 = 179;
/// Largest saturation of a class that is a parameter of the robot, percent.
const MAX_SATURATION: u16 = 1000;

/// Limits of one colour class, as in a profile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(super) struct Limits {
    /// First and last hue, degrees; the first in 0..360. None: all.
    pub(super) hue: Option<(i16, i16)>,
    /// Percent.
    pub(super) saturation: (u16, u16),
    pub(super) luma: (u8, u8),
    /// Minimum length of the chroma vector, counts.
    pub(super) chroma: u8,
}

/// Measured values of a pixel: hue in degrees, saturation in percent, luma and chroma in counts.
#[derive(Clone, Copy, Debug)]
struct Measured {
    hue: f32,
    saturation: f32,
    luma: u8,
    chroma: f32,
}

impl Measured {
    fn new(pixel: Pixel) -> Self {
        let (b, r) = (f32::from(pixel.cb) - 128.0, f32::from(pixel.cr) - 128.0);
        let chroma = b.hypot(r);
        let hue = r.atan2(b).to_degrees().rem_euclid(360.0);
        Self { hue, saturation: 100.0 * chroma / f32::from(pixel.y.max(1)), luma: pixel.y, chroma }
    }
}

/// Returns the colour at the centre of a pixel's cell in the classification table.
pub(super) fn cell(pixel: Pixel) -> Pixel {
    Pixel::new(pixel.y & !15 | 8, pixel.cb & !3 | 2, pixel.cr & !3 | 2)
}

impl From<&Filter> for Limits {
    fn from(filter: &Filter) -> Self {
        Self {
            hue: filter.hue_range(),
            saturation: filter.saturation_range(),
            luma: filter.luma_bounds(),
            chroma: filter.least_chroma(),
        }
    }
}

impl Limits {
    pub(super) fn filter(&self) -> Filter {
        let filter = Filter::ANY.saturation(self.saturation.0, self.saturation.1).luma(self.luma.0, self.luma.1);
        let filter = filter.chroma(self.chroma);
        self.hue.map_or(filter, |(from, to)| filter.hue(from, to))
    }

    /// Returns whether the robot assigns the pixel to the class.
    pub(super) fn has(&self, pixel: Pixel) -> bool {
        self.filter().accepts(pixel) && self.filter().accepts(cell(pixel))
    }

    /// Returns the smallest limits that also contain the pixel.
    pub(super) fn grown(mut self, pixel: Pixel) -> Self {
        for colour in [pixel, cell(pixel)] {
            let Measured { hue, saturation, luma, chroma } = Measured::new(colour);
            // Measured values are rounded to whole numbers, so a limit may have to move one or two further.
            for slack in 0..3 {
                if self.filter().accepts(colour) {
                    break;
                }
                let (low, high) = (saturation.floor() as u16, saturation.ceil() as u16);
                self.saturation.0 = self.saturation.0.min(low.saturating_sub(slack));
                self.saturation.1 = self.saturation.1.max((high + slack).min(MAX_SATURATION));
                self.luma = (self.luma.0.min(luma), self.luma.1.max(luma));
                self.chroma = self.chroma.min((chroma.floor() as u8).saturating_sub(slack as u8));
                self.hue = self.hue.map(|range| widened(range, hue, slack as i16));
            }
        }
        self
    }

    /// Returns limits without the pixel. One limit moves: the one that excludes the fewest pixels of `kept` and, of these, loses the
    /// smallest part of its range.
    pub(super) fn shrunk(self, pixel: Pixel, kept: &[Pixel]) -> Self {
        let colour = if self.filter().accepts(cell(pixel)) { cell(pixel) } else { pixel };
        let lost = |limits: &Self| kept.iter().filter(|pixel| !limits.has(**pixel)).count();
        let candidates = self.candidates(&Measured::new(colour));
        let valid = candidates.into_iter().filter(|(limits, _)| !limits.filter().accepts(colour));
        let cost = |(limits, share): &(Self, f32)| (lost(limits), *share);
        let best = valid.min_by(|a, b| {
            let (a, b) = (cost(a), cost(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        best.map_or(self, |(limits, _)| limits)
    }

    /// Returns candidate limits that exclude a colour by one moved limit, each with the lost fraction of its range.
    fn candidates(self, at: &Measured) -> Vec<(Self, f32)> {
        let mut all = Vec::new();
        let share = |lost: f32, of: f32| (lost / of.max(1.0)).abs();
        if let Some((from, to)) = self.hue {
            let hue = from as f32 + (at.hue - f32::from(from)).rem_euclid(360.0);
            let width = f32::from(to - from);
            for slack in [1, 2] {
                let (first, last) = (hue.ceil() as i16 + slack - 1, hue.floor() as i16 - slack + 1);
                if first < to {
                    let begin = first.rem_euclid(360);
                    let limits = Self { hue: Some((begin, begin + to - first)), ..self };
                    all.push((limits, share(f32::from(first - from), width)));
                }
                if last > from {
                    all.push((Self { hue: Some((from, last)), ..self }, share(f32::from(to - last), width)));
                }
            }
        }
        let (least, most) = self.saturation;
        // Saturations above 100 % are rare, so the range ends there for the fraction.
        let width = f32::from(most.min(100).saturating_sub(least));
        let (above, below) = (at.saturation.floor() as u16 + 1, (at.saturation.ceil() as u16).saturating_sub(1));
        if above < most {
            let limits = Self { saturation: (above, most), ..self };
            all.push((limits, share(f32::from(above) - f32::from(least), width)));
        }
        if below > least {
            let limits = Self { saturation: (least, below), ..self };
            all.push((limits, share(f32::from(most.min(100)) - f32::from(below), width)));
        }
        let (dark, bright) = self.luma;
        let width = f32::from(bright.saturating_sub(dark));
        if at.luma < bright {
            let limits = Self { luma: (at.luma + 1, bright), ..self };
            all.push((limits, share(f32::from(at.luma) + 1.0 - f32::from(dark), width)));
        }
        if at.luma > dark {
            let limits = Self { luma: (dark, at.luma - 1), ..self };
            all.push((limits, share(f32::from(bright) - f32::from(at.luma) + 1.0, width)));
        }
        let chroma = at.chroma.floor() as u8 + 1;
        if chroma < 180 {
            // Half of the chroma vectors that occur are shorter than this.
            const USUAL: f32 = 60.0;
            all.push((Self { chroma, ..self }, share(f32::from(chroma) - f32::from(self.chroma), USUAL)));
        }
        all
    }
}

/// Widens a range of hues on the nearer side, by `slack` degrees more than necessary.
fn widened((from, to): (i16, i16), hue: f32, slack: i16) -> (i16, i16) {
    let after = (hue - f32::from(from)).rem_euclid(360.0);
    let width = f32::from(to - from);
    if after <= width && slack == 0 {
        return (from, to);
    }
    if after <= width {
        // The hue is inside, but the limits in the robot's units are slightly narrower.
        let (from, to) = if after < width - after { (from - slack, to) } else { (from, to + slack) };
        let begin = from.rem_euclid(360);
        return (begin, begin + (to - from).min(MAX_WIDTH));
    }
    let (beyond, before) = (after - width, 360.0 - after);
    let (from, to) = if beyond <= before {
        (from, from + (after.ceil() as i16 + slack).max(to - from))
    } else {
        (from - before.ceil() as i16 - slack, to)
    };
    let begin = from.rem_euclid(360);
    (begin, begin + (to - from).min(MAX_WIDTH))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn orange() -> Limits {
        Limits { hue: Some((120, 145)), saturation: (30, 400), luma: (60, 200), chroma: 30 }
    }

    /// Many colours, in a fixed order.
    fn colours() -> impl Iterator<Item = Pixel> {
        (0..4000_u32).map(|index| {
            let [y, cb, cr, _] = index.wrapping_mul(2_654_435_761).to_le_bytes();
            Pixel::new(y, cb, cr)
        })
    }

    #[test]
    fn a_picked_pixel_is_in_the_class_and_nothing_is_lost() {
        let mut grown_at_all = 0;
        for pixel in colours().filter(|pixel| pixel.y > 20) {
            let grown = orange().grown(pixel);
            let wide = grown.hue.is_some_and(|(from, to)| to - from >= MAX_WIDTH);
            assert!(wide || grown.has(pixel), "{pixel:?} {grown:?}");
            grown_at_all += usize::from(grown != orange());
            for other in colours().take(200).filter(|other| !wide && orange().has(*other)) {
                assert!(grown.has(other), "{pixel:?} {other:?} {grown:?}");
            }
        }
        assert!(grown_at_all > 1000);
    }

    #[test]
    fn limits_that_have_a_pixel_do_not_grow() {
        for pixel in colours().filter(|pixel| orange().has(*pixel)) {
            assert_eq!(orange().grown(pixel), orange());
        }
    }

    #[test]
    fn only_the_removed_pixel_leaves_the_class() {
        let own: Vec<Pixel> = colours().filter(|pixel| orange().has(*pixel)).collect();
        assert!(own.len() > 5);
        let (kept, removed) = (own[0], own[1]);
        let shrunk = orange().shrunk(removed, &[kept]);
        assert!(!shrunk.has(removed), "{shrunk:?}");
        assert!(shrunk.has(kept), "{shrunk:?}");
    }

    #[test]
    fn limits_of_a_filter_make_the_same_filter() {
        for (_, filter) in bica_vision::profile::NAO_2009.in_order() {
            assert_eq!(Limits::from(filter).filter(), *filter);
        }
    }
}
