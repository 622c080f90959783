//! What transitions wait for: results of children, and transitions without a function.

use syn::Type;

use super::arguments::is_own;
use super::links::Links;
use super::model::{Component, Machine, Sources, Timer, Transition};
use crate::report::Report;
use crate::{text, wording};

/// Reports transitions on a state that do not leave it or wait for nothing, and results of what is no child of the state.
pub(super) fn check(component: &Component, machine: &Machine, report: &mut Report) {
    for transition in &component.transitions {
        if transition.arrow.guard.bare {
            on_its_state(transition, report);
        }
        if let Some(Timer::Parameter(timer)) = &transition.arrow.guard.timer
            && is_own(&timer.of.0, component.own())
        {
            report.add(&timer.of.0, wording::OWN_TIMER);
        }
        let when = transition.arrow.guard.when.iter().map(|when| &when.child.0);
        for child in when.chain(transition.function.outcomes().filter(|_| !transition.arrow.guard.bare)) {
            of_a_child(component, machine, transition, child, report);
        }
    }
}

/// Reports a transition on a state that leaves another one, or that waits for nothing.
fn on_its_state(transition: &Transition, report: &mut Report) {
    let state = text::name(&transition.function.name);
    match &transition.arrow.from {
        Sources::Any => report.add(&transition.attribute, wording::of_another_state(&state)),
        Sources::These(names) => {
            if let Some(other) = names.iter().find(|name| text::name(name) != state) {
                report.add(other, wording::of_another_state(&state));
            }
        }
    }
    if transition.arrow.guard.is_empty() {
        report.add(&transition.attribute, wording::WAITS_FOR_NOTHING);
    }
}

/// Reports the result of what no argument of a state names that the transition leaves.
fn of_a_child(component: &Component, machine: &Machine, transition: &Transition, child: &Type, report: &mut Report) {
    if is_own(child, component.own()) {
        return report.add(child, wording::OWN_RESULT);
    }
    let leaves = |name: &str| match &transition.arrow.from {
        Sources::Any => name != text::name(&transition.arrow.to),
        Sources::These(names) => names.iter().any(|one| text::name(one) == name),
    };
    let without = machine.states.iter().enumerate().find_map(|(index, state)| {
        let name = text::name(&state.body.name);
        let has = || Links::of_state(machine, index).iter().any(|(_, one)| last(one) == last(child));
        (leaves(&name) && !has()).then_some(name)
    });
    let is_role =
        |kind: &Type| matches!(kind, Type::ImplTrait(role) if Some(text::written(&role.bounds)) == last(child));
    if let Some(state) = without {
        if Links::of_state(machine, 0).iter().any(|(_, one)| is_role(one)) {
            return report.add(child, wording::role_result(&text::written(child)));
        }
        report.add(child, wording::no_child_in(&text::written(child), &state));
    }
}

/// The last name of a type's path.
fn last(kind: &Type) -> Option<String> {
    let Type::Path(path) = kind else { return None };
    path.path.segments.last().map(|last| text::name(&last.ident))
}
