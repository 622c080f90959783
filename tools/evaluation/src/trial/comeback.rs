//! Games in which the forward is pushed over: it has to get up, localize itself again and score.

use bica_app::Failure;
use bica_sim::setup::Setup;
use glam::Vec2;

use super::fall_subject::FallSubject;
use super::get_up::{GREATEST_PUSH, LEAST_PUSH};
use super::series::{Series, random};
use super::table::{Row, median};

/// Earliest and latest time of the push, s after the start.
const EARLIEST_PUSH: f32 = 5.0;
const LATEST_PUSH: f32 = 15.0;
/// Time to score after the push, s.
const TIME_LIMIT: f32 = 180.0;

/// Plays one game for each seed, with cameras, from a random start.
pub(super) fn rows(series: &Series) -> Result<Vec<Row>, Failure> {
    let games = series.each(|seed| play(series, seed))?;
    let goals: Vec<f32> = games.iter().flatten().copied().collect();
    let good = goals.len();
    let figures = format!("median {:.0} s after the fall", median(goals));
    Ok(vec![Row::new("pushed over, scores", games.len(), good, series.needed(18), figures)])
}

/// Returns the time from the fall to the next goal, s; `None` without a goal.
fn play(series: &Series, seed: u64) -> Result<Option<f32>, Failure> {
    let mut subject = FallSubject::in_game(&Setup { seed, ..Setup::default() }, &series.physics, true)?;
    let mut rng = random(seed);
    subject.run(rng.between(EARLIEST_PUSH, LATEST_PUSH))?;
    let direction = Vec2::from_angle(rng.between(0.0, core::f32::consts::TAU));
    subject.push(rng.between(LEAST_PUSH, GREATEST_PUSH) * direction);
    for _ in 0..TIME_LIMIT as u32 {
        subject.run(1.0)?;
        if let Some(time) = subject.time_to_goal() {
            return Ok(Some(time));
        }
    }
    Ok(None)
}
