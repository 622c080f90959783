//! Getting up: the forward is pushed over and has to stand again.

use bica_app::Failure;
use glam::Vec2;

use super::fall_subject::FallSubject;
use super::series::{Series, random};
use super::table::{Row, median};

/// Time to get up, s.
pub(super) const TIME_LIMIT: f32 = 15.0;
/// Least and greatest velocity that a push adds to the torso, m/s.
pub(super) const LEAST_PUSH: f32 = 2.0;
pub(super) const GREATEST_PUSH: f32 = 2.6;

/// Runs falls to the front, the back and both sides.
pub(super) fn rows(series: &Series) -> Result<Vec<Row>, Failure> {
    let falls = [("front", Vec2::X), ("back", Vec2::NEG_X), ("left", Vec2::Y), ("right", Vec2::NEG_Y)];
    let row = |(name, direction)| {
        let times = series.each(|seed| push_over(series, seed, direction))?;
        let up: Vec<f32> = times.iter().flatten().copied().collect();
        let slowest = up.iter().copied().fold(0.0, f32::max);
        let good = up.len();
        let figures = format!("median {:.1} s, slowest {slowest:.1} s", median(up));
        Ok(Row::new(format!("from the {name}"), times.len(), good, series.needed(19), figures))
    };
    falls.into_iter().map(row).collect()
}

/// Returns the time until the robot stood for good, s; `None` if it took too long or the robot did not fall.
fn push_over(series: &Series, seed: u64, direction: Vec2) -> Result<Option<f32>, Failure> {
    let mut subject = FallSubject::new(series, seed)?;
    subject.run(1.0)?;
    subject.push(random(seed).between(LEAST_PUSH, GREATEST_PUSH) * direction);
    subject.run(TIME_LIMIT + 1.0)?;
    Ok(subject.time_down().filter(|time| *time <= TIME_LIMIT))
}
