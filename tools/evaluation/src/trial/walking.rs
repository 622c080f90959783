//! Walking: velocities, changing commands, pushes, and bodies and floors that differ.

use std::f32::consts::{PI, TAU};

use bica_motion::pose::Pose2;
use bica_motion::walk::Velocity;
use bica_sim::mujoco::Physics;
use glam::Vec2;

use super::bench::Bench;
use super::rng::Rng;
use super::table::{Row, mean};
use super::walker::{Walker, cycles};
use bica_console::Failure;

/// Time to come to a velocity before it is measured, s.
const START: f32 = 2.0;
/// How long a velocity is measured, s.
const MEASURED: f32 = 10.0;
/// How far from what was asked for a velocity may be: a share of it.
const OFF: f32 = 0.15;
/// A part of a velocity that was not asked for may reach this, m/s or rad/s.
const DRIFT: (f32, f32) = (0.03, 0.1);
/// From command to command, and from push to push, s.
const EVERY: f32 = 2.0;

/// Every velocity by itself and mixed.
pub fn velocities(bench: &Bench) -> Result<Vec<Row>, Failure> {
    let asked = [
        ("forward 0.2 m/s", Velocity::new(0.2, 0.0, 0.0)),
        ("backward 0.1 m/s", Velocity::new(-0.1, 0.0, 0.0)),
        ("left 0.1 m/s", Velocity::new(0.0, 0.1, 0.0)),
        ("right 0.1 m/s", Velocity::new(0.0, -0.1, 0.0)),
        ("left turn 0.6 rad/s", Velocity::new(0.0, 0.0, 0.6)),
        ("right turn 0.6 rad/s", Velocity::new(0.0, 0.0, -0.6)),
        ("forward and left", Velocity::new(0.12, 0.05, 0.0)),
        ("forward, right turn", Velocity::new(0.12, 0.0, -0.3)),
        ("backward, left turn", Velocity::new(-0.06, 0.0, 0.3)),
        ("all three", Velocity::new(0.1, 0.03, 0.2)),
    ];
    let mut rows = Vec::new();
    for (name, velocity) in asked {
        rows.push(velocity_row(bench, name, velocity, true)?);
    }
    rows.push(velocity_row(bench, "forward 0.3 m/s", Velocity::new(0.3, 0.0, 0.0), false)?);
    Ok(rows)
}

fn velocity_row(bench: &Bench, name: &str, asked: Velocity, exact: bool) -> Result<Row, Failure> {
    let way = Vec2::new(asked.forward, asked.left);
    let start = if asked.turn == 0.0 { -0.5 * (START + MEASURED) * way } else { Vec2::ZERO };
    let start = Pose2 { position: start, heading: 0.0 };
    let reached = bench.each(|seed| {
        let mut walker = Walker::new(seed, start, &bench.physics)?;
        walker.go(asked, START);
        let mut sum = Pose2::ORIGIN;
        for _ in 0..cycles(MEASURED) {
            let before = walker.pose();
            walker.cycle(asked);
            let step = before.inverse() * walker.pose();
            sum.position += step.position;
            sum.heading += step.heading;
        }
        let mean = Velocity::new(sum.position.x, sum.position.y, sum.heading);
        Ok((!walker.fell()).then(|| scaled(mean, 1.0 / MEASURED)))
    })?;
    let stood: Vec<Velocity> = reached.iter().flatten().copied().collect();
    let good = stood.iter().filter(|reached| !exact || near(**reached, asked)).count();
    let of = |part: fn(&Velocity) -> f32| mean(&stood.iter().map(part).collect::<Vec<_>>());
    let (forward, left, turn) = (of(|v| v.forward), of(|v| v.left), of(|v| v.turn));
    let falls = reached.len() - stood.len();
    Ok(Row {
        name: name.to_owned(),
        runs: reached.len(),
        good,
        needed: bench.needed(if exact { 20 } else { 18 }),
        figures: format!("mean {forward:+.3} {left:+.3} m/s {turn:+.3} rad/s, falls {falls}"),
        figures_hold: true,
    })
}

