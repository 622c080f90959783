//! Trial of the odometry's error.

use std::f32::consts::PI;

use bica_app::Failure;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::{Pose2, wrap};
use bica_motion::walk::Velocity;

use super::series::{Series, random};
use super::table::{Row, median};
use super::walker::{Walker, cycles};

/// Length of the path, m.
const PATH_LENGTH: f32 = 3.0;
/// Time between two commands, s.
const COMMAND_INTERVAL: f32 = 2.0;
/// Largest median error of the position, as a fraction of the path.
const MAX_POSITION_ERROR: f32 = 0.08;
/// Largest median error of the heading, degrees.
const MAX_HEADING_ERROR: f32 = 8.0;

/// Measures the error of odometry after three metres of mixed walking.
pub(super) fn rows(series: &Series) -> Result<Vec<Row>, Failure> {
    let runs = series.each(|seed| {
        let mut rng = random(seed);
        let mut walker = Walker::new(NAO, seed, Pose2::new(0.0, 0.0, rng.between(-PI, PI)), &series.physics)?;
        let (start, start_estimate) = (walker.pose(), walker.odometry_pose());
        let mut path = 0.0;
        for _ in 0..60 {
            let velocity = Velocity::new(rng.between(0.05, 0.2), rng.between(-0.06, 0.06), rng.between(-0.4, 0.4));
            for _ in 0..cycles(COMMAND_INTERVAL) {
                let before = walker.pose();
                walker.cycle(velocity);
                path += before.position.distance(walker.pose().position);
            }
            if path >= PATH_LENGTH || walker.fell() {
                break;
            }
        }
        let truth = start.inverse() * walker.pose();
        let estimated = start_estimate.inverse() * walker.odometry_pose();
        let off = truth.position.distance(estimated.position) / path;
        let turned = wrap(truth.heading - estimated.heading).abs().to_degrees();
        Ok((!walker.fell()).then_some((off, turned)))
    })?;
    let off = median(runs.iter().flatten().map(|run| run.0).collect());
    let turned = median(runs.iter().flatten().map(|run| run.1).collect());
    Ok(vec![Row {
        name: "3 m of mixed walking".to_owned(),
        runs: runs.len(),
        good: runs.iter().flatten().count(),
        needed: series.needed(19),
        figures: format!("median error {:.1} % of the path and {turned:.1} degrees", 100.0 * off),
        figures_hold: off <= MAX_POSITION_ERROR && turned <= MAX_HEADING_ERROR,
    }])
}
