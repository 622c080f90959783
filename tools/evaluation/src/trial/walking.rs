//! Trials of the walk: velocities, random commands, pushes, and variations of the body and the floor.

use std::f32::consts::{PI, TAU};

use bica_app::Failure;
use bica_body::random::Random;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::walk::Velocity;
use bica_sim::World;
use bica_sim::mujoco::Physics;
use glam::Vec2;

use super::course::{PushCase, VelocityCase};
use super::series::{Series, random};
use super::table::{Row, mean};
use super::walker::{Walker, cycles};

/// Time of acceleration before the measurement, s.
const START: f32 = 2.0;
/// Duration of the measurement, s.
const MEASUREMENT: f32 = 10.0;
/// Largest relative error of a velocity.
const MAX_ERROR: f32 = 0.15;
/// Largest velocity along an axis without a commanded velocity, m/s.
const MAX_DRIFT: f32 = 0.03;
/// Largest turn rate without a commanded turn, rad/s.
const MAX_TURN_DRIFT: f32 = 0.1;
/// Largest distance from the middle, along the field, at which a robot walks between the goals, m.
const BETWEEN_GOALS: f32 = 2.3;
/// Lateral position of a path that passes the goals, m.
const BESIDE_GOALS: f32 = 1.4;
/// Time between two commands or pushes, s.
const INTERVAL: f32 = 2.0;

/// Single and combined velocities.
pub(super) fn velocities(series: &Series) -> Result<Vec<Row>, Failure> {
    series.course.velocities.iter().map(|case| velocity_row(series, case)).collect()
}

fn velocity_row(series: &Series, case: &VelocityCase) -> Result<Row, Failure> {
    let VelocityCase { name, velocity: commanded, exact, needed } = *case;
    let way = Vec2::new(commanded.forward, commanded.left);
    let mut start = if commanded.turn == 0.0 { -0.5 * (START + MEASUREMENT) * way } else { Vec2::ZERO };
    if start.x.abs() > BETWEEN_GOALS {
        start.y = BESIDE_GOALS;
    }
    let start = Pose2 { position: start, heading: 0.0 };
    let reached = series.each(|seed| {
        let mut walker = Walker::new(series.model, seed, start, &series.physics)?;
        walker.go(commanded, START);
        let mut sum = Pose2::ORIGIN;
        for _ in 0..cycles(MEASUREMENT) {
            let before = walker.pose();
            walker.cycle(commanded);
            let step = before.inverse() * walker.pose();
            sum.position += step.position;
            sum.heading += step.heading;
        }
        let drift = (walker.pose().position - start.position).perp_dot(way.normalize_or_zero()).abs();
        let mean = Velocity::new(sum.position.x, sum.position.y, sum.heading);
        Ok((!walker.fell()).then(|| (scaled(mean, 1.0 / MEASUREMENT), drift)))
    })?;
    let stood: Vec<Velocity> = reached.iter().flatten().map(|run| run.0).collect();
    let good = stood.iter().filter(|reached| !exact || near(**reached, commanded)).count();
    let of = |part: fn(&Velocity) -> f32| mean(&stood.iter().map(part).collect::<Vec<_>>());
    let (forward, left, turn) = (of(|v| v.forward), of(|v| v.left), of(|v| v.turn));
    let (falls, drift) = (reached.len() - stood.len(), reached.iter().flatten().map(|run| run.1).fold(0.0, f32::max));
    let figures =
        format!("mean {forward:+.3} {left:+.3} m/s {turn:+.3} rad/s, off the line {drift:.2} m at most, falls {falls}");
    Ok(Row::new(name, reached.len(), good, series.needed(needed), figures))
}

fn scaled(velocity: Velocity, by: f32) -> Velocity {
    Velocity::new(by * velocity.forward, by * velocity.left, by * velocity.turn)
}

fn near(reached: Velocity, commanded: Velocity) -> bool {
    let near = |reached: f32, commanded: f32, drift: f32| {
        (reached - commanded).abs() <= if commanded == 0.0 { drift } else { MAX_ERROR * commanded.abs() }
    };
    near(reached.forward, commanded.forward, MAX_DRIFT)
        && near(reached.left, commanded.left, MAX_DRIFT)
        && near(reached.turn, commanded.turn, MAX_TURN_DRIFT)
}

