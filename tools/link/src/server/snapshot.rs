//! State of a tree after a cycle.

use bica::{ComponentId, Tree};
use bica_wire::message::{ComponentState, ComponentStates, CycleInfo, MAX_STATES};
use bica_wire::{ToMonitor, TooLarge};

use crate::frame::Packets;

/// State of a tree after a cycle.
#[derive(Debug)]
pub(super) struct Snapshot {
    info: CycleInfo,
    states: Vec<ComponentState>,
}

impl Snapshot {
    /// Reads a tree.
    pub(super) fn new<T: Tree>(info: CycleInfo, tree: &T) -> Self {
        let status = |index| tree.status(ComponentId::new(index));
        let states = (0..T::COUNT).filter_map(status).map(|status| ComponentState {
            active: status.active,
            held: status.held.into(),
            state: status.state.map(|state| state as u16),
            hz: status.hz,
        });
        Self { info, states: states.collect() }
    }

    /// Appends the packets of this snapshot.
    pub(super) fn encode(&self, packets: &mut Packets) -> Result<(), TooLarge> {
        packets.push(&ToMonitor::Cycle(self.info))?;
        for (part, states) in self.states.chunks(MAX_STATES).enumerate() {
            let first = (part * MAX_STATES) as u16;
            let states = states.iter().copied().collect();
            packets.push(&ToMonitor::Components(ComponentStates { cycle: self.info.cycle, first, states }))?;
        }
        Ok(())
    }
}
