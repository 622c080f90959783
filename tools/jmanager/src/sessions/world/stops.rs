//! Observer of a world that looks for breakpoints in each cycle.

use std::sync::Arc;

use bica::{ComponentId, Tree as _};
use bica_console::Failure;
use bica_game::{GRAPH, GameObserver, Scene};

use super::Pacer;
use crate::sessions::breakpoints::Activity;

/// Observer of a world. Everything else that a session shows of it comes over its link.
pub(super) struct Stops {
    pacer: Arc<Pacer>,
    /// States of all components after the last cycle.
    states: Vec<Activity>,
}

impl Stops {
    pub(super) fn new(pacer: Arc<Pacer>) -> Self {
        Self { pacer, states: vec![(false, None); GRAPH.nodes.len()] }
    }
}

impl GameObserver for Stops {
    fn cycle(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        let time_us = (scene.t * 1e6).round() as u64;
        let each = (0..GRAPH.nodes.len()).map(ComponentId::new);
        let state = |id| (scene.robot.is_active_at(id), scene.robot.state(id).map(|state| state as u16));
        let before = std::mem::replace(&mut self.states, each.map(state).collect());
        let taken: Vec<_> = (0..GRAPH.nodes.len()).filter_map(|index| Some((index, scene.taken(index)?))).collect();
        self.pacer.cycle(time_us, &before, &self.states, taken);
        Ok(())
    }
}
