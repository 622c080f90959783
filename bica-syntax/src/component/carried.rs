//! What transitions carry to the states that they enter: each of them what its state takes.

use proc_macro2::Ident;
use syn::{FnArg, Type};

use super::arguments::only_type_of;
use super::found;
use super::model::{Component, Found, Function, Hook, Machine, Transition};
use crate::report::Report;
use crate::{text, wording};

/// Reports entry hooks and conditions that do not agree.
pub(super) fn check(component: &Component, machine: &Machine, report: &mut Report) {
    for (place, hook) in component.entries.iter().enumerate() {
        if let Some(found) = hook.function.found() {
            one_taker(&component.entries[..place], hook, found, report);
            initial(machine, hook, found, report);
        }
    }
    for transition in &component.transitions {
        agreed(component, machine, transition, report);
    }
}

/// Reports the second hook that takes what was found for one state.
fn one_taker(before: &[Hook], hook: &Hook, found: &Found, report: &mut Report) {
    let takes = |name: &Ident| {
        before.iter().find(|other| other.function.found().is_some() && other.states.iter().any(|one| is(one, name)))
    };
    if let Some((state, other)) = hook.states.iter().find_map(|name| Some((name, takes(name)?))) {
        let (other, state) = (text::name(&other.function.name), text::name(state));
        report.add(&found.written, wording::found_by_two(&other, &state));
    }
}

/// Reports `Found` in a hook of the initial state, which is also entered without a transition, and `Option<Found>` elsewhere.
fn initial(machine: &Machine, hook: &Hook, found: &Found, report: &mut Report) {
    let initial = &machine.states[machine.initial].body.name;
    let (is_initial, of) = (hook.states.iter().any(|name| is(name, initial)), text::written(&found.of));
    match (is_initial, found.optional) {
        (true, false) => report.add(&found.written, wording::found_initial(&text::name(initial), &of)),
        (false, true) => report.add(&found.written, wording::found_optional(&of)),
        (true, true) if machine.edges.iter().all(|edge| edge.to != machine.initial) => {
            report.add(&found.written, wording::found_never(&text::name(initial)));
        }
        _ => {}
    }
}

/// Reports a transition that carries nothing to a state that takes something, or the reverse.
fn agreed(component: &Component, machine: &Machine, transition: &Transition, report: &mut Report) {
    let Transition { function: condition, arrow, .. } = transition;
    let Some(state) = machine.states.iter().find(|state| is(&state.body.name, &arrow.to)) else { return };
    let (name, to) = (text::name(&condition.name), text::name(&arrow.to));
    let taker = state.entries.iter().find_map(|hook: &Function| Some((text::name(&hook.name), hook.found()?)));
    match (taker, &condition.carries) {
        (Some((hook, found)), None) if arrow.guard.bare => {
            report.add(&arrow.to, wording::bare_carries_nothing(&to, &hook, &text::written(&found.of)));
        }
        (Some((hook, found)), None) => {
            report.add(&arrow.to, wording::carries_nothing(&name, &to, &hook, &text::written(&found.of)));
        }
        // A wrong argument that was to take the value has its own message.
        (None, Some(of)) if !report.is_empty() && is_tried(component, of) => {}
        (None, Some(of)) => report.add(&arrow.to, wording::takes_nothing(&name, &to, &text::written(of))),
        _ => {}
    }
}

/// Whether a function has an argument that was meant to be what a transition found.
fn is_tried(component: &Component, of: &Type) -> bool {
    let of = text::written(of);
    let is_meant =
        |kind: &Type| found::is_found(kind) || text::written(only_type_of(kind, "Option").unwrap_or(kind)) == of;
    let mut functions = component.block.functions();
    functions
        .any(|one| one.signature.inputs.iter().any(|input| matches!(input, FnArg::Typed(one) if is_meant(&one.ty))))
}

fn is(one: &Ident, other: &Ident) -> bool {
    text::name(one) == text::name(other)
}
