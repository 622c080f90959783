//! Getting up without behaviours: detection of a fall, protection, get-up, stand.

use bica_app::Failure;
use bica_motion::fall::{FallDetector, FallState};
use bica_motion::getup::{GetUp, protection};
use bica_motion::joints::Joints;
use bica_motion::pose::Pose2;
use bica_motion::stiffness::Stiffness;
use bica_motion::walk::Velocity;
use bica_sim::referee::Event;
use bica_sim::{CYCLE_SECONDS, World};
use glam::Vec2;

use super::get_up::{GREATEST_PUSH, LEAST_PUSH, TIME_LIMIT};
use super::series::{Series, random};
use super::table::{Row, median};
use super::walker::{Walker, cycles};

/// Time for which the robot lies before an attempt, s.
const REST: f32 = 0.5;
/// Time after a push until the robot has fallen, s.
const FALL: f32 = 2.0;

/// Falls to the front and the back.
pub(super) fn rows(series: &Series) -> Result<Vec<Row>, Failure> {
    let row = |(name, direction)| {
        let times = series.each(|seed| push_over(series, seed, direction))?;
        let up: Vec<f32> = times.iter().flatten().copied().collect();
        let good = up.iter().filter(|time| **time <= series.course.time_to_rise).count();
        let (stood, slowest) = (up.len(), up.iter().copied().fold(0.0, f32::max));
        let figures = format!(
            "within {:.0} s; {stood} stand, median {:.1} s after the first movement, slowest {slowest:.1} s",
            series.course.time_to_rise,
            median(up)
        );
        Ok(Row::new(format!("from the {name}"), times.len(), good, series.needed(18), figures))
    };
    [("front", Vec2::X), ("back", Vec2::NEG_X)].into_iter().map(row).collect()
}

/// Returns the time from the first movement until the robot has stood for half a second and stands until the end, s.
fn push_over(series: &Series, seed: u64, direction: Vec2) -> Result<Option<f32>, Failure> {
    let mut walker = Walker::new(series.model, seed, Pose2::ORIGIN, &series.physics)?;
    walker.world.add_velocity(random(seed).between(LEAST_PUSH, GREATEST_PUSH) * direction);
    let mut falls = FallDetector::new(series.model);
    let (mut movement, mut failures, mut rest, mut began) = (GetUp::none(series.model), 0, REST, None);
    for _ in 0..cycles(FALL + TIME_LIMIT) {
        let sensors = walker.sense();
        let state = falls.step(&sensors.inertial, CYCLE_SECONDS);
        if !movement.is_done() {
            let (targets, stiffness) = movement.step(&sensors.inertial, CYCLE_SECONDS);
            walker.command(targets, Joints::all(stiffness));
            if movement.is_done() {
                (failures, rest) = (failures + 1, REST);
                walker.stand();
            }
        } else if let FallState::Falling(side) | FallState::Fallen(side) = state {
            walker.command(protection(series.model, side).posture, Stiffness::Fall.joints(series.model));
            rest -= if matches!(state, FallState::Fallen(_)) { CYCLE_SECONDS } else { 0.0 };
            if rest <= 0.0 {
                movement = GetUp::new(series.model, side, failures, sensors.angles);
                began = began.or(Some(walker.world.now().as_secs_f32()));
            }
        } else {
            walker.walk(Velocity::ZERO, &sensors);
        }
    }
    let events = walker.world.referee().events();
    let last = events.iter().rfind(|happened| matches!(happened.event, Event::Fall(_) | Event::GotUp));
    let up = last.filter(|last| last.event == Event::GotUp).map(|last| last.at.as_secs_f32());
    Ok(up.zip(began).map(|(up, began)| up - began))
}
