//! A game that is thought twice.

use std::error::Error;
use std::path::{Path, PathBuf};

use bica::Tree;
use bica_emulator::{Carrier, Mind};
use bica_player::Forward;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};
use bica_wire::message::Stack;

use crate::twin::{Twin, attack};

/// Longest game in the world, s.
const LIMIT: u64 = 120;

/// What a game brought.
pub(crate) struct Played {
    pub(crate) cycles: usize,
    pub(crate) goal_s: f64,
    pub(crate) stack: Stack,
    /// The log, not decoded.
    pub(crate) log: PathBuf,
    /// Instructions from sensing to acting, in rising order.
    pub(crate) chain: Vec<u64>,
    /// Instructions of each component's runs, in rising order.
    pub(crate) costs: Vec<(&'static str, Vec<u64>)>,
}

/// Plays a game to its first goal.
pub(crate) fn play(image: &Path, seed: u64) -> Result<Played, Box<dyn Error>> {
    let mut world = KinematicWorld::new(&Setup { seed, frame: Frame::Small, ..Setup::default() })?;
    let mut twin = Twin::new(attack(&world));
    let log = image.with_extension("log");
    let mut mind = Mind::start(image, Carrier::Pipe, attack(&world), Some(&log))?;
    let (mut chain, mut costs) = (Vec::new(), vec![Vec::new(); Forward::COUNT]);
    while world.referee().goals() == 0 && world.now().as_secs() < LIMIT {
        let time_us = world.now().as_micros() as u64;
        let sensors = world.sensors();
        let thought = twin.think_with(&mut mind, time_us, &sensors)?;
        chain.push(thought.instructions);
        for (list, cost) in costs.iter_mut().zip(thought.costs).filter(|(_, cost)| *cost > 0) {
            list.push(cost);
        }
        world.act(&thought.command);
    }
    if world.referee().goals() == 0 {
        return Err(format!("no goal in {LIMIT} s").into());
    }
    chain.sort_unstable();
    for list in &mut costs {
        list.sort_unstable();
    }
    let names = Forward::GRAPH.nodes.iter().map(|node| node.name);
    Ok(Played {
        cycles: chain.len(),
        goal_s: world.now().as_secs_f64(),
        stack: mind.stack()?,
        log,
        chain,
        costs: names.zip(costs).collect(),
    })
}
