//! Synthetic worst-case frames, as a defective camera may send them.

use bica_motion::joints::Joints;
use bica_motion::model::NAO;
use bica_motion::robot::CameraId;
use bica_motion::side::Side;
use bica_vision::profile::BUILT_IN_TABLE;
use bica_vision::projection::Camera;
use rand_pcg::{Pcg32, rand_core::Rng};

use super::{FrameSet, Sample};

/// One colour of each class of the kinematic world, and one of no class: Y, Cb, Cr.
pub const COLOURS: [(&str, [u8; 3]); 6] = [
    ("orange", [130, 88, 177]),
    ("yellow", [140, 78, 143]),
    ("blue", [120, 158, 98]),
    ("white", [190, 127, 127]),
    ("green", [80, 118, 113]),
    ("dark", [60, 128, 128]),
];
const GREEN: usize = 4;

/// Pattern: colour index of a pixel pair from its position.
pub type Pattern = fn(u16, u16, &mut Pcg32) -> usize;

/// Patterns with their names.
pub const PATTERNS: [(&str, Pattern); 9] = [
    ("flat", |_, _, _| 0),
    ("checker of pairs", |x, y, _| usize::from(x + y) % 2),
    ("checker of pairs on every second row", |x, y, _| usize::from(x + y / 2) % 2),
    ("columns of pairs", |x, _, _| usize::from(x) % 2),
    ("columns of 4 pairs", |x, _, _| usize::from(x / 4) % 2),
    ("columns of 16 pairs", |x, _, _| usize::from(x / 16) % 2),
    ("rows by 2", |_, y, _| usize::from(y / 2) % 2),
    ("blocks of 8 pairs", |x, y, _| usize::from(x / 8 + y / 16) % 2),
    ("noise", |_, _, random| random.next_u32() as usize >> 8 & 1),
];

/// Renders each pattern in each pair of colours, with and without carpet below, and frames of noise.
pub fn frame_set(size: (u16, u16)) -> FrameSet {
    let mut samples = Vec::new();
    for (first, second) in (0..6).flat_map(|first| (0..6).map(move |second| (first, second))) {
        for (name, pattern) in PATTERNS.iter().filter(|_| first != second) {
            samples.extend([0, 3, 6].map(|carpet| made_up(size, (name, *pattern), [first, second], carpet)));
        }
    }
    samples.extend([noise_of_colours(size), noise_of_bytes(size)]);
    FrameSet { name: "worst", table: BUILT_IN_TABLE.clone(), samples }
}

/// Renders a pattern in two colours; `carpet` is the covered share of the height, in eighths.
pub fn made_up(size: (u16, u16), (name, pattern): (&str, Pattern), [first, second]: [usize; 2], carpet: u16) -> Sample {
    let name = format!("{name}: {}, {}; carpet {carpet}/8", COLOURS[first].0, COLOURS[second].0);
    sample(name, size, |x, y, random| {
        let on_carpet = y >= size.1 - size.1 / 8 * carpet;
        let pick = if on_carpet { GREEN } else { [first, second][pattern(x, y, random)] };
        COLOURS[pick].1
    })
}

/// Renders noise of all colours.
#[must_use]
pub fn noise_of_colours(size: (u16, u16)) -> Sample {
    sample("noise of all colours".to_owned(), size, |_, _, random| COLOURS[random.next_u32() as usize % 6].1)
}

/// Renders random bytes.
#[must_use]
pub fn noise_of_bytes(size: (u16, u16)) -> Sample {
    sample("noise of bytes".to_owned(), size, |_, _, random| {
        let [a, b, c, _] = random.next_u32().to_le_bytes();
        [a, b, c]
    })
}

fn sample(name: String, (width, height): (u16, u16), colour: impl Fn(u16, u16, &mut Pcg32) -> [u8; 3]) -> Sample {
    let mut random = Pcg32::new(7, 7);
    let pairs = (0..height).flat_map(|y| (0..width / 2).map(move |x| (x, y)));
    let yuyv = pairs.flat_map(|(x, y)| {
        let [luma, cb, cr] = colour(x, y, &mut random);
        [luma, cb, luma, cr]
    });
    let yuyv = yuyv.collect();
    let camera = Camera::of(NAO, CameraId::Top, &Joints::all(0.0), Side::Left, width, height);
    Sample { name, width, height, yuyv, camera: Some(camera) }
}
