//! Getting up: the forward is thrown over, and has to be on its feet again.

use glam::Vec2;

use super::bench::Bench;
use super::fall_subject::FallSubject;
use super::rng::Rng;
use super::table::{Row, median};
use bica_console::Failure;

/// Time to get up, s.
pub const TIME: f32 = 15.0;
/// How fast the torso is thrown over, m/s.
pub const THROW: (f32, f32) = (2.0, 2.6);

/// From the front, from the back, and from both sides.
pub fn rows(bench: &Bench) -> Result<Vec<Row>, Failure> {
    let falls = [("front", Vec2::X), ("back", Vec2::NEG_X), ("left", Vec2::Y), ("right", Vec2::NEG_Y)];
    let row = |(name, way)| {
        let times = bench.each(|seed| throw(bench, seed, way))?;
        let up: Vec<f32> = times.iter().flatten().copied().collect();
        let slowest = up.iter().copied().fold(0.0, f32::max);
        Ok(Row {
            name: format!("from the {name}"),
            runs: times.len(),
            good: up.len(),
            needed: bench.needed(19),
            figures: format!("median {:.1} s, slowest {slowest:.1} s", median(up)),
            figures_hold: true,
        })
    };
    falls.into_iter().map(row).collect()
}

/// How long it took to be on its feet for good, s; none if it took too long, or if it did not even fall.
fn throw(bench: &Bench, seed: u64, way: Vec2) -> Result<Option<f32>, Failure> {
    let mut subject = FallSubject::new(bench, seed)?;
    subject.live(1.0)?;
    subject.push(Rng::new(seed).between(THROW.0, THROW.1) * way);
    subject.live(TIME + 1.0)?;
    Ok(subject.lay().filter(|time| *time <= TIME))
}
