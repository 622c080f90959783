//! Children of functions: arguments that are links.

use super::context::{Context, function, list};
use super::request::{Edit, Refusal};
use super::splice::Splice;
use super::style::{Style, indentation, line_end, line_start, snake};
use super::{fragment, imports};
use crate::model::{Argument, Function, Input, LinkKind, Span};
use crate::read::{Kind, Token, lexed};

/// Adds, removes or changes a link.
pub(super) fn change(context: &Context<'_>, edit: &Edit) -> Result<Vec<Splice>, Refusal> {
    match edit {
        Edit::AddChild { component, function: name, child, kind, argument, import } => {
            let component = context.component(component)?;
            let function = function(component, name)?;
            fragment::child(child)?;
            with_kind(child, *kind)?;
            if function.links().any(|(_, _, known)| known == child) {
                return Err(Refusal::new(format!(
                    "`{child}` is a child of `{name}` already: change the kind of its link"
                )));
            }
            let argument = match argument {
                Some(argument) => argument.clone(),
                None => argument_name(function, child),
            };
            fragment::name(argument.trim_start_matches('_'))?;
            if function.arguments.iter().any(|known| known.name.text == argument) {
                return Err(Refusal::new(format!(
                    "`{name}` has an argument `{argument}` already: choose another name"
                )));
            }
            let mut splices =
                add(context.text, &context.style(component), function, &format!("{argument}: {}", link(*kind, child)));
            if let Some(path) = import {
                fragment::path(path)?;
                splices.extend(imports::add(context, component.span.start, path, child));
            }
            Ok(splices)
        }
        Edit::RemoveChild { component, function: name, child } => {
            let function = function(context.component(component)?, name)?;
            let argument = find(function, child)?;
            unused(context.text, function, argument)?;
            let mut splices =
                vec![Splice::keeping_comments(context.text, with_comma(context.text, function, argument), "")];
            splices.extend(imports::remove(context, child, argument.span));
            Ok(splices)
        }
        Edit::SetChildKind { component, function: name, child, kind } => {
            let function = function(context.component(component)?, name)?;
            let argument = find(function, child)?;
            with_kind(child, *kind)?;
            Ok(vec![Splice::new(argument.written.span, link(*kind, child))])
        }
        _ => Ok(Vec::new()),
    }
}

/// Refuses the rate of a role.
fn with_kind(child: &str, kind: LinkKind) -> Result<(), Refusal> {
    match child.strip_prefix("impl ") {
        Some(role) if kind == LinkKind::Rate => {
            Err(Refusal::new(format!("`{role}` is a role, and a rate belongs to a component: name its provider")))
        }
        _ => Ok(()),
    }
}

fn link(kind: LinkKind, child: &str) -> String {
    match kind {
        LinkKind::Requirement => format!("&{child}"),
        LinkKind::Modulation => format!("&mut {child}"),
        LinkKind::Rate => format!("&mut Rate<{child}>"),
    }
}

fn find<'a>(function: &'a Function, child: &str) -> Result<&'a Argument, Refusal> {
    let is_child = |argument: &&Argument| matches!(&argument.input, Input::Link { child: known, .. } if known == child);
    function.arguments.iter().find(is_child).ok_or_else(|| {
        let known = list(function.links().map(|(_, _, child)| child));
        Refusal::new(format!("`{}` has no child `{child}`: there is {known}", function.name.text))
    })
}

/// Returns an unused name for an argument: `ball_detector` for `BallDetector`.
fn argument_name(function: &Function, child: &str) -> String {
    let child = child.strip_prefix("impl ").unwrap_or(child);
    let last = child.split('<').next().unwrap_or(child).rsplit("::").next().unwrap_or(child);
    let mut name = snake(last.trim());
    let taken = |name: &str| function.arguments.iter().any(|known| known.name.text == name);
    if fragment::name(&name).is_err() {
        name.push_str("_child");
    }
    let base = name.clone();
    let mut number = 2;
    while taken(&name) {
        name = format!("{base}_{number}");
        number += 1;
    }
    name
}

