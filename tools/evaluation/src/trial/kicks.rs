//! Kicks: how far the ball goes, where to, and whether the robot stands afterwards.

use bica_motion::kick::{Kick, KickKind, KickMotion};
use bica_motion::model::{Nao, RobotModel};
use bica_motion::pose::{Pose2, wrap};
use bica_motion::side::Side;
use bica_motion::walk::{Feedback, Velocity, in_walk_kick_foot};
use bica_sim::{CYCLE_SECONDS, World};
use glam::Vec2;

use super::bench::Bench;
use super::rng::Rng;
use super::table::{Row, median};
use super::walker::Walker;
use bica_console::Failure;

/// The ball lies within this of where it should, m.
const BESIDE: f32 = 0.01;
/// The least that a ball must go that was kicked in the walk, m.
const DRIBBLED: f32 = 0.5;
/// The most that the median direction may be off, degrees.
const OFF: f32 = 15.0;

/// All six kicks.
pub fn rows(bench: &Bench) -> Result<Vec<Row>, Failure> {
    let fixed = Kick::ALL.iter().map(|kick| row(bench, *kick));
    let in_walk = Side::BOTH.iter().map(|foot| dribble_row(bench, *foot));
    fixed.chain(in_walk).collect()
}

fn dribble_row(bench: &Bench, foot: Side) -> Result<Row, Failure> {
    let runs = bench.each(|seed| dribble(bench, seed, foot))?;
    let name = format!("dribble, {} foot", word(foot));
    Ok(sum_up(bench, name, &runs, DRIBBLED))
}

fn row(bench: &Bench, kick: Kick) -> Result<Row, Failure> {
    let runs = bench.each(|seed| play(bench, seed, kick))?;
    let (kind, least) = match kick.kind {
        KickKind::Front => ("front", 2.0),
        KickKind::Diagonal => ("diagonal", 1.2),
        KickKind::Lateral => ("lateral", 1.0),
    };
    let name = format!("{kind}, {} foot", word(kick.foot));
    Ok(sum_up(bench, name, &runs, least))
}

const fn word(foot: Side) -> &'static str {
    match foot {
        Side::Left => "left",
        Side::Right => "right",
    }
}

fn sum_up(bench: &Bench, name: String, runs: &[Played], least: f32) -> Row {
    let way = median(runs.iter().map(|run| run.way).collect());
    let off = median(runs.iter().map(|run| run.off).collect());
    Row {
        name,
        runs: runs.len(),
        good: runs.iter().filter(|run| run.stands).count(),
        needed: bench.needed(19),
        figures: format!("median way {way:.2} m of {least:.1} m, median off by {off:.0} degrees"),
        figures_hold: way >= least && off <= OFF,
    }
}

struct Played {
    way: f32,
    /// Degrees.
    off: f32,
    stands: bool,
}

fn play(bench: &Bench, seed: u64, kick: Kick) -> Result<Played, Failure> {
    let mut walker = Walker::new(seed, Pose2::new(-1.0, 0.0, 0.0), &bench.physics)?;
    let mut rng = Rng::new(seed);
    let mut beside = || rng.between(-BESIDE, BESIDE);
    let start = ground(&mut walker);
    let ball = start.place(kick.ball(&Nao::DYNAMIC_PROFILE.kicks) + Vec2::new(beside(), beside()));
    walker.world.place_ball(ball);
    let mut motion = KickMotion::<Nao>::new(kick, Nao::DYNAMIC_PROFILE);
    while !motion.is_done() {
        let limbs = motion.step(&Feedback::from(&walker.world.sensors()), CYCLE_SECONDS);
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

/// Walks to a ball that lies before a foot, through it, and on.
fn dribble(bench: &Bench, seed: u64, foot: Side) -> Result<Played, Failure> {
    let mut walker = Walker::new(seed, Pose2::new(-1.0, 0.0, 0.0), &bench.physics)?;
    let mut rng = Rng::new(seed);
    let start = ground(&mut walker);
    let half = Nao::DYNAMIC_PROFILE.gait.half_spacing;
    // Where in a step the ball comes within reach is by chance.
    let ball = start.place(Vec2::new(rng.between(0.5, 0.6), foot.sign() * half + rng.between(-BESIDE, BESIDE)));
    walker.world.place_ball(ball);
    let ahead = Velocity::new(0.15, 0.0, 0.0);
    for _ in 0..800 {
        if let Some(foot) = in_walk_kick_foot(ground(&mut walker).locate(ball), half) {
            walker.kick(foot);
        }
        walker.cycle(ahead);
        if walker.world.referee().ball().distance(ball) > 0.02 {
            break;
        }
    }
    walker.go(ahead, 1.0);
    walker.go(Velocity::ZERO, 7.0);
    let way = walker.world.referee().ball() - ball;
    let off = wrap(way.to_angle() - start.heading).abs().to_degrees();
    Ok(Played { way: way.length(), off, stands: !walker.fell() })
}

/// The ground between the feet.
fn ground(walker: &mut Walker) -> Pose2 {
    let hips = walker.pose();
    let from_ground = bica_motion::kinematics::ground_from_robot::<Nao>(Side::Left, &walker.world.sensors().angles);
    hips * Pose2::new(from_ground.translation.x, from_ground.translation.y, 0.0).inverse()
}
