//! Breakpoints, resolved in a tree.

use bica_link::{Component, Description};
use bica_wire::message::{Stop, StopAt};

use super::history::{Change, History, States};
use super::value::unknown;
use crate::protocol::{Breakpoint, ComponentNow, Failed, Reached};

/// Whether a component is active, and its state.
pub(super) type Activity = (bool, Option<u16>);

/// A breakpoint that is resolved in the tree of its session.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BreakpointTarget {
    pub(super) breakpoint: Breakpoint,
    reach: Reach,
    /// Event at the breakpoint, as text for people.
    pub(super) text: String,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Reach {
    State(u16),
    /// From one state to another.
    Transition(u16, u16),
}

impl BreakpointTarget {
    /// Resolves a breakpoint in a tree. `is_exact` states whether the session shows which transition is taken, not only the states.
    pub(super) fn find(breakpoint: Breakpoint, description: &Description, is_exact: bool) -> Result<Self, Failed> {
        let Breakpoint { component, state, transition } = breakpoint;
        let owner = description.components.get(component).ok_or_else(|| unknown("component", component))?;
        let (reach, text) = match (state, transition) {
            (Some(state), None) => {
                let found = owner.states.get(state).ok_or_else(|| unknown("state", state))?;
                (Reach::State(state as u16), format!("`{}` is in `{}`", owner.name, found.name))
            }
            (None, Some(transition)) => {
                let found = owner.transitions.get(transition).ok_or_else(|| unknown("transition", transition))?;
                if found.from == found.to && !is_exact {
                    let what =
                        format!("`{}` leads from a state to itself, and this session shows states only", found.name);
                    return Err(Failed::new(what, "set the breakpoint on another transition or a state"));
                }
                let text = format!("`{}` has taken `{}`", owner.name, found.name);
                (Reach::Transition(found.from as u16, found.to as u16), text)
            }
            _ => {
                let help = "name either a state or a transition";
                return Err(Failed::new("a breakpoint has one of both, a state or a transition", help));
            }
        };
        Ok(Self { breakpoint, reach, text })
    }

    #[cfg(test)]
    pub(super) const fn at(breakpoint: Breakpoint) -> Self {
        Self { breakpoint, reach: Reach::State(0), text: String::new() }
    }

    /// Returns the stop of the link at this breakpoint.
    pub(super) const fn stop(&self, pauses: bool) -> Stop {
        let Breakpoint { component, state, transition } = self.breakpoint;
        let at = match (state, transition) {
            (Some(state), _) => StopAt::State(state as u16),
            (None, Some(transition)) => StopAt::Transition(transition as u16),
            (None, None) => StopAt::State(u16::MAX),
        };
        Stop { component: component as u16, at, pauses }
    }

    /// Returns whether a change of the component in a cycle reaches the breakpoint, judged by states only.
    pub(super) fn is_reached(&self, before: Activity, now: Activity) -> bool {
        match self.reach {
            Reach::State(state) => now == (true, Some(state)) && before != now,
            Reach::Transition(from, to) => before == (true, Some(from)) && now == (true, Some(to)),
        }
    }
}

/// Resolves the same targets in another tree, by names; targets that it does not have are left out.
pub(super) fn moved(
    targets: &[BreakpointTarget],
    from: &Description,
    to: &Description,
    is_exact: bool,
) -> Vec<BreakpointTarget> {
    let moved = |target: &BreakpointTarget| {
        let Breakpoint { component, state, transition } = target.breakpoint;
        let owner = from.components.get(component)?;
        let component = to.components.iter().position(|one| one.name == owner.name)?;
        let new = &to.components[component];
        let name = |of: &Component, state: usize| of.states.get(state).map(|state| state.name.clone());
        let ways = |of: &Component| -> Vec<_> {
            of.transitions.iter().map(|one| (one.name.clone(), name(of, one.from), name(of, one.to))).collect()
        };
        let same_state = |state| new.states.iter().position(|one| Some(&one.name) == name(owner, state).as_ref());
        let same_way = |transition: usize| ways(new).iter().position(|way| Some(way) == ways(owner).get(transition));
        let breakpoint =
            Breakpoint { component, state: state.and_then(same_state), transition: transition.and_then(same_way) };
        BreakpointTarget::find(breakpoint, to, is_exact).ok()
    };
    targets.iter().filter_map(moved).collect()
}

/// Returns the breakpoints that are reached in a cycle, judged by states only. `before` has the states of all components before the cycle.
pub(super) fn reached(targets: &[BreakpointTarget], before: &[Activity], changed: &[Change]) -> Vec<Breakpoint> {
    let is_reached = |target: &&BreakpointTarget| {
        let change = changed.iter().find(|change| usize::from(change.component) == target.breakpoint.component);
        let both = change.and_then(|change| Some((*before.get(usize::from(change.component))?, change.now)));
        both.is_some_and(|(before, now)| target.is_reached(before, now.activity()))
    };
    targets.iter().filter(is_reached).map(|target| target.breakpoint).collect()
}

