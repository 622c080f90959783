//! A game in which the forward is knocked over: it has to get up, find its way again, and score.

use bica_sim::setup::Setup;
use glam::Vec2;

use super::bench::Bench;
use super::fall_subject::FallSubject;
use super::get_up::THROW;
use super::rng::Rng;
use super::table::{Row, median};
use bica_console::Failure;

/// When it is knocked over, s after the start.
const WHEN: (f32, f32) = (5.0, 15.0);
/// Time to score from then, s.
const TIME: f32 = 180.0;

/// One game for each seed, with cameras, from a start by chance.
pub fn rows(bench: &Bench) -> Result<Vec<Row>, Failure> {
    let games = bench.each(|seed| play(bench, seed))?;
    let goals: Vec<f32> = games.iter().flatten().copied().collect();
    Ok(vec![Row {
        name: "knocked over, scores".into(),
        runs: games.len(),
        good: goals.len(),
        needed: bench.needed(18),
        figures: format!("median {:.0} s after the fall", median(goals)),
        figures_hold: true,
    }])
}

/// From the fall to the next goal, s.
fn play(bench: &Bench, seed: u64) -> Result<Option<f32>, Failure> {
    let mut subject = FallSubject::in_game(&Setup { seed, ..Setup::default() }, &bench.physics, true)?;
    let mut rng = Rng::new(seed);
    subject.live(rng.between(WHEN.0, WHEN.1))?;
    let way = Vec2::from_angle(rng.between(0.0, core::f32::consts::TAU));
    subject.push(rng.between(THROW.0, THROW.1) * way);
    for _ in 0..TIME as u32 {
        subject.live(1.0)?;
        if let Some(time) = subject.scored() {
            return Ok(Some(time));
        }
    }
    Ok(None)
}
