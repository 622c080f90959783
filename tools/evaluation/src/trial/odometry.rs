//! Odometry against the truth.

use std::f32::consts::PI;

use bica_motion::pose::{Pose2, wrap};
use bica_motion::walk::Velocity;

use super::bench::Bench;
use super::rng::Rng;
use super::table::{Row, median};
use super::walker::{Walker, cycles};
use bica_console::Failure;

/// How far it walks, m.
const WAY: f32 = 3.0;
/// From command to command, s.
const EVERY: f32 = 2.0;
/// The most that the median may be off: a share of the way, and degrees.
const OFF: (f32, f32) = (0.08, 8.0);

/// How far off the odometry is after three metres of mixed walking.
pub fn rows(bench: &Bench) -> Result<Vec<Row>, Failure> {
    let runs = bench.each(|seed| {
        let mut rng = Rng::new(seed);
        let mut walker = Walker::new(seed, Pose2::new(0.0, 0.0, rng.between(-PI, PI)), &bench.physics)?;
        let (start, believed) = (walker.pose(), walker.believed());
        let mut way = 0.0;
        for _ in 0..60 {
            let velocity = Velocity::new(rng.between(0.05, 0.2), rng.between(-0.06, 0.06), rng.between(-0.4, 0.4));
            for _ in 0..cycles(EVERY) {
                let before = walker.pose();
                walker.cycle(velocity);
                way += before.position.distance(walker.pose().position);
            }
            if way >= WAY || walker.fell() {
                break;
            }
        }
        let truly = start.inverse() * walker.pose();
        let told = believed.inverse() * walker.believed();
        let off = truly.position.distance(told.position) / way;
        let turned = wrap(truly.heading - told.heading).abs().to_degrees();
        Ok((!walker.fell()).then_some((off, turned)))
    })?;
    let off = median(runs.iter().flatten().map(|run| run.0).collect());
    let turned = median(runs.iter().flatten().map(|run| run.1).collect());
    Ok(vec![Row {
        name: "3 m of mixed walking".to_owned(),
        runs: runs.len(),
        good: runs.iter().flatten().count(),
        needed: bench.needed(19),
        figures: format!("median off by {:.1} % of the way and {turned:.1} degrees", 100.0 * off),
        figures_hold: off <= OFF.0 && turned <= OFF.1,
    }])
}
