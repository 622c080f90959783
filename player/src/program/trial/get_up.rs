//! Getting up: the forward is thrown over, and has to be on its feet again.

use bica::{Instant, Tree};
use bica_motion::pose::Pose2;
use bica_motion::profile::Profile;
use bica_player::input::Measured;
use bica_player::{Forward, act, sense};
use bica_sim::World;
use bica_sim::field::{Setup, Start};
use bica_sim::mujoco::MujocoWorld;
use bica_sim::referee::Event;
use glam::Vec2;

use super::bench::Bench;
use super::dice::Dice;
use super::table::{Row, median};
use crate::program::ending::Failure;

/// Time to get up, s.
const TIME: f32 = 15.0;
/// How fast the torso is thrown over, m/s.
const THROW: (f32, f32) = (2.0, 2.6);

/// From the front, from the back, and from both sides.
pub(crate) fn rows(bench: &Bench) -> Result<Vec<Row>, Failure> {
    // Nothing is asked for of the sides.
    let falls = [("front", Vec2::X, 19), ("back", Vec2::NEG_X, 19), ("left", Vec2::Y, 0), ("right", Vec2::NEG_Y, 0)];
    let row = |(name, way, wanted)| {
        let times = bench.each(|seed| throw(bench, seed, way))?;
        let up: Vec<f32> = times.iter().flatten().copied().collect();
        Ok(Row {
            name: format!("from the {name}"),
            runs: times.len(),
            good: up.len(),
            needed: bench.needed(wanted),
            figures: format!("median {:.1} s", median(up)),
            figures_hold: true,
        })
    };
    falls.into_iter().map(row).collect()
}

/// How long it took to be on its feet for good, s; none if it took too long, or if it did not even fall.
fn throw(bench: &Bench, seed: u64, way: Vec2) -> Result<Option<f32>, Failure> {
    let start = Some(Start { robot: Pose2::ORIGIN, ball: Vec2::new(-2.8, 1.8) });
    let setup = Setup { seed, goalkeeper: false, start, ..Setup::default() };
    let mut world = MujocoWorld::new(&setup, &bench.physics)
        .map_err(|error| Failure::new(error.to_string(), "try another value"))?;
    let mut robot = Box::new(Forward::new());
    robot.get_mut::<Measured>().be(&Profile::NAO);
    live(&mut world, &mut robot, 1.0)?;
    let speed = Dice::new(seed).between(THROW.0, THROW.1);
    world.push(speed * way);
    live(&mut world, &mut robot, TIME + 1.0)?;
    let when = |wanted: fn(&Event) -> bool| {
        let happened = world.referee().events().iter().find(|happened| wanted(&happened.event));
        happened.map(|happened| happened.at.as_secs_f32())
    };
    let fell = when(|event| matches!(event, Event::Fall(_)));
    let up = when(|event| *event == Event::GotUp);
    Ok(fell.zip(up).map(|(fell, up)| up - fell).filter(|time| *time <= TIME))
}

fn live(world: &mut MujocoWorld, robot: &mut Forward, seconds: f32) -> Result<(), Failure> {
    for _ in 0..super::walker::cycles(seconds) {
        let now = Instant::from_micros(world.now().as_micros() as u64);
        sense(robot, &world.sensors()).map_err(|error| Failure::new(error.to_string(), "choose a smaller image"))?;
        robot.tick(now);
        world.act(&act(robot));
    }
    Ok(())
}
