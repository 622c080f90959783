//! Conditions of transitions, from the events of a tick.

use bica::{ComponentId, Graph, Instant};
use bica_wire::message::ConditionState;

use super::extras::Extra;

/// For each transition of each component: whether its condition held when it was evaluated last in the present state, and the
/// instant since which it has had this value. The transition that was taken last held when it was taken.
#[derive(Debug)]
pub(super) struct ConditionTable {
    components: Vec<Vec<Option<(bool, Instant)>>>,
    now: Instant,
    /// The transition whose condition held last; it is taken next.
    holding: usize,
}

impl ConditionTable {
    pub(super) fn new(graph: &Graph) -> Self {
        let components = graph.nodes.iter().map(|node| vec![None; node.transitions.len()]).collect();
        Self { components, now: Instant::MIN, holding: 0 }
    }

    pub(super) const fn begin(&mut self, now: Instant) {
        self.now = now;
    }

    /// The component became active.
    pub(super) fn forget(&mut self, component: ComponentId) {
        if let Some(conditions) = self.components.get_mut(component.index()) {
            conditions.fill(None);
        }
    }

    /// The component has taken the transition whose condition held last.
    pub(super) fn taken(&mut self, component: ComponentId) {
        self.forget(component);
        let conditions = self.components.get_mut(component.index());
        if let Some(condition) = conditions.and_then(|conditions| conditions.get_mut(self.holding)) {
            *condition = Some((true, self.now));
        }
    }

    pub(super) fn evaluated(&mut self, component: ComponentId, transition: usize, holds: bool) {
        if holds {
            self.holding = transition;
        }
        let conditions = self.components.get_mut(component.index());
        let Some(condition) = conditions.and_then(|conditions| conditions.get_mut(transition)) else { return };
        if condition.is_none_or(|(last, _)| last != holds) {
            *condition = Some((holds, self.now));
        }
    }

    /// Returns the conditions of a component, if it has transitions.
    pub(super) fn read(&self, component: u16, time_us: u64) -> Option<Extra> {
        let conditions = self.components.get(usize::from(component)).filter(|conditions| !conditions.is_empty())?;
        let state = |(holds, since): (bool, Instant)| ConditionState { holds, since_us: since.as_micros() };
        let values = conditions.iter().map(|condition| condition.map(state)).collect();
        Some(Extra::Conditions { time_us, component, values })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether each of two conditions holds, and since when, µs.
    fn known(table: &ConditionTable) -> [Option<(bool, u64)>; 2] {
        [0, 1].map(|transition| table.components[0][transition].map(|(holds, since)| (holds, since.as_micros())))
    }

    #[test]
    fn of_a_state_that_was_left_the_condition_of_the_taken_transition_is_kept() {
        let component = ComponentId::new(0);
        let mut table = ConditionTable { components: vec![vec![None; 2]], now: Instant::MIN, holding: 0 };
        table.begin(Instant::from_micros(10));
        table.evaluated(component, 0, false);
        assert_eq!(known(&table), [Some((false, 10)), None]);
        for time in [20, 30] {
            table.begin(Instant::from_micros(time));
            table.evaluated(component, 0, false);
            table.evaluated(component, 1, true);
            table.taken(component);
            assert_eq!(known(&table), [None, Some((true, time))]);
        }
        table.forget(component);
        assert_eq!(known(&table), [None; 2]);
    }
}
