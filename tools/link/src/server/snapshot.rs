//! State of a tree after a cycle.

use bica_wire::message::{ComponentState, ComponentStates, CycleInfo, MAX_STATES};
use bica_wire::{ToMonitor, TooLarge};

use super::view::View;

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

    /// Returns whether there is nothing: a tree has components.
    pub(super) const fn is_empty(&self) -> bool {
        self.states.is_empty()
    }

    /// Reads a tree.
    pub(super) fn read(&mut self, info: CycleInfo, tree: &impl View) {
        self.info = info;
        self.states.extend((0..tree.graph().nodes.len()).filter_map(|index| tree.component_state(index)));
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
