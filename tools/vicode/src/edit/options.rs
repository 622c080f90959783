//! Options of components and defaults of parameters.

use super::context::{Context, list};
use super::fragment;
use super::request::Refusal;
use super::splice::Splice;
use crate::model::{Component, Options, Setting, Span};

/// Sets or removes an option.
pub(super) fn set(
    context: &Context<'_>,
    component: &str,
    option: &str,
    value: Option<&str>,
) -> Result<Vec<Splice>, Refusal> {
    let component = context.component(component)?;
    let known = ["hz", "budget_us", "resume", "writers"];
    if !known.contains(&option) {
        let known = list(known.into_iter());
        return Err(Refusal::new(format!("there is no option `{option}` here: there is {known}")));
    }
    if option != "resume"
        && let Some(value) = value
    {
        fragment::value(value, "an option")?;
    }
    let old = component.options.get(option);
    let new =
        value.map(|value| if option == "resume" { option.to_owned() } else { format!("{option} = {}", value.trim()) });
    match (old, new) {
        (None, None) => Ok(Vec::new()),
        (Some(old), Some(new)) => Ok(vec![Splice::keeping_comments(context.text, old.span, new)]),
        (None, Some(new)) => Ok(vec![added(context.text, component, &new)]),
        (Some(old), None) => Ok(vec![Splice::keeping_comments(context.text, removed(&component.options, old), "")]),
    }
}

fn added(text: &str, component: &Component, new: &str) -> Splice {
    let options = &component.options;
    match (options.settings.first(), options.list) {
        (Some(first), _) => Splice::insert(first.span.start, format!("{new}, ")),
        (None, Some(list)) => Splice::insert(list.start, new),
        (None, None) => {
            let attribute = options.span.of(text);
            let at = attribute.find("component").map_or(attribute.len(), |at| at + "component".len());
            Splice::insert(options.span.start + at, format!("({new})"))
        }
    }
}

/// Returns the span of an option with its comma; if it is the only option, the span of the parentheses.
fn removed(options: &Options, old: &Setting) -> Span {
    let index = options.settings.iter().position(|setting| setting == old).unwrap_or_default();
    let next = options.settings.get(index + 1);
    let before = index.checked_sub(1).map(|before| &options.settings[before]);
    match (next, before, options.list) {
        (Some(next), ..) => Span::new(old.span.start, next.span.start),
        (None, Some(before), _) => Span::new(before.span.end, old.span.end),
        (None, None, Some(list)) => Span::new(list.start - 1, list.end + 1),
        (None, None, None) => old.span,
    }
}

/// Sets the default of a parameter.
pub(super) fn default(context: &Context<'_>, group: &str, name: &str, value: &str) -> Result<Vec<Splice>, Refusal> {
    let group = context.model.group(group).ok_or_else(|| {
        let known = list(context.model.parameters.iter().map(|group| &*group.name.text));
        Refusal::new(format!("no struct `{group}` with `#[derive(Params)]` is in this file: there is {known}"))
    })?;
    let parameter = group.parameters.iter().find(|parameter| parameter.name.text == name).ok_or_else(|| {
        let known = list(group.parameters.iter().map(|parameter| &*parameter.name.text));
        Refusal::new(format!("`{}` has no parameter `{name}`: there is {known}", group.name.text))
    })?;
    fragment::value(value, "a default")?;
    match parameter.value("default") {
        Some(old) => Ok(vec![Splice::new(old.span, value.trim())]),
        None => Err(Refusal::at(parameter.name.span, format!("parameter `{name}` has no default yet: write one"))),
    }
}
