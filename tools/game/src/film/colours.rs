//! The colours of a film: at most 255, chosen for fields, robots and goals.

use bica_drawing::canvas::Rgb;
use bica_drawing::palette as ink;

/// What is on a field, evenly lit, 0 to 1.
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
/// Greys as cameras of different white balance see them.
const GREYS: [[f32; 3]; 3] = [[0.78, 0.78, 0.78], [0.80, 0.78, 0.73], [0.74, 0.77, 0.82]];
/// Shades of each colour, and of each grey.
const SHADES: (usize, usize) = (15, 30);
/// What is drawn on pictures.
const INKS: [Rgb; 9] =
    [ink::PAPER, ink::TEXT, ink::FAINT, ink::GHOST, ink::WHITE, ink::YELLOW, ink::BLUE, ink::BELIEF, ink::BALL];
/// Bits of each channel that choose the colour.
const BITS: u32 = 5;

/// Finds the nearest of a film's colours.
pub struct Colours {
    /// The colours.
    pub all: Vec<Rgb>,
    nearest: Vec<u8>,
}

impl Colours {
    pub fn new() -> Self {
        let mut all = INKS.to_vec();
        for (bases, shades) in [(&FIELD[..], SHADES.0), (&GREYS[..], SHADES.1)] {
            let scale = |shade: usize| 0.25 + 1.1 * (shade as f32 + 0.5) / shades as f32;
            all.extend(bases.iter().flat_map(|base| {
                (0..shades).map(move |shade| base.map(|part| (255.0 * part * scale(shade)).min(255.0) as u8))
            }));
        }
        let middle = |cell: usize, channel: u32| (((cell >> (BITS * channel)) & 31) * 8 + 4) as i32;
        let nearest = (0..1_usize << (3 * BITS))
            .map(|cell| {
                let wanted = [2, 1, 0].map(|channel| middle(cell, channel));
                let off = |colour: &Rgb| {
                    let part = |i: usize, weight: i32| weight * (i32::from(colour[i]) - wanted[i]).pow(2);
                    part(0, 3) + part(1, 6) + part(2, 2)
                };
                let best = all.iter().enumerate().min_by_key(|(_, colour)| off(colour));
                best.map_or(0, |(index, _)| index as u8)
            })
            .collect();
        Self { all, nearest }
    }

    /// The place of the colour nearest to one.
    pub fn index(&self, [red, green, blue]: Rgb) -> u8 {
        let part = |value: u8| usize::from(value >> (8 - BITS));
        self.nearest[(part(red) << (2 * BITS)) | (part(green) << BITS) | part(blue)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_byte_names_every_colour_and_one_more() {
        let colours = Colours::new();
        assert!(colours.all.len() < 256, "{}", colours.all.len());
        for colour in [[43, 97, 51], [219, 107, 43], [199, 178, 25], [190, 190, 190]] {
            let found = colours.all[usize::from(colours.index(colour))];
            let off = found.iter().zip(colour).map(|(a, b)| a.abs_diff(b)).max();
            assert!(off <= Some(12), "{colour:?} became {found:?}");
        }
    }
}
