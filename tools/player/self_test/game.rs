//! A game that is computed on the microcontroller and on the host.

use std::error::Error;
use std::path::{Path, PathBuf};

use bica::Tree;
use bica_motion::model::simulation::NAO;
use bica_player::Forward;
use bica_player_program::emulator::{Controller, Transport};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};
use bica_wire::message::StackUsage;

use crate::reference::Reference;

/// Time limit of a game, s of the world's clock.
const LIMIT_S: u64 = 120;

/// Result of a game.
pub(crate) struct Played {
    pub(crate) cycles: usize,
    pub(crate) goal_s: f64,
    pub(crate) stack: StackUsage,
    /// File with the encoded log.
    pub(crate) log: PathBuf,
    /// Instructions from sensing to acting in each cycle, ascending.
    pub(crate) chain: Vec<u64>,
    /// Name of each component and instructions of its runs, ascending.
    pub(crate) costs: Vec<(&'static str, Vec<u64>)>,
}

/// Plays a game with camera images of a size until the first goal.
pub(crate) fn play(image: &Path, seed: u64, frame: Frame) -> Result<Played, Box<dyn Error>> {
    let mut world = KinematicWorld::new(NAO, &Setup { seed, frame, ..Setup::default() })?;
    let mut reference = Reference::new(world.referee().attacks());
    let log = image.with_extension("log");
    let mut controller = Controller::start(image, Transport::Pipe, world.referee().attacks(), Some(&log))?;
    let (mut chain, mut costs) = (Vec::new(), vec![Vec::new(); Forward::COUNT]);
    while world.referee().goals() == 0 && world.now().as_secs() < LIMIT_S {
        let time_us = world.now().as_micros() as u64;
        let sensors = world.sensors();
        let report = reference.cycle_on_both(&mut controller, time_us, &sensors)?;
        chain.push(report.instructions);
        for (list, cost) in costs.iter_mut().zip(report.costs).filter(|(_, cost)| *cost > 0) {
            list.push(cost);
        }
        world.act(&report.command);
    }
    if world.referee().goals() == 0 {
        return Err(format!("no goal in {LIMIT_S} s").into());
    }
    chain.sort_unstable();
    for list in &mut costs {
        list.sort_unstable();
    }
    let names = Forward::GRAPH.nodes.iter().map(|node| node.name);
    Ok(Played {
        cycles: chain.len(),
        goal_s: world.now().as_secs_f64(),
        stack: controller.stack_usage()?,
        log,
        chain,
        costs: names.zip(costs).collect(),
    })
}
