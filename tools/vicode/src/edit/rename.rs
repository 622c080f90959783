//! Renaming of functions.

use super::context::{Context, function};
use super::fragment;
use super::machine::written;
use super::request::Refusal;
use super::splice::Splice;
use super::style::line_number;
use super::target::Target;
use super::uses::uses;
use crate::model::{Component, Name, Sources, Span};
use crate::read::functions_of;

/// Renames a function, the attributes that name it, and its uses.
pub(super) fn rename(context: &Context<'_>, component: &str, from: &str, to: &str) -> Result<Vec<Splice>, Refusal> {
    let component = context.component(component)?;
    let renamed = function(component, from)?;
    if from == to {
        return Ok(Vec::new());
    }
    fragment::name(to)?;
    if component.step.as_ref().is_some_and(|step| step.name.text == from) {
        return Err(Refusal::at(renamed.name.span, "the tree calls `step` by its name: it cannot be renamed"));
    }
    free(context, component, to)?;
    let all = functions_of(context.text, component).into_iter().filter(|one| one.text == from);
    let definitions: Vec<Span> = all.map(|one| one.span).collect();
    if definitions.len() > 1 {
        let lines = lines(context.text, &definitions);
        let message = format!("`{from}` has several definitions, in {lines}: rename them in the code");
        return Err(Refusal::at(renamed.name.span, message));
    }
    let mut places = vec![renamed.name.span];
    if component.state(from).is_some() {
        places.extend(state_names(component).filter(|name| name.text == from).map(|name| name.span));
    }
    let uses = uses(context.text, &Target::new(context.text, component, false), from, true);
    let undecided: Vec<Span> = uses.iter().filter(|one| !one.certain).map(|one| one.span).collect();
    if let Some(first) = undecided.first() {
        let (of, lines) = (&component.name.text, lines(context.text, &undecided));
        let advice = format!("name the type of the value, as in `{of}::{from}(&value)`");
        let message = format!("{lines} may use `{of}::{from}`, which this file does not decide: {advice}");
        return Err(Refusal::at(*first, message));
    }
    places.extend(uses.into_iter().map(|one| one.span));
    places.sort();
    places.dedup();
    Ok(places.into_iter().map(|place| Splice::new(place, written(to))).collect())
}

/// `line 3` or `lines 3, 5`
fn lines(text: &str, places: &[Span]) -> String {
    let mut lines: Vec<String> = places.iter().map(|place| line_number(text, place.start).to_string()).collect();
    lines.dedup();
    format!("{} {}", if lines.len() == 1 { "line" } else { "lines" }, lines.join(", "))
}

/// Returns the names of states in attributes.
pub(super) fn state_names(component: &Component) -> impl Iterator<Item = &Name> {
    let of_arrows = component.arrows().flat_map(|(.., arrow)| {
        let from: &[Name] = if let Sources::These(names) = &arrow.from { names } else { &[] };
        from.iter().chain([&arrow.to])
    });
    of_arrows.chain(component.hooks.iter().flat_map(|hook| &hook.states))
}

/// Refuses a name that the component uses already.
pub(super) fn free(context: &Context<'_>, component: &Component, name: &str) -> Result<(), Refusal> {
    let of_type = |other: &&Component| (&other.module, &other.name.text) == (&component.module, &component.name.text);
    let blocks = context.model.components.iter().filter(of_type);
    let functions = blocks.clone().flat_map(|block| block.functions().map(|function| &function.name));
    let taken = functions.chain(blocks.flat_map(|block| &block.names)).find(|taken| taken.text == name);
    let elsewhere = || functions_of(context.text, component).into_iter().find(|one| one.text == name);
    match taken.cloned().or_else(elsewhere) {
        Some(taken) => Err(Refusal::at(
            taken.span,
            format!("`{}` has a function `{name}` already: choose another name", component.name.text),
        )),
        None => Ok(()),
    }
}