/// Finds the first time after `from_us`, µs, at which a target is reached.
pub(super) fn next(history: &History, targets: &[BreakpointTarget], from_us: u64, is_exact: bool) -> Option<Reached> {
    let (taken, seen): (Vec<_>, Vec<_>) =
        targets.iter().partition(|target| is_exact && target.breakpoint.transition.is_some());
    let mut later = history.taken.between(from_us.saturating_add(1), u64::MAX);
    let by_transition = later.find_map(|&(time_us, (component, transition))| {
        let breakpoint = Breakpoint { component, state: None, transition: Some(transition) };
        taken.iter().any(|target| target.breakpoint == breakpoint).then_some(Reached { time_us, breakpoint })
    });
    let by_state = next_seen(&history.states, &seen, from_us);
    by_state.into_iter().chain(by_transition).min_by_key(|reached| reached.time_us)
}

/// Finds the first such time, judged by states only.
fn next_seen(states: &States, targets: &[&BreakpointTarget], from_us: u64) -> Option<Reached> {
    let mut all: Vec<Activity> = states.base().iter().map(ComponentNow::activity).collect();
    for change in states.changes().filter(|change| change.visible) {
        let component = usize::from(change.component);
        let now = change.now.activity();
        let before = std::mem::replace(all.get_mut(component)?, now);
        let mut here = targets.iter().filter(|target| target.breakpoint.component == component);
        if change.time_us > from_us
            && let Some(target) = here.find(|target| target.is_reached(before, now))
        {
            return Some(Reached { time_us: change.time_us, breakpoint: target.breakpoint });
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use bica_link::{State, Transition};

    use super::super::history::free;
    use super::*;
    use crate::sessions::history::Limits;

    fn target(reach: Reach) -> BreakpointTarget {
        BreakpointTarget {
            breakpoint: Breakpoint { component: 0, state: None, transition: None },
            reach,
            text: String::new(),
        }
    }

    #[test]
    fn a_place_is_reached_once_when_it_is_entered() {
        let state = target(Reach::State(1));
        assert!(state.is_reached((true, Some(0)), (true, Some(1))));
        assert!(state.is_reached((false, Some(1)), (true, Some(1))));
        assert!(!state.is_reached((true, Some(1)), (true, Some(1))));
        assert!(!state.is_reached((true, Some(1)), (false, Some(1))));
        let transition = target(Reach::Transition(0, 1));
        assert!(transition.is_reached((true, Some(0)), (true, Some(1))));
        assert!(!transition.is_reached((false, Some(0)), (true, Some(1))));
        assert!(!transition.is_reached((true, Some(2)), (true, Some(1))));
    }

    #[test]
    fn breakpoints_move_to_the_same_names_in_another_tree() {
        let tree = |states: &[&str], ways: &[(&str, usize, usize)]| {
            let doc = String::new;
            let state = |name: &&str| State {
                name: (*name).to_owned(),
                doc: doc(),
                initial: false,
                last: false,
                end: None,
                before: None,
            };
            let way = |&(name, from, to): &(&str, usize, usize)| {
                let name = name.to_owned();
                Transition {
                    name,
                    doc: doc(),
                    from,
                    to,
                    after_ms: None,
                    after: None,
                    when: None,
                    times: None,
                    carries: None,
                }
            };
            let (states, transitions) = (states.iter().map(state).collect(), ways.iter().map(way).collect());
            let lamp = Component { name: "Lamp".to_owned(), states, transitions, ..Component::default() };
            Description { components: vec![Component::default(), lamp], ..Description::default() }
        };
        let before = tree(&["on", "off"], &[("tick", 0, 1), ("tick", 1, 0), ("lit", 1, 0)]);
        let after = tree(&["new", "off", "on"], &[("tick", 1, 2), ("tick", 2, 1)]);
        let target = |state, transition| {
            BreakpointTarget::find(Breakpoint { component: 1, state, transition }, &before, true).unwrap()
        };
        let targets = [target(Some(0), None), target(None, Some(0)), target(None, Some(1)), target(None, Some(2))];
        let found = moved(&targets, &before, &after, true);
        let found: Vec<_> =
            found.iter().map(|target| (target.breakpoint.state, target.breakpoint.transition)).collect();
        assert_eq!(found, [(Some(2), None), (None, Some(1)), (None, Some(0))]);
    }

    #[test]
    fn the_next_time_is_found_after_the_cursor() {
        let mut states = States::new(1);
        for (time, state) in [(0, 0), (10, 1), (20, 0), (30, 1), (40, 1)] {
            states.push(time, time / 10, std::iter::once(free(true, Some(state))));
        }
        let at = |from_us| next_seen(&states, &[&target(Reach::State(1))], from_us).map(|reached| reached.time_us);
        assert_eq!([at(0), at(9), at(10), at(29), at(30)], [Some(10), Some(10), Some(30), Some(30), None]);
    }

    #[test]
    fn the_next_transition_is_the_one_that_was_taken() {
        let limits = Limits { ring_us: None, output_bytes: 0, image_bytes: 0 };
        let mut history = History::new(limits, 1);
        for (time, transition) in [(10, 1), (20, 2), (30, 1)] {
            history.taken.push(time, (0, transition));
        }
        let target = BreakpointTarget::at(Breakpoint { component: 0, state: None, transition: Some(1) });
        let at = |from_us| next(&history, std::slice::from_ref(&target), from_us, true).map(|reached| reached.time_us);
        assert_eq!([at(0), at(10), at(29), at(30)], [Some(10), Some(30), Some(30), None]);
    }
}