/// Adds an argument after the last one.
fn add(text: &str, style: &Style, function: &Function, argument: &str) -> Vec<Splice> {
    let inner = function.inputs.of(text);
    let last = last_token(inner);
    let comma = last.is_some_and(|last| last.of(inner) == ",");
    let at = function.inputs.start + last.map_or(0, |last| last.end);
    let indent = indentation(text, at);
    // rustfmt breaks a list of arguments into lines, each with a comma.
    if inner.contains('\n') && comma {
        return vec![Splice::insert(at, format!("{}{indent}{argument},", style.newline))];
    }
    let separator = match (last.is_some(), comma) {
        (false, _) => "",
        (true, true) => " ",
        (true, false) => ", ",
    };
    let line = &text[line_start(text, at)..line_end(text, at)];
    let fits = line.chars().count() + separator.len() + argument.chars().count() <= style.width;
    if fits || inner.contains(['\n', '/']) {
        return vec![Splice::insert(at, format!("{separator}{argument}"))];
    }
    vec![Splice::new(function.inputs, broken(text, style, function, argument))]
}

/// Formats all arguments and a new one, one on each line.
fn broken(text: &str, style: &Style, function: &Function, argument: &str) -> String {
    let outer = indentation(text, function.name.span.start);
    let first = function.arguments.first().map_or(function.inputs.end, |first| first.span.start);
    let this = Span::new(function.inputs.start, first).of(text).trim().trim_end_matches(',').trim_end();
    let known = function.arguments.iter().map(|known| known.span.of(text));
    let lines = [this].into_iter().filter(|this| !this.is_empty()).chain(known).chain([argument]);
    let mut result = String::new();
    for line in lines {
        for part in [style.newline, outer, style.unit(), line, ","] {
            result.push_str(part);
        }
    }
    result + style.newline + outer
}

/// Returns the last token of a list that is neither white space nor a comment.
fn last_token(list: &str) -> Option<Span> {
    Some(lexed(list).iter().rfind(|token| !token.is_trivia())?.span)
}

/// Refuses to remove an argument that the body uses.
fn unused(text: &str, function: &Function, argument: &Argument) -> Result<(), Refusal> {
    let Some(body) = function.body else { return Ok(()) };
    let name = argument.name.text.trim_start_matches("mut ").trim();
    let is_use = |token: &Token<'_>| token.is(name) || token.kind == Kind::Text && formats(token.text, name);
    let Some(Token { span, .. }) = lexed(body.of(text)).into_iter().find(is_use) else {
        return Ok(());
    };
    let message = format!("the code of `{}` uses `{name}`: remove that use first", function.name.text);
    Err(Refusal::at(Span::new(body.start + span.start, body.start + span.end), message))
}

/// Returns whether a string literal may be a format with a variable: `{name}`, `{name:?}`, `{:name$}`.
fn formats(literal: &str, name: &str) -> bool {
    let is_word = |one: char| one.is_alphanumeric() || one == '_';
    literal.match_indices(name).any(|(at, _)| {
        let behind = literal[at + name.len()..].trim_start();
        let before = literal[..at].trim_end();
        (before.ends_with('{') && behind.starts_with(['}', ':']))
            || (!before.ends_with(is_word) && behind.starts_with('$'))
    })
}

/// Returns the span of an argument with one of the commas around it.
fn with_comma(text: &str, function: &Function, argument: &Argument) -> Span {
    let place = function.arguments.iter().position(|one| one == argument).unwrap_or_default();
    let next = function.arguments.get(place + 1);
    if let Some(next) = next {
        return Span::new(argument.span.start, next.span.start);
    }
    let before = &text[function.inputs.start..argument.span.start];
    let Some(last) = last_token(before) else { return argument.span };
    let start = function.inputs.start + last.start;
    if last.of(before) == "," {
        // The comma after the removed argument becomes the trailing one.
        let behind = &text[argument.span.end..function.inputs.end];
        let comma = behind.trim_start().starts_with(',');
        let end = argument.span.end + if comma { behind.find(',').unwrap_or(0) } else { 0 };
        return Span::new(start, end);
    }
    argument.span
}
