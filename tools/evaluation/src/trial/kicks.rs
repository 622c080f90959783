//! Kicks: distance and direction of the ball, and whether the robot stands afterwards.

use bica_app::Failure;
use bica_motion::kick::{Kick, KickKind, KickMotion};
use bica_motion::model::Profile;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::{Pose2, wrap};
use bica_motion::side::Side;
use bica_motion::walk::{Feedback, Velocity, in_walk_kick_foot};
use bica_sim::mujoco::Physics;
use bica_sim::{CYCLE_SECONDS, World};
use glam::Vec2;

use super::series::{Series, random};
use super::table::{Row, median};
use super::walker::Walker;

/// Largest error of the ball position along each axis, m.
const BALL_ERROR: f32 = 0.01;
/// Largest error of the median direction, degrees.
const MAX_DIRECTION_ERROR: f32 = 15.0;

/// All six kicks, then the in-walk kicks.
pub(super) fn rows(series: &Series) -> Result<Vec<Row>, Failure> {
    let fixed = Kick::ALL.iter().map(|kick| row(series, *kick));
    let in_walk = Side::BOTH.iter().map(|foot| dribble_row(series, *foot));
    fixed.chain(in_walk).collect()
}

fn dribble_row(series: &Series, foot: Side) -> Result<Row, Failure> {
    let runs = series.each(|seed| dribble(series, seed, foot))?;
    let name = format!("dribble, {} foot", name(foot));
    Ok(summarize(series, name, &runs, series.course.least_dribble))
}

fn row(series: &Series, kick: Kick) -> Result<Row, Failure> {
    let runs =
        series.each(|seed| kick_ball(series.model, &series.physics, seed, kick, series.model.dynamic_profile))?;
    let (kind, least) = match kick.kind {
        KickKind::Front => ("front", 2.0),
        KickKind::Diagonal => ("diagonal", 1.2),
        KickKind::Lateral => ("lateral", 1.0),
    };
    let name = format!("{kind}, {} foot", name(kick.foot));
    Ok(summarize(series, name, &runs, least))
}

const fn name(foot: Side) -> &'static str {
    match foot {
        Side::Left => "left",
        Side::Right => "right",
    }
}

fn summarize(series: &Series, name: String, runs: &[KickResult], least: f32) -> Row {
    let way = median(runs.iter().map(|run| run.way).collect());
    let off = median(runs.iter().map(|run| run.off).collect());
    Row {
        name,
        runs: runs.len(),
        good: runs.iter().filter(|run| run.stands && run.way >= series.course.least_kick).count(),
        needed: series.needed(19),
        figures: format!("median distance {way:.2} m (at least {least:.1} m), median direction error {off:.0} degrees"),
        figures_hold: way >= least && off <= MAX_DIRECTION_ERROR,
    }
}

/// Result of a kick.
#[derive(Clone, Copy, Debug)]
pub struct KickResult {
    /// Largest distance of the ball, m.
    pub way: f32,
    /// Error of the ball's direction, degrees.
    pub off: f32,
    /// Whether the robot still stands at the end.
    pub stands: bool,
}

/// Kicks a ball with the kick of a profile. The seed determines an error of the ball's position.
///
/// # Errors
/// If the physics is invalid.
pub fn kick_ball(
    model: &'static SimulatedModel,
    physics: &Physics,
    seed: u64,
    kick: Kick,
    profile: &'static Profile,
) -> Result<KickResult, Failure> {
    let mut walker = Walker::new(model, seed, Pose2::new(-1.0, 0.0, 0.0), physics)?;
    let mut rng = random(seed);
    let mut beside = || rng.between(-BALL_ERROR, BALL_ERROR);
    let start = ground(&mut walker);
    let ball = start.place(kick.ball(&profile.kicks) + Vec2::new(beside(), beside()));
    walker.put_ball(ball);
    let mut motion = KickMotion::new(model, kick, profile);
    while !motion.is_done() {
        let limbs = motion.step(&Feedback::from(&walker.world.sensors()), CYCLE_SECONDS);
        walker.act(&limbs);
    }
    walker.go(Velocity::ZERO, 1.0);
    let stands = !walker.fell();
    for _ in 0..800 {
        walker.cycle(Velocity::ZERO);
    }
    let way = walker.ball_way();
    let off = wrap(way.to_angle() - start.heading - kick.direction()).abs().to_degrees();
    Ok(KickResult { way: way.length(), off, stands })
}

/// Walks to a ball in front of a foot, kicks it in the walk, and walks on.
fn dribble(series: &Series, seed: u64, foot: Side) -> Result<KickResult, Failure> {
    let mut walker = Walker::new(series.model, seed, Pose2::new(-1.0, 0.0, 0.0), &series.physics)?;
    let mut rng = random(seed);
    let start = ground(&mut walker);
    let half = series.model.dynamic_profile.gait.half_spacing;
    // The phase of the step in which the ball comes within reach is random.
    let ball = start.place(Vec2::new(rng.between(0.5, 0.6), foot.sign() * half + rng.between(-BALL_ERROR, BALL_ERROR)));
    walker.put_ball(ball);
    let ahead = Velocity::new(0.15, 0.0, 0.0);
    for _ in 0..800 {
        if let Some(foot) = in_walk_kick_foot(ground(&mut walker).locate(ball), &series.model.dynamic_profile.gait) {
            walker.kick(foot);
        }
        walker.cycle(ahead);
        if walker.ball_way().length() > 0.02 {
            break;
        }
    }
    walker.go(ahead, 1.0);
    walker.go(Velocity::ZERO, 7.0);
    let way = walker.ball_way();
    let off = wrap(way.to_angle() - start.heading).abs().to_degrees();
    Ok(KickResult { way: way.length(), off, stands: !walker.fell() })
}

/// Returns the pose of the ground between the feet.
fn ground(walker: &mut Walker) -> Pose2 {
    let hips = walker.pose();
    let from_ground =
        bica_motion::kinematics::ground_from_robot(walker.model, Side::Left, &walker.world.sensors().angles);
    hips * Pose2::new(from_ground.translation.x, from_ground.translation.y, 0.0).inverse()
}