/// Runs random commands that change every two seconds for one minute.
pub(super) fn commands(series: &Series) -> Result<Vec<Row>, Failure> {
    Ok(vec![commands_row(series, "random commands, 60 s", &series.physics, 19)?])
}

/// Runs random commands with variations of the body and the floor.
pub(super) fn bodies(series: &Series) -> Result<Vec<Row>, Failure> {
    let physics = series.physics;
    let bodies = [
        ("friction 0.5", Physics { friction: 0.5, ..physics }),
        ("friction 1.2", Physics { friction: 1.2, ..physics }),
        ("leg gains x 0.5", Physics { leg_gain: 0.5, ..physics }),
        ("leg gains x 2", Physics { leg_gain: 2.0, ..physics }),
        ("torque limit 3 Nm", Physics { torque_limit: 3.0, ..physics }),
        ("dead time 40 ms", Physics { dead_time: 0.04, ..physics }),
    ];
    bodies.iter().map(|(name, physics)| commands_row(series, name, physics, 18)).collect()
}

fn commands_row(series: &Series, name: &str, physics: &Physics, required: u32) -> Result<Row, Failure> {
    let runs = series.each(|seed| {
        let mut rng = random(seed);
        let mut walker = Walker::new(NAO, seed, Pose2::new(0.0, 0.0, rng.between(-PI, PI)), physics)?;
        for _ in 0..30 {
            walker.go(inward(&mut rng, walker.pose()), INTERVAL);
        }
        Ok(walker.fall())
    })?;
    Ok(fall_row(name, &runs, series.needed(required)))
}

/// Draws a random command. Far from the centre of the field, draws eight and returns the one that ends nearest to it.
fn inward(rng: &mut Random, pose: Pose2) -> Velocity {
    let mut any = || {
        let forward = rng.between(-0.1, 0.2);
        Velocity::new(forward, rng.between(-0.1, 0.1), rng.between(-0.6, 0.6))
    };
    let first = any();
    let others: Vec<Velocity> = (0..7).map(|_| any()).collect();
    if pose.position.length() < 1.2 {
        return first;
    }
    let left_over = |velocity: &Velocity| {
        let turned = Pose2 { heading: pose.heading + 0.5 * INTERVAL * velocity.turn, ..pose };
        turned.place(INTERVAL * Vec2::new(velocity.forward, velocity.left)).length()
    };
    others.into_iter().chain([first]).min_by(|a, b| left_over(a).total_cmp(&left_over(b))).unwrap_or(first)
}

/// Pushes in walking: one, or one every two seconds.
pub(super) fn pushes(series: &Series) -> Result<Vec<Row>, Failure> {
    let row = |case: &PushCase| {
        let runs = series.each(|seed| {
            let mut rng = random(seed);
            let ahead = Velocity::new(series.course.pushed_velocity, 0.0, 0.0);
            let start =
                Vec2::new(-0.5 * INTERVAL * (case.times + 1) as f32 * series.course.pushed_velocity, BESIDE_GOALS);
            let mut walker = Walker::new(series.model, seed, Pose2 { position: start, heading: 0.0 }, &series.physics)?;
            // The phase of the step in which the push comes is random.
            walker.go(ahead, rng.between(0.0, 1.0));
            for _ in 0..case.times {
                walker.go(ahead, INTERVAL);
                let direction = case.direction.map_or_else(|| rng.between(0.0, TAU), f32::to_radians);
                walker.world.add_velocity(case.speed * Vec2::from_angle(direction));
            }
            walker.go(ahead, INTERVAL);
            Ok(walker.fall())
        })?;
        Ok(fall_row(case.name, &runs, series.needed(case.needed)))
    };
    series.course.pushes.iter().map(row).collect()
}

fn fall_row(name: &str, falls: &[Option<f32>], needed: usize) -> Row {
    let times: Vec<f32> = falls.iter().flatten().copied().collect();
    let figures = if times.is_empty() {
        "no fall".to_owned()
    } else {
        let times: Vec<String> = times.iter().map(|time| format!("{time:.0}")).collect();
        format!("falls after {} s", times.join(" "))
    };
    let good = falls.iter().filter(|fall| fall.is_none()).count();
    Row::new(name, falls.len(), good, needed, figures)
}
