//! Falls: each must be detected before the impact, with relaxed joints, and followed by a recovery. Without a fall
//! there must be no detection.

use bica_app::Failure;
use bica_motion::fall::{FallDetector, FallState};
use bica_motion::kick::{Kick, KickMotion};
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::walk::{Feedback, Velocity};
use bica_sim::{CYCLE_SECONDS, World};
use glam::Vec2;

use super::fall_subject::FallSubject;
use super::get_up::{GREATEST_PUSH, LEAST_PUSH, TIME_LIMIT};
use super::series::{Series, random};
use super::table::{Row, median};
use super::walker::{Walker, cycles};

/// Earliest and latest time of the push, s; the robot may stand, turn or walk at that time.
const EARLIEST_PUSH: f32 = 1.0;
const LATEST_PUSH: f32 = 6.0;
/// Number of random walks without a push, and the duration of each, s.
const WALKS: usize = 10;
const WALK: f32 = 2.0;

/// Runs pushes in eight directions, then walks and kicks without a push.
pub(super) fn rows(series: &Series) -> Result<Vec<Row>, Failure> {
    let names =
        ["the front", "front left", "the left", "back left", "the back", "back right", "the right", "front right"];
    let pushes = names.into_iter().enumerate().map(|(eighth, name)| {
        let direction = Vec2::from_angle(eighth as f32 * core::f32::consts::FRAC_PI_4);
        push(series, name, direction)
    });
    pushes.chain([without_falls(series)]).collect()
}

fn push(series: &Series, name: &str, direction: Vec2) -> Result<Row, Failure> {
    let falls = series.each(|seed| fall(series, seed, direction))?;
    let lead_time: Vec<f32> = falls.iter().filter_map(|fall| fall.lead_time).collect();
    let min = lead_time.iter().copied().fold(f32::INFINITY, f32::min);
    let (relaxed, up) = (count(&falls, |fall| fall.relaxed), count(&falls, |fall| fall.recovered));
    let is_good = |fall: &Fall| fall.lead_time.is_some_and(|time| time > 0.0) && fall.relaxed && fall.recovered;
    let (median, min) = (1000.0 * median(lead_time), 1000.0 * min);
    let figures =
        format!("detected {median:.0} ms (minimum {min:.0}) before the impact, relaxed {relaxed}, recovered {up}");
    Ok(Row::new(format!("to {name}"), falls.len(), count(&falls, is_good), series.needed(19), figures))
}

fn count(falls: &[Fall], which: impl Fn(&Fall) -> bool) -> usize {
    falls.iter().filter(|fall| which(fall)).count()
}

struct Fall {
    /// Time from the detection to the impact, s.
    lead_time: Option<f32>,
    /// Whether the legs were relaxed at the impact.
    relaxed: bool,
    /// Whether the robot stood up in time and continued the game.
    recovered: bool,
}

fn fall(series: &Series, seed: u64, direction: Vec2) -> Result<Fall, Failure> {
    let (mut subject, mut rng) = (FallSubject::new(series, seed)?, random(seed));
    subject.run(rng.between(EARLIEST_PUSH, LATEST_PUSH))?;
    subject.push(rng.between(LEAST_PUSH, GREATEST_PUSH) * direction);
    subject.run(TIME_LIMIT + 2.0)?;
    Ok(Fall {
        lead_time: subject.fall_detected.zip(subject.impact).map(|(detected, impact)| impact.at - detected),
        relaxed: subject.impact.is_some_and(|impact| impact.relaxed),
        recovered: subject.time_down().is_some_and(|time| time <= TIME_LIMIT) && subject.is_playing(),
    })
}

/// Runs walks, turns, stops and kicks without a fall; no fall may be detected.
fn without_falls(series: &Series) -> Result<Row, Failure> {
    let runs = series.each(|seed| Ok(!walk(series, seed)? && !kick(series, seed)?))?;
    let good = runs.iter().filter(|without_falls| **without_falls).count();
    let figures = format!("{:.0} s of walking and six kicks each, no fall detected", WALKS as f32 * WALK);
    Ok(Row::new("no fall, none detected", runs.len(), good, runs.len(), figures))
}

/// Returns whether a fall is detected although the robot did not fall.
fn is_false_detection(balance: &mut FallDetector, walker: &mut Walker) -> bool {
    let state = balance.step(&walker.world.sensors().inertial, CYCLE_SECONDS);
    state != FallState::Upright && !walker.fell()
}

fn walk(series: &Series, seed: u64) -> Result<bool, Failure> {
    let mut walker = Walker::new(NAO, seed, Pose2::ORIGIN, &series.physics)?;
    let (mut rng, mut balance) = (random(seed), FallDetector::new(NAO));
    for _ in 0..WALKS {
        let velocity =
            Velocity { forward: rng.between(-0.1, 0.25), left: rng.between(-0.1, 0.1), turn: rng.between(-0.8, 0.8) };
        for _ in 0..cycles(WALK) {
            walker.cycle(velocity);
            if is_false_detection(&mut balance, &mut walker) {
                return Ok(true);
            }
        }
    }
    Ok(false)
}

fn kick(series: &Series, seed: u64) -> Result<bool, Failure> {
    let mut walker = Walker::new(NAO, seed, Pose2::ORIGIN, &series.physics)?;
    let mut balance = FallDetector::new(NAO);
    for kick in Kick::ALL {
        let mut motion = KickMotion::new(NAO, kick, NAO.dynamic_profile);
        while !motion.is_done() {
            let limbs = motion.step(&Feedback::from(&walker.world.sensors()), CYCLE_SECONDS);
            walker.act(&limbs);
            if is_false_detection(&mut balance, &mut walker) {
                return Ok(true);
            }
        }
        walker.go(Velocity::ZERO, 1.0);
    }
    Ok(false)
}
