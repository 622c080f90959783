//! The rules that one impl block can break.

use super::model::{Behaviour, Component, End, Machine};
use super::{carried, near_miss, resolve, results, work};
use crate::code::Code;
use crate::report::Report;
use crate::{text, wording};

/// The behaviour of the component; `None` if mistakes leave it open.
pub fn check(component: &Component, report: &mut Report) -> Option<Behaviour> {
    if component.incomplete {
        return None;
    }
    work::check(component, report);
    if component.states.is_empty() {
        no_machine(component, report);
        near_miss::check(component, report);
        return Some(Behaviour::Step(component.step.clone()));
    }
    if let Some(step) = &component.step {
        report.add(&step.name, wording::STEP_AND_STATES);
        return None;
    }
    let machine = resolve::machine(component, report)?;
    let all_reached = reachable(&machine, report);
    ends(component, &machine, all_reached, report);
    hooks_before(component, &machine, report);
    carried::check(component, &machine, report);
    results::check(component, &machine, report);
    Some(Behaviour::Machine(machine))
}

fn no_machine(component: &Component, report: &mut Report) {
    if let Some(resume) = &component.options.resume {
        report.add(resume, wording::RESUME_WITHOUT_STATES);
    }
    for transition in &component.transitions {
        report.add(&transition.attribute, wording::without_states("transition"));
    }
    let hooks = [("entry", &component.entries), ("exit", &component.exits), ("before", &component.hooks_before)];
    for (role, hook) in hooks.iter().flat_map(|(role, hooks)| hooks.iter().map(move |hook| (role, hook))) {
        report.add(&hook.attribute, wording::without_states(role));
    }
}

/// Reports the states that no transition reaches; whether there is none.
fn reachable(machine: &Machine, report: &mut Report) -> bool {
    let mut reached = vec![false; machine.states.len()];
    let mut open = vec![machine.initial];
    while let Some(state) = open.pop() {
        if !std::mem::replace(&mut reached[state], true) {
            open.extend(machine.edges_from(state).map(|edge| edge.to));
        }
    }
    for (state, _) in machine.states.iter().zip(&reached).filter(|(_, reached)| !**reached) {
        let name = &state.body.name;
        report.add_code(name, Code::Unreachable { state: text::name(name) });
    }
    !reached.contains(&false)
}

/// Reports states marked as ends that are left, and dead ends once all states are reached: one missing transition makes both.
fn ends(component: &Component, machine: &Machine, all_reached: bool, report: &mut Report) {
    for (index, state) in machine.states.iter().enumerate() {
        let name = || text::name(&state.body.name);
        match machine.edges_from(index).find(|edge| edge.from != edge.to) {
            None if !state.last && all_reached => report.add_code(&state.body.name, Code::DeadEnd { state: name() }),
            Some(edge) if state.last => {
                let transition = component.transitions.iter().find(|one| one.function.name == edge.condition.name);
                let word = state.end.map_or("last", End::word);
                report.add_code(transition.map(|one| &one.attribute), Code::LastButLeft { state: name(), word });
            }
            _ => {}
        }
    }
}

/// Reports functions that would run before transitions of a state that none leaves.
fn hooks_before(component: &Component, machine: &Machine, report: &mut Report) {
    for name in component.hooks_before.iter().flat_map(|hook| &hook.states) {
        let index = machine.states.iter().position(|state| text::name(&state.body.name) == text::name(name));
        if index.is_some_and(|index| machine.states[index].last && machine.edges_from(index).next().is_none()) {
            report.add(name, wording::before_of_last(&text::name(name)));
        }
    }
}
