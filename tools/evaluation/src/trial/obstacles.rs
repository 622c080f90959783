//! Getting up beside obstacles: a goal post, the net of the goal, the goalkeeper.

use std::f32::consts::{FRAC_PI_2, PI};

use bica_app::Failure;
use bica_body::random::Random;
use bica_field::FIELD;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_sim::World;
use bica_sim::mujoco::MujocoWorld;
use bica_sim::setup::{Setup, Start};
use glam::Vec2;

use super::fall_subject::FallSubject;
use super::get_up::{GREATEST_PUSH, LEAST_PUSH};
use super::series::{Series, random};
use super::table::{Row, median};

/// Range of a distance from the centre of the robot, m: least and greatest.
type Range = (f32, f32);
/// Distance to a post or a net.
const POST_DISTANCE: Range = (0.2, 0.5);
/// Distance to the centre of the goalkeeper.
const KEEPER_DISTANCE: Range = (0.3, 0.5);
/// Maximum number of pushes: an obstacle may keep the robot from falling.
const MAX_PUSHES: usize = 5;
/// Time limit for standing for good, s.
const TIME_LIMIT: f32 = 45.0;
/// Time of standing that counts as "for good", s.
const STANDING_TIME: f32 = 3.0;

/// Function that draws the pose of the robot before the push; the vector is the position of the goalkeeper.
type Place = fn(&mut Random, Vec2) -> Pose2;

/// Runs pushes in random directions beside three kinds of obstacles.
pub(super) fn rows(series: &Series) -> Result<Vec<Row>, Failure> {
    let places: [(&str, Place); 3] =
        [("beside a post", at_post), ("in the goal", in_goal), ("beside the goalkeeper", at_keeper)];
    places.into_iter().map(|(name, place)| row(series, name, place)).collect()
}

fn row(series: &Series, name: &str, place: Place) -> Result<Row, Failure> {
    let runs = series.each(|seed| Ok((seed, push_over(series, seed, place)?)))?;
    let up: Vec<GetUp> = runs.iter().filter_map(|(_, get_up)| *get_up).collect();
    let times: Vec<f32> = up.iter().map(|get_up| get_up.time).collect();
    let attempts: Vec<f32> = up.iter().map(|get_up| f32::from(get_up.attempts)).collect();
    let most = |values: &[f32]| values.iter().copied().fold(0.0, f32::max);
    let (slowest, many) = (most(&times), most(&attempts));
    let failed = runs.iter().filter(|(_, get_up)| get_up.is_none()).map(|(seed, _)| format!(" {seed}"));
    let failed: String = failed.collect();
    let failed = if failed.is_empty() { failed } else { format!("; failed with seed{failed}") };
    let (time, usual) = (median(times), median(attempts));
    let figures = format!("median {time:.1} s, slowest {slowest:.1} s; attempts: median {usual}, most {many}{failed}");
    Ok(Row::new(name, runs.len(), up.len(), series.needed(19), figures))
}

/// A successful get-up.
#[derive(Clone, Copy)]
struct GetUp {
    /// Time from the fall until the robot stood for good, s.
    time: f32,
    attempts: u8,
}

/// Pushes the robot over; returns `None` if it does not stand for good in time, or cannot be pushed over.
fn push_over(series: &Series, seed: u64, place: Place) -> Result<Option<GetUp>, Failure> {
    let mut rng = random(seed);
    let setup = Setup { seed, ..Setup::default() };
    let robot = place(&mut rng, keeper(&setup, series)?);
    let start = Some(Start { robot, ball: Vec2::new(-2.8, 1.8) });
    let mut subject = FallSubject::in_game(&Setup { start, ..setup }, &series.physics, false)?;
    subject.run(1.0)?;
    for _ in 0..MAX_PUSHES {
        subject.push(rng.between(LEAST_PUSH, GREATEST_PUSH) * Vec2::from_angle(rng.between(-PI, PI)));
        subject.run(1.0)?;
        if subject.recovery().is_some() {
            break;
        }
    }
    while subject.recovery().is_some_and(|stood| stood.after <= TIME_LIMIT && stood.since < STANDING_TIME) {
        subject.run(0.5)?;
    }
    let good = subject.recovery().filter(|stood| stood.after <= TIME_LIMIT);
    Ok(good.map(|stood| GetUp { time: stood.after, attempts: subject.attempts }))
}

fn keeper(setup: &Setup, series: &Series) -> Result<Vec2, Failure> {
    let world = MujocoWorld::new(NAO, setup, &series.physics)
        .map_err(|error| Failure::new(error.to_string(), "try another value"))?;
    Ok(world.referee().others().first().map_or(Vec2::ZERO, |keeper| keeper.position))
}

/// Draws a pose in front of or beside a post.
fn at_post(rng: &mut Random, _: Vec2) -> Pose2 {
    let at = FIELD.goal_post() + outward(rng, POST_DISTANCE);
    either(at, rng)
}

/// Draws a pose between the posts, beside the net.
fn in_goal(rng: &mut Random, _: Vec2) -> Pose2 {
    let at = Vec2::new(
        rng.between(FIELD.goal_post().x, FIELD.goal_back() - POST_DISTANCE.0),
        FIELD.goal_post().y - rng.between(POST_DISTANCE.0, POST_DISTANCE.1),
    );
    either(at, rng)
}

/// Draws a pose on any side of the goalkeeper except behind it, where the goal is, and not in a post.
fn at_keeper(rng: &mut Random, keeper: Vec2) -> Pose2 {
    loop {
        let pose = Pose2 { position: keeper + outward(rng, KEEPER_DISTANCE), heading: rng.between(-PI, PI) };
        let at = Vec2::new(pose.position.x, pose.position.y.abs());
        if at.distance(FIELD.goal_post()) > POST_DISTANCE.0 {
            return pose;
        }
    }
}

/// Draws an offset away from the goal, with a length in this range.
fn outward(rng: &mut Random, distance: Range) -> Vec2 {
    rng.between(distance.0, distance.1) * Vec2::from_angle(rng.between(FRAC_PI_2, 3.0 * FRAC_PI_2))
}

/// Returns this position or its mirror image at the other post, with a random heading.
fn either(at: Vec2, rng: &mut Random) -> Pose2 {
    let position = if rng.between(-1.0, 1.0) < 0.0 { Vec2::new(at.x, -at.y) } else { at };
    Pose2 { position, heading: rng.between(-PI, PI) }
}
