//! Conditions of transitions, from the events of a tick.

use bica::{ComponentId, Graph, Instant, Probe};
use bica_wire::message::ConditionState;

use super::extras::Extra;

/// For each transition of each component: whether its condition held at its last evaluation in the present state, and the instant
/// since which it has had this value. The condition of the transition that was taken last is true since the transition.
#[derive(Debug)]
pub(super) struct ConditionTable {
    components: Vec<Vec<Option<(bool, Instant)>>>,
    /// Instant of the last cycle.
    now: Instant,
    /// The transition whose condition held last; it is taken next.
    holding: usize,
}

impl ConditionTable {
    /// Creates a table without values.
    pub(super) fn new(graph: &Graph) -> Self {
        let components = graph.nodes.iter().map(|node| vec![None; node.transitions.len()]).collect();
        Self { components, now: Instant::MIN, holding: 0 }
    }

    /// Returns the conditions of a component, one for each transition.
    pub(super) fn of(&self, component: usize) -> &[Option<(bool, Instant)>] {
        self.components.get(component).map_or(&[], Vec::as_slice)
    }

    /// Returns the transition that a component has taken in the last cycle.
    pub(super) fn taken(&self, component: usize) -> Option<usize> {
        self.of(component).iter().position(|condition| *condition == Some((true, self.now)))
    }

    /// Returns the conditions of a component, if it has transitions.
    pub(super) fn read(&self, component: u16, time_us: u64) -> Option<Extra> {
        let conditions = Some(self.of(component.into())).filter(|conditions| !conditions.is_empty())?;
        let state = |(holds, since): (bool, Instant)| ConditionState { holds, since_us: since.as_micros() };
        let values = conditions.iter().map(|condition| condition.map(state)).collect();
        Some(Extra::Conditions { time_us, component, values })
    }
}

impl Probe for ConditionTable {
    fn cycle_begin(&mut self, now: Instant) {
        self.now = now;
    }

    fn start(&mut self, component: ComponentId) {
        self.components[component.index()].fill(None);
    }

    fn condition(&mut self, component: ComponentId, transition: usize, holds: bool) {
        if holds {
            self.holding = transition;
        }
        let condition = &mut self.components[component.index()][transition];
        if condition.is_none_or(|(last, _)| last != holds) {
            *condition = Some((holds, self.now));
        }
    }

    fn transition(&mut self, component: ComponentId, _from: usize, _to: usize) {
        let conditions = &mut self.components[component.index()];
        conditions.fill(None);
        conditions[self.holding] = Some((true, self.now));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns for each condition whether it holds, and since when, µs.
    fn known(table: &ConditionTable) -> Vec<Option<(bool, u64)>> {
        table.of(0).iter().map(|condition| condition.map(|(holds, since)| (holds, since.as_micros()))).collect()
    }

    #[test]
    fn condition_of_the_taken_transition_is_kept() {
        let component = ComponentId::new(0);
        let mut table = ConditionTable { components: vec![vec![None; 2]], now: Instant::MIN, holding: 0 };
        table.cycle_begin(Instant::from_micros(10));
        table.condition(component, 0, false);
        assert_eq!(known(&table), [Some((false, 10)), None]);
        for time in [20, 30] {
            table.cycle_begin(Instant::from_micros(time));
            table.condition(component, 0, false);
            table.condition(component, 1, true);
            table.transition(component, 0, 1);
            assert_eq!(known(&table), [None, Some((true, time))]);
        }
        table.start(component);
        assert_eq!(known(&table), [None; 2]);
    }
}
