//! Getting up where there is little room: beside a goal post, in the goal beside its net, beside the goalkeeper.

use std::f32::consts::{FRAC_PI_2, PI};

use bica_field::FIELD;
use bica_motion::pose::Pose2;
use bica_sim::World;
use bica_sim::mujoco::MujocoWorld;
use bica_sim::setup::{Setup, Start};
use glam::Vec2;

use super::bench::Bench;
use super::fall_subject::FallSubject;
use super::get_up::THROW;
use super::rng::Rng;
use super::table::{Row, median};
use bica_console::Failure;

/// From the middle of the robot to what it is beside, m: to a post or a net; to the middle of the goalkeeper.
const NEAR: (f32, f32) = (0.2, 0.5);
const NEAR_KEEPER: (f32, f32) = (0.3, 0.5);
/// It is thrown this often at most: what it leans against may hold it.
const THROWS: usize = 5;
/// Time to be on its feet for good, s; who then stands for [`STANDS`] does.
const TIME: f32 = 45.0;
const STANDS: f32 = 3.0;

/// Where it is before it is thrown over, where the goalkeeper stands there.
type Place = fn(&mut Rng, Vec2) -> Pose2;

/// Thrown over to any side, at three kinds of places.
pub fn rows(bench: &Bench) -> Result<Vec<Row>, Failure> {
    let places: [(&str, Place); 3] =
        [("beside a post", at_post), ("in the goal", in_goal), ("beside the goalkeeper", at_keeper)];
    places.into_iter().map(|(name, place)| row(bench, name, place)).collect()
}

fn row(bench: &Bench, name: &str, place: Place) -> Result<Row, Failure> {
    let runs = bench.each(|seed| Ok((seed, throw(bench, seed, place)?)))?;
    let up: Vec<Rising> = runs.iter().filter_map(|(_, rising)| *rising).collect();
    let times: Vec<f32> = up.iter().map(|rising| rising.time).collect();
    let tries: Vec<f32> = up.iter().map(|rising| f32::from(rising.tries)).collect();
    let most = |values: &[f32]| values.iter().copied().fold(0.0, f32::max);
    let (slowest, many) = (most(&times), most(&tries));
    let failed = runs.iter().filter(|(_, rising)| rising.is_none()).map(|(seed, _)| format!(" {seed}"));
    let failed: String = failed.collect();
    let failed = if failed.is_empty() { failed } else { format!("; not with seed{failed}") };
    let (time, usual) = (median(times), median(tries));
    let figures = format!("median {time:.1} s, slowest {slowest:.1} s; tries: median {usual}, most {many}{failed}");
    Ok(Row {
        name: name.into(),
        runs: runs.len(),
        good: up.len(),
        needed: bench.needed(19),
        figures,
        figures_hold: true,
    })
}

/// A way back to the feet.
#[derive(Clone, Copy)]
struct Rising {
    /// From the fall until it stood for good, s.
    time: f32,
    tries: u8,
}

/// None if it does not come to its feet for good in time, or cannot be thrown over.
fn throw(bench: &Bench, seed: u64, place: Place) -> Result<Option<Rising>, Failure> {
    let mut rng = Rng::new(seed);
    let setup = Setup { seed, ..Setup::default() };
    let robot = place(&mut rng, keeper(&setup, bench)?);
    let start = Some(Start { robot, ball: Vec2::new(-2.8, 1.8) });
    let mut subject = FallSubject::in_game(&Setup { start, ..setup }, &bench.physics, false)?;
    subject.live(1.0)?;
    for _ in 0..THROWS {
        subject.push(rng.between(THROW.0, THROW.1) * Vec2::from_angle(rng.between(-PI, PI)));
        subject.live(1.0)?;
        if subject.stood().is_some() {
            break;
        }
    }
    while subject.stood().is_some_and(|stood| stood.after <= TIME && stood.since < STANDS) {
        subject.live(0.5)?;
    }
    let good = subject.stood().filter(|stood| stood.after <= TIME);
    Ok(good.map(|stood| Rising { time: stood.after, tries: subject.tries }))
}

fn keeper(setup: &Setup, bench: &Bench) -> Result<Vec2, Failure> {
    let world = MujocoWorld::new(setup, &bench.physics)
        .map_err(|error| Failure::new(error.to_string(), "try another value"))?;
    Ok(world.referee().others().first().map_or(Vec2::ZERO, |keeper| keeper.position))
}

/// Before or beside a post.
fn at_post(rng: &mut Rng, _: Vec2) -> Pose2 {
    let at = FIELD.goal_post() + outward(rng, NEAR);
    either(at, rng)
}

/// Between the posts, beside the net.
fn in_goal(rng: &mut Rng, _: Vec2) -> Pose2 {
    let at = Vec2::new(
        rng.between(FIELD.goal_post().x, FIELD.goal_back() - NEAR.0),
        FIELD.goal_post().y - rng.between(NEAR.0, NEAR.1),
    );
    either(at, rng)
}

/// On any side of the goalkeeper but behind it, where the goal is, and not in a post.
fn at_keeper(rng: &mut Rng, keeper: Vec2) -> Pose2 {
    loop {
        let pose = Pose2 { position: keeper + outward(rng, NEAR_KEEPER), heading: rng.between(-PI, PI) };
        let at = Vec2::new(pose.position.x, pose.position.y.abs());
        if at.distance(FIELD.goal_post()) > NEAR.0 {
            return pose;
        }
    }
}

/// So far from something, and not nearer to the goal than that.
fn outward(rng: &mut Rng, near: (f32, f32)) -> Vec2 {
    rng.between(near.0, near.1) * Vec2::from_angle(rng.between(FRAC_PI_2, 3.0 * FRAC_PI_2))
}

/// There or at the other side of the goal, with any heading.
fn either(at: Vec2, rng: &mut Rng) -> Pose2 {
    let position = if rng.between(-1.0, 1.0) < 0.0 { Vec2::new(at.x, -at.y) } else { at };
    Pose2 { position, heading: rng.between(-PI, PI) }
}
