//! Falls: seen before the ground is hit, taken softly, and over soon; and none seen where there is none.

use bica_motion::fall::{FallDetector, FallState};
use bica_motion::kick::{Kick, KickMotion};
use bica_motion::model::{Nao, RobotModel};
use bica_motion::pose::Pose2;
use bica_motion::walk::{Feedback, Velocity};
use bica_sim::{CYCLE_SECONDS, World};
use glam::Vec2;

use super::bench::Bench;
use super::fall_subject::FallSubject;
use super::get_up::{THROW, TIME};
use super::rng::Rng;
use super::table::{Row, median};
use super::walker::{Walker, cycles};
use bica_console::Failure;

/// The push comes while it stands, turns or walks, between these times, s.
const WHEN: (f32, f32) = (1.0, 6.0);
/// Walks as the rng say, s each, until someone believes to fall.
const WALKS: usize = 10;
const WALK: f32 = 2.0;

/// Pushes from eight sides, and walks and kicks without any.
pub fn rows(bench: &Bench) -> Result<Vec<Row>, Failure> {
    let names =
        ["the front", "front left", "the left", "back left", "the back", "back right", "the right", "front right"];
    let pushes = names.into_iter().enumerate().map(|(eighth, name)| {
        let way = Vec2::from_angle(eighth as f32 * core::f32::consts::FRAC_PI_4);
        push(bench, name, way)
    });
    pushes.chain([calm(bench)]).collect()
}

fn push(bench: &Bench, name: &str, way: Vec2) -> Result<Row, Failure> {
    let falls = bench.each(|seed| fall(bench, seed, way))?;
    let ahead: Vec<f32> = falls.iter().filter_map(|fall| fall.ahead).collect();
    let least = ahead.iter().copied().fold(f32::INFINITY, f32::min);
    let (soft, up) = (count(&falls, |fall| fall.soft), count(&falls, |fall| fall.recovered));
    Ok(Row {
        name: format!("to {name}"),
        runs: falls.len(),
        good: count(&falls, |fall| fall.ahead.is_some_and(|ahead| ahead > 0.0) && fall.soft && fall.recovered),
        needed: bench.needed(19),
        figures: format!(
            "seen {:.0} ms (least {:.0}) before the ground is hit, soft {soft}, plays on {up}",
            1000.0 * median(ahead),
            1000.0 * least
        ),
        figures_hold: true,
    })
}

fn count(falls: &[Fall], which: impl Fn(&Fall) -> bool) -> usize {
    falls.iter().filter(|fall| which(fall)).count()
}

struct Fall {
    /// From feeling the fall to hitting the ground, s.
    ahead: Option<f32>,
    /// Whether the legs had let go by then.
    soft: bool,
    /// Whether it got up in time and went on.
    recovered: bool,
}

fn fall(bench: &Bench, seed: u64, way: Vec2) -> Result<Fall, Failure> {
    let (mut subject, mut rng) = (FallSubject::new(bench, seed)?, Rng::new(seed));
    subject.live(rng.between(WHEN.0, WHEN.1))?;
    subject.push(rng.between(THROW.0, THROW.1) * way);
    subject.live(TIME + 2.0)?;
    Ok(Fall {
        ahead: subject.felt.zip(subject.hit).map(|(felt, (hit, _))| hit - felt),
        soft: subject.hit.is_some_and(|(_, soft)| soft),
        recovered: subject.lay().is_some_and(|time| time <= TIME) && subject.plays(),
    })
}

/// Whoever walks, turns, stops and kicks and does not fall must not believe to.
fn calm(bench: &Bench) -> Result<Row, Failure> {
    let runs = bench.each(|seed| Ok(!walk(bench, seed)? && !kick(bench, seed)?))?;
    let good = runs.iter().filter(|calm| **calm).count();
    let figures = format!("{:.0} s of walking and six kicks each, nothing felt", WALKS as f32 * WALK);
    Ok(Row {
        name: "no fall, none felt".into(),
        runs: runs.len(),
        good,
        needed: runs.len(),
        figures,
        figures_hold: true,
    })
}

/// Whether a fall is felt where none is.
fn mistaken(balance: &mut FallDetector, walker: &mut Walker) -> bool {
    let felt = balance.step(&walker.world.sensors().inertial, CYCLE_SECONDS);
    felt != FallState::Upright && !walker.fell()
}

fn walk(bench: &Bench, seed: u64) -> Result<bool, Failure> {
    let mut walker = Walker::new(seed, Pose2::ORIGIN, &bench.physics)?;
    let (mut rng, mut balance) = (Rng::new(seed), FallDetector::new());
    for _ in 0..WALKS {
        let velocity =
            Velocity { forward: rng.between(-0.1, 0.25), left: rng.between(-0.1, 0.1), turn: rng.between(-0.8, 0.8) };
        for _ in 0..cycles(WALK) {
            walker.cycle(velocity);
            if mistaken(&mut balance, &mut walker) {
                return Ok(true);
            }
        }
    }
    Ok(false)
}

fn kick(bench: &Bench, seed: u64) -> Result<bool, Failure> {
    let mut walker = Walker::new(seed, Pose2::ORIGIN, &bench.physics)?;
    let mut balance = FallDetector::new();
    for kick in Kick::ALL {
        let mut motion = KickMotion::<Nao>::new(kick, Nao::DYNAMIC_PROFILE);
        while !motion.is_done() {
            let limbs = motion.step(&Feedback::from(&walker.world.sensors()), CYCLE_SECONDS);
            walker.act(&limbs);
            if mistaken(&mut balance, &mut walker) {
                return Ok(true);
            }
        }
        walker.go(Velocity::ZERO, 1.0);
    }
    Ok(false)
}