fn scaled(velocity: Velocity, by: f32) -> Velocity {
    Velocity::new(by * velocity.forward, by * velocity.left, by * velocity.turn)
}

fn near(reached: Velocity, asked: Velocity) -> bool {
    let near = |reached: f32, asked: f32, drift: f32| {
        (reached - asked).abs() <= if asked == 0.0 { drift } else { OFF * asked.abs() }
    };
    near(reached.forward, asked.forward, DRIFT.0)
        && near(reached.left, asked.left, DRIFT.0)
        && near(reached.turn, asked.turn, DRIFT.1)
}

/// Commands by chance, changed every two seconds for a minute.
pub fn commands(bench: &Bench) -> Result<Vec<Row>, Failure> {
    Ok(vec![commands_row(bench, "commands by chance, 60 s", &bench.physics, 19)?])
}

/// Commands by chance with bodies and floors that differ.
pub fn bodies(bench: &Bench) -> Result<Vec<Row>, Failure> {
    let physics = bench.physics;
    let bodies = [
        ("friction 0.5", Physics { friction: 0.5, ..physics }),
        ("friction 1.2", Physics { friction: 1.2, ..physics }),
        ("leg gains x 0.5", Physics { leg_gain: 0.5, ..physics }),
        ("leg gains x 2", Physics { leg_gain: 2.0, ..physics }),
        ("torque limit 3 Nm", Physics { torque_limit: 3.0, ..physics }),
        ("dead time 40 ms", Physics { dead_time: 0.04, ..physics }),
    ];
    bodies.iter().map(|(name, physics)| commands_row(bench, name, physics, 18)).collect()
}

fn commands_row(bench: &Bench, name: &str, physics: &Physics, wanted: u64) -> Result<Row, Failure> {
    let runs = bench.each(|seed| {
        let mut rng = Rng::new(seed);
        let mut walker = Walker::new(seed, Pose2::new(0.0, 0.0, rng.between(-PI, PI)), physics)?;
        for _ in 0..30 {
            walker.go(inward(&mut rng, walker.pose()), EVERY);
        }
        Ok(walker.fall())
    })?;
    Ok(fall_row(name, &runs, bench.needed(wanted)))
}

/// A command by chance: one of some that leads farthest to the middle, once the robot is far from there.
fn inward(rng: &mut Rng, pose: Pose2) -> Velocity {
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
        let turned = Pose2 { heading: pose.heading + 0.5 * EVERY * velocity.turn, ..pose };
        turned.place(EVERY * Vec2::new(velocity.forward, velocity.left)).length()
    };
    others.into_iter().chain([first]).min_by(|a, b| left_over(a).total_cmp(&left_over(b))).unwrap_or(first)
}

/// Pushes from sides by chance, every two seconds for twenty, while walking.
pub fn pushes(bench: &Bench) -> Result<Vec<Row>, Failure> {
    let row = |(name, speed, wanted)| {
        let runs = bench.each(|seed| {
            let mut rng = Rng::new(seed);
            let mut walker = Walker::new(seed, Pose2::new(-1.0, 0.0, 0.0), &bench.physics)?;
            for _ in 0..10 {
                walker.go(Velocity::new(0.1, 0.0, 0.0), EVERY);
                walker.world.push(speed * Vec2::from_angle(rng.between(0.0, TAU)));
            }
            walker.go(Velocity::new(0.1, 0.0, 0.0), EVERY);
            Ok(walker.fall())
        })?;
        Ok(fall_row(name, &runs, bench.needed(wanted)))
    };
    // The last one is not asked for; it tells how far it is from falling.
    [("pushes of 0.4 m/s, 20 s", 0.4, 19), ("pushes of 0.6 m/s, 20 s", 0.6, 0)].into_iter().map(row).collect()
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
    Row { name: name.to_owned(), runs: falls.len(), good, needed, figures, figures_hold: true }
}
