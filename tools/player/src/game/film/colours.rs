//! Palette of a film: at most 255 colours, for fields, robots and goals.

use bica_drawing::canvas::Rgb;
use bica_drawing::palette as ink;
use bica_evaluation::pictures::palette as soccer;

/// Colours of a field in even light, 0 to 1.
const FIELD: [[f32; 3]; 9] = [
    [0.17, 0.38, 0.20],
    [0.15, 0.42, 0.20],
    [0.86, 0.42, 0.17],
    [0.78, 0.70, 0.10],
    [0.18, 0.42, 0.60],
    [0.66, 0.12, 0.13],
    [0.16, 0.20, 0.50],
    [0.27, 0.28, 0.33],
    [0.45, 0.33, 0.22],
];
/// Greys under different white balances.
const GREYS: [[f32; 3]; 3] = [[0.78, 0.78, 0.78], [0.80, 0.78, 0.73], [0.74, 0.77, 0.82]];
/// Number of shades of each colour.
const COLOUR_SHADES: usize = 15;
/// Number of shades of each grey.
const GREY_SHADES: usize = 30;
/// Colours of drawings.
const INKS: [Rgb; 9] = [
    ink::PAPER,
    ink::TEXT,
    ink::FAINT,
    ink::GHOST,
    ink::WHITE,
    soccer::YELLOW,
    soccer::BLUE,
    soccer::ESTIMATE,
    soccer::BALL,
];
/// Number of bits of each channel in the table of nearest colours.
const BITS: u32 = 5;

/// Palette with a table of nearest colours.
pub(super) struct Colours {
    /// The colours.
    pub(super) all: Vec<Rgb>,
    nearest: Vec<u8>,
}

impl Colours {
    pub(super) fn new() -> Self {
        let mut all = INKS.to_vec();
        for (bases, shades) in [(&FIELD[..], COLOUR_SHADES), (&GREYS[..], GREY_SHADES)] {
            let scale = |shade: usize| 0.25 + 1.1 * (shade as f32 + 0.5) / shades as f32;
            all.extend(bases.iter().flat_map(|base| {
                (0..shades).map(move |shade| base.map(|part| (255.0 * part * scale(shade)).min(255.0) as u8))
            }));
        }
        let middle = |cell: usize, channel: u32| (((cell >> (BITS * channel)) & 31) * 8 + 4) as i32;
        let nearest = (0..1_usize << (3 * BITS))
            .map(|cell| {
                let exact = [2, 1, 0].map(|channel| middle(cell, channel));
                let off = |colour: &Rgb| {
                    let part = |i: usize, weight: i32| weight * (i32::from(colour[i]) - exact[i]).pow(2);
                    part(0, 3) + part(1, 6) + part(2, 2)
                };
                let best = all.iter().enumerate().min_by_key(|(_, colour)| off(colour));
                best.map_or(0, |(index, _)| index as u8)
            })
            .collect();
        Self { all, nearest }
    }

    /// Returns the index of the nearest colour.
    pub(super) fn index(&self, [red, green, blue]: Rgb) -> u8 {
        let part = |value: u8| usize::from(value >> (8 - BITS));
        self.nearest[(part(red) << (2 * BITS)) | (part(green) << BITS) | part(blue)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn palette_leaves_an_index_for_transparency() {
        let colours = Colours::new();
        assert!(colours.all.len() < 256, "{}", colours.all.len());
        for colour in [[43, 97, 51], [219, 107, 43], [199, 178, 25], [190, 190, 190]] {
            let found = colours.all[usize::from(colours.index(colour))];
            let same = found.iter().zip(colour).all(|(a, b)| a.abs_diff(b) <= 12);
            assert!(same, "{colour:?} became {found:?}");
        }
    }
}
