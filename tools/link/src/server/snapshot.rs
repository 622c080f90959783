//! State of a tree after a cycle.

use bica::{ComponentId, Tree};
use bica_wire::message::{ComponentState, ComponentStates, CycleInfo, MAX_STATES};
use bica_wire::{ToMonitor, TooLarge};

/// State of a tree after a cycle, or nothing.
#[derive(Clone, Debug, Default)]
pub(super) struct Snapshot {
    info: CycleInfo,
    states: Vec<ComponentState>,
}

impl Snapshot {
    /// Removes the contents.
    pub(super) fn clear(&mut self) {
        self.states.clear();
    }

    /// Whether there is nothing: a tree has components.
    pub(super) const fn is_empty(&self) -> bool {
        self.states.is_empty()
    }

    /// Reads a tree.
    pub(super) fn read<T: Tree>(&mut self, info: CycleInfo, tree: &T) {
        self.info = info;
        let status = |index| tree.status(ComponentId::new(index));
        self.states.extend((0..T::COUNT).filter_map(status).map(|status| ComponentState {
            active: status.active,
            held: status.held,
            state: status.state.map(|state| state as u16),
            hz: status.hz,
        }));
    }

    /// Passes the messages of this snapshot on.
    pub(super) fn messages(
        &self,
        mut message: impl FnMut(&ToMonitor<'_>) -> Result<(), TooLarge>,
    ) -> Result<(), TooLarge> {
        if self.is_empty() {
            return Ok(());
        }
        message(&ToMonitor::Cycle(self.info))?;
        for (part, states) in self.states.chunks(MAX_STATES).enumerate() {
            let first = (part * MAX_STATES) as u16;
            let states = states.iter().copied().collect();
            message(&ToMonitor::Components(ComponentStates { cycle: self.info.cycle, first, states }))?;
        }
        Ok(())
    }
}
