//! Kicks: how far the ball goes, where to, and whether the robot stands afterwards.

use bica_motion::kick::{Kick, KickKind, KickMotion};
use bica_motion::pose::{Pose2, wrap};
use bica_motion::profile::Profile;
use bica_motion::side::Side;
use bica_motion::walk::{Body, Velocity};
use bica_sim::{CYCLE_SECONDS, World};
use glam::Vec2;

use super::bench::Bench;
use super::dice::Dice;
use super::table::{Row, median};
use super::walker::Walker;
use crate::program::ending::Failure;

/// The ball lies within this of where it should, m.
const BESIDE: f32 = 0.01;
/// The most that the median direction may be off, degrees.
const OFF: f32 = 15.0;

/// All six kicks.
pub(crate) fn rows(bench: &Bench) -> Result<Vec<Row>, Failure> {
    Kick::ALL.iter().map(|kick| row(bench, *kick)).collect()
}

fn row(bench: &Bench, kick: Kick) -> Result<Row, Failure> {
    let runs = bench.each(|seed| play(bench, seed, kick))?;
    let way = median(runs.iter().map(|run| run.way).collect());
    let off = median(runs.iter().map(|run| run.off).collect());
    let (kind, least) = match kick.kind {
        KickKind::Front => ("front", 2.0),
        KickKind::Diagonal => ("diagonal", 1.2),
        KickKind::Lateral => ("lateral", 1.0),
    };
    let foot = if kick.foot == Side::Left { "left" } else { "right" };
    Ok(Row {
        name: format!("{kind}, {foot} foot"),
        runs: runs.len(),
        good: runs.iter().filter(|run| run.stands).count(),
        needed: bench.needed(19),
        figures: format!("median way {way:.2} m of {least:.1} m, median off by {off:.0} degrees"),
        figures_hold: way >= least && off <= OFF,
    })
}

struct Played {
    way: f32,
    /// Degrees.
    off: f32,
    stands: bool,
}

fn play(bench: &Bench, seed: u64, kick: Kick) -> Result<Played, Failure> {
    let mut walker = Walker::new(seed, Pose2::new(-1.0, 0.0, 0.0), &bench.physics)?;
    let mut dice = Dice::new(seed);
    let mut beside = || dice.between(-BESIDE, BESIDE);
    let start = ground(&mut walker);
    let ball = start.place(kick.ball(&Profile::NAO.kicks) + Vec2::new(beside(), beside()));
    walker.world.place_ball(ball);
    let mut motion = KickMotion::new(kick, &Profile::NAO);
    while !motion.is_done() {
        let limbs = motion.step(&Body::from(&walker.world.sensors()), CYCLE_SECONDS);
        walker.act(&limbs);
    }
    walker.go(Velocity::ZERO, 1.0);
    let stands = !walker.fell();
    for _ in 0..800 {
        walker.cycle(Velocity::ZERO);
    }
    let way = walker.world.referee().ball() - ball;
    let off = wrap(way.to_angle() - start.heading - kick.direction()).abs().to_degrees();
    Ok(Played { way: way.length(), off, stands })
}

/// The ground between the feet.
fn ground(walker: &mut Walker) -> Pose2 {
    let hips = walker.pose();
    let from_ground = bica_motion::kinematics::ground_from_robot(Side::Left, &walker.world.sensors().angles);
    hips * Pose2::new(from_ground.translation.x, from_ground.translation.y, 0.0).inverse()
}
