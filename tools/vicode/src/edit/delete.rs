//! Deletion of functions.

use super::context::{Context, function};
use super::layout::{attribute_removal, entry_removal, removal};
use super::request::Refusal;
use super::splice::Splice;
use super::style::{line_number, line_start};
use super::target::{Target, Use};
use super::uses::of_each;
use crate::model::{Component, Function, Hook, Name, Sources, Span, Transition};

/// Deletes a function. A state is also removed from transitions and hooks; those that only that state needs are deleted.
pub(super) fn delete(context: &Context<'_>, component: &str, name: &str) -> Result<Vec<Splice>, Refusal> {
    let component = context.component(component)?;
    let mut gone = vec![function(component, name)?];
    let mut splices = Vec::new();
    if component.state(name).is_some() {
        for transition in &component.transitions {
            of_transition(context.text, transition, name, &mut gone, &mut splices);
        }
        let others = component.states.iter().filter(|state| state.function.name.text != name);
        let entering = others.flat_map(|state| &state.arrows).filter(|arrow| arrow.to.text == name);
        splices.extend(entering.map(|arrow| Splice::remove(attribute_removal(context.text, arrow.span))));
        for hook in &component.hooks {
            of_hook(context.text, hook, name, &mut gone, &mut splices);
        }
    }
    unused(context, component, &gone)?;
    splices.extend(gone.iter().map(|function| Splice::remove(removal(context.text, function))));
    Ok(splices)
}

/// Refuses to delete functions that others call.
fn unused(context: &Context<'_>, component: &Component, gone: &[&Function]) -> Result<(), Refusal> {
    let names: Vec<&str> = gone.iter().map(|function| &*function.name.text).collect();
    let target = Target::new(context.text, component, false);
    let uses = of_each(context.text, &target, &names, true).into_iter().filter(|(_, one)| one.certain);
    let is_outside =
        |place: Span| !gone.iter().any(|gone| gone.span.contains(place)) && !in_comment(context.text, place);
    if let Some((name, Use { span, .. })) = uses.into_iter().find(|(_, one)| is_outside(one.span)) {
        let line = line_number(context.text, span.start);
        return Err(Refusal::at(span, format!("`{name}` is used in line {line}: remove that use first")));
    }
    Ok(())
}

/// Returns whether a use is in a comment line; such a use does not prevent the deletion.
fn in_comment(text: &str, place: Span) -> bool {
    text[line_start(text, place.start)..place.start].trim_start().starts_with("//")
}

fn of_transition<'a>(
    text: &str,
    transition: &'a Transition,
    state: &str,
    gone: &mut Vec<&'a Function>,
    splices: &mut Vec<Splice>,
) {
    let mut kept = 0;
    let mut changes = Vec::new();
    for arrow in &transition.arrows {
        let enters = arrow.to.text == state;
        match &arrow.from {
            _ if enters => changes.push(Splice::remove(attribute_removal(text, arrow.span))),
            Sources::These(names) if names.iter().all(|name| name.text == state) => {
                changes.push(Splice::remove(attribute_removal(text, arrow.span)));
            }
            Sources::These(names) => {
                kept += 1;
                changes.extend(without(text, names, state));
            }
            Sources::Any => kept += 1,
        }
    }
    if kept == 0 && !transition.arrows.is_empty() {
        gone.push(&transition.function);
    } else {
        splices.extend(changes);
    }
}

fn of_hook<'a>(text: &str, hook: &'a Hook, state: &str, gone: &mut Vec<&'a Function>, splices: &mut Vec<Splice>) {
    if hook.states.is_empty() {
        return;
    }
    if hook.states.iter().all(|name| name.text == state) {
        gone.push(&hook.function);
    } else {
        splices.extend(without(text, &hook.states, state));
    }
}

/// Removes a name from `a | b | c`, of which another name remains.
fn without(text: &str, names: &[Name], state: &str) -> Vec<Splice> {
    let spans: Vec<Span> = names.iter().map(|name| name.span).collect();
    let removed = (0..names.len()).filter(|index| names[*index].text == state);
    removed.map(|index| Splice::keeping_comments(text, entry_removal(&spans, index), "")).collect()
}
