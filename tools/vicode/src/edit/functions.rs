//! Adding, copying and moving of functions, and their bodies.

use super::context::{Context, function, state};
use super::request::{Edit, Refusal};
use super::splice::{Splice, applied};
use super::style::Style;
use super::{fragment, layout, machine, rename};
use crate::model::{Component, Function};

/// Adds a state, a transition, a hook, or code.
pub(super) fn add(context: &Context<'_>, edit: &Edit) -> Result<Vec<Splice>, Refusal> {
    match edit {
        Edit::AddState { component, name, docs, initial, last, body, after } => {
            let component = context.component(component)?;
            let words = [(*initial, "initial"), (*last, "last")];
            let words: Vec<&str> = words.into_iter().filter(|(on, _)| *on).map(|(_, word)| word).collect();
            let list = if words.is_empty() { String::new() } else { format!("({})", words.join(", ")) };
            let head = (format!("#[state{list}]"), format!("fn {name}(&mut self)"));
            let mut splices = new(context, component, name, docs, head, body, behind(component, after.as_deref(), 0)?)?;
            if *initial {
                splices.extend(machine::no_longer_initial(context.text, component));
            }
            Ok(splices)
        }
        Edit::AddTransition { component, name, from, to, after_ms, body, docs, after } => {
            let component = context.component(component)?;
            let list = machine::arrow(component, from, to, *after_ms)?;
            let takes = component.takes(to);
            let body = match (body.trim().is_empty(), takes, after_ms) {
                (true, Some(_), _) => "None",
                (true, None, Some(_)) => "true",
                (true, None, None) => "false",
                _ => body,
            };
            let returns = takes.map_or_else(|| "bool".to_owned(), |of| format!("Option<{of}>"));
            let head = (format!("#[transition({list})]"), format!("fn {name}(&self) -> {returns}"));
            new(context, component, name, docs, head, body, behind(component, after.as_deref(), 1)?)
        }
        Edit::AddHook { component, name, role, states, body, docs, after } => {
            let component = context.component(component)?;
            let word = role.word();
            let of_states = role.is_of_states();
            if of_states == states.is_empty() {
                let needs = if of_states { "needs at least one state" } else { "has no states" };
                return Err(Refusal::new(format!("`#[{word}]` {needs}")));
            }
            states.iter().try_for_each(|one| state(component, one))?;
            let list = if of_states { format!("({})", machine::names(states)) } else { String::new() };
            let head = (format!("#[{word}{list}]"), format!("fn {name}(&mut self)"));
            new(context, component, name, docs, head, body, behind(component, after.as_deref(), 2)?)
        }
        Edit::InsertCode { component, code, after } => {
            let component = context.component(component)?;
            for name in fragment::functions(code)? {
                rename::free(context, component, &name)?;
            }
            let style = context.style(component);
            let code = style.lay(code.trim_matches(['\n', '\r']).trim_end(), &style.indent);
            let after = behind(component, after.as_deref(), 3)?;
            Ok(vec![layout::insert(context.text, component, &style, after, &code)?])
        }
        _ => Ok(Vec::new()),
    }
}

/// Adds a function from its parts: attribute and signature.
fn new(
    context: &Context<'_>,
    component: &Component,
    name: &str,
    docs: &str,
    (attribute, signature): (String, String),
    body: &str,
    after: Option<&Function>,
) -> Result<Vec<Splice>, Refusal> {
    fragment::name(name)?;
    rename::free(context, component, name)?;
    fragment::body(body)?;
    let style = context.style(component);
    let Style { newline, indent, .. } = &style;
    let (docs, body) = (style.docs(docs, indent), style.body(body, indent));
    let code = format!("{docs}{indent}{attribute}{newline}{indent}{signature} {body}");
    Ok(vec![layout::insert(context.text, component, &style, after, &code)?])
}

/// Returns the function after which a new one is inserted: `after` if given, else the last function of the role (0 states, 1 transitions,
/// 2 hooks) or of an earlier role. `None` stands for the end of the block.
fn behind<'a>(component: &'a Component, after: Option<&str>, role: usize) -> Result<Option<&'a Function>, Refusal> {
    if let Some(after) = after {
        return function(component, after).map(Some);
    }
    let roles = [
        component.states.last().map(|state| &state.function),
        component.transitions.last().map(|transition| &transition.function),
        component.hooks.iter().map(|hook| &hook.function).max_by_key(|hook| hook.span.start),
    ];
    if role >= roles.len() {
        return Ok(None);
    }
    Ok(roles[role].or(roles[..role].iter().rev().find_map(|function| *function)))
}

/// Replaces the body of a function.
pub(super) fn body(context: &Context<'_>, component: &str, name: &str, code: &str) -> Result<Vec<Splice>, Refusal> {
    let component = context.component(component)?;
    let function = function(component, name)?;
    fragment::body(code)?;
    let Some(braces) = function.body else {
        return Err(Refusal::at(function.name.span, "the braces of this function are not complete: close them first"));
    };
    let style = context.style(component);
    let indent = super::style::indentation(context.text, function.span.start);
    Ok(vec![Splice::new(braces, style.block(code, indent))])
}

/// Copies a function; the copy follows it.
pub(super) fn copy(context: &Context<'_>, component: &str, from: &str, name: &str) -> Result<Vec<Splice>, Refusal> {
    let component = context.component(component)?;
    let function = function(component, from)?;
    fragment::name(name)?;
    rename::free(context, component, name)?;
    let style = context.style(component);
    let mut changes = vec![Splice::new(function.name.span, name)];
    if let Some(state) = component.state(from).filter(|state| state.initial) {
        changes.push(machine::words(context.text, state, false, state.end_word()));
    }
    // A transition on the copy leaves the copy.
    let arrows = component.state(from).into_iter().flat_map(|state| &state.arrows);
    changes.extend(arrows.map(|arrow| Splice::new(arrow.from_span, machine::written(name))));
    changes.sort_by_key(|change| change.span.start);
    let lines = layout::lines(context.text, function);
    let start = function.span.end - lines.len();
    for change in &mut changes {
        change.span.start -= start;
        change.span.end -= start;
    }
    let copy = applied(lines, &changes);
    Ok(vec![layout::insert(context.text, component, &style, Some(function), &copy)?])
}

/// Moves a function before another, or to the end.
pub(super) fn shift(
    context: &Context<'_>,
    component: &str,
    name: &str,
    before: Option<&str>,
) -> Result<Vec<Splice>, Refusal> {
    let component = context.component(component)?;
    let moved = function(component, name)?;
    let removal = layout::removal(context.text, moved);
    let style = context.style(component);
    if let Some(before) = before {
        let target = function(component, before)?;
        if target == moved {
            return Ok(Vec::new());
        }
        let code = moved.span.of(context.text);
        let space = format!("{}{}{}", style.newline, style.newline, style.indent);
        // The moved code may end with a line comment; `space` begins a new line, so that the comment does not include the target.
        return Ok(vec![Splice::remove(removal), Splice::insert(target.span.start, format!("{code}{space}"))]);
    }
    let last = component.functions().max_by_key(|function| function.span.start);
    if last == Some(moved) {
        return Ok(Vec::new());
    }
    let code = format!("{}{}", style.indent, moved.span.of(context.text));
    Ok(vec![Splice::remove(removal), layout::insert(context.text, component, &style, last, &code)?])
}
