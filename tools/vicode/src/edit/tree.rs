//! Edits of activation trees: names of components, and providers of roles.

use bica_syntax::text::written;
use bica_syntax::tree::model::{Draft, Entry, RoleEntry};

use super::context::{Context, list};
use super::fragment;
use super::layout::entry_removal;
use super::request::Refusal;
use super::splice::Splice;
use crate::model::Span;
use crate::read::{Outline, Source, drafts, lexed, parse};

/// Renames a component that has a name of its own in a tree; without `to` it is removed from the list.
pub(super) fn member(context: &Context<'_>, tree: &str, name: &str, to: Option<&str>) -> Result<Vec<Splice>, Refusal> {
    in_tree(context, tree, |source, draft| {
        let entries = draft.components.as_deref().unwrap_or_default();
        let names: Vec<_> = entries.iter().filter_map(|entry| Some(source.name(entry.name.as_ref()?))).collect();
        let Some(own) = names.iter().find(|own| own.text == name) else {
            let known = list(names.iter().map(|own| &*own.text));
            return Err(Refusal::new(format!("`{tree}` has no component with the name `{name}`: there is {known}")));
        };
        let Some(to) = to else { return removed(source, draft, entries, own.span) };
        fragment::name(to)?;
        if to.starts_with(char::is_uppercase) {
            return Err(Refusal::new(format!("`{to}` looks like a type: begin the name with a small letter")));
        }
        match names.iter().find(|other| other.text == to && other.span != own.span) {
            Some(other) => {
                let message = format!("`{tree}` has a component `{to}` already: choose another name");
                Err(Refusal::at(other.span, message))
            }
            None => Ok(vec![Splice::new(own.span, to)]),
        }
    })
}

/// Removes the component whose name has a span, unless it provides a role.
fn removed(source: &Source<'_>, draft: &Draft, entries: &[Entry], name: Span) -> Result<Vec<Splice>, Refusal> {
    let span = |entry: &Entry| {
        let start = entry.name.as_ref().map_or_else(|| source.of(&entry.kind), |name| source.of(name)).start;
        Span::new(start, entry.value.as_ref().map_or_else(|| source.of(&entry.kind), |value| source.of(value)).end)
    };
    let spans: Vec<Span> = entries.iter().map(span).collect();
    let place = spans.iter().position(|span| span.start == name.start).unwrap_or_default();
    let kind = written(&entries[place].kind);
    match draft.roles.iter().find(|role| written(&role.provider) == kind) {
        Some(role) => {
            let message = format!("`{kind}` provides `{}`: name another provider first", written(&role.role));
            Err(Refusal::at(source.of(&role.provider), message))
        }
        None => Ok(vec![without(source.text, &spans, place)]),
    }
}

/// Sets the provider of a role; without one the role is removed from the tree, or is added.
pub(super) fn provider(
    context: &Context<'_>,
    tree: &str,
    role: &str,
    provider: Option<&str>,
) -> Result<Vec<Splice>, Refusal> {
    // Before the tree is parsed: parsing another text makes its spans invalid.
    provider.map_or(Ok(()), fragment::ty)?;
    in_tree(context, tree, |source, draft| {
        let Some(place) = draft.roles.iter().position(|entry| written(&entry.role) == role) else {
            let known: Vec<String> = draft.roles.iter().map(|entry| written(&entry.role)).collect();
            let known = list(known.iter().map(String::as_str));
            return Err(Refusal::new(format!("`{tree}` has no role `{role}`: there is {known}")));
        };
        let Some(provider) = provider else {
            let of = |entry: &RoleEntry| Span::new(source.of(&entry.role).start, source.of(&entry.provider).end);
            let spans: Vec<Span> = draft.roles.iter().map(of).collect();
            return Ok(vec![without(source.text, &spans, place)]);
        };
        let components = draft.components.iter().flatten();
        let known: Vec<String> = components.map(|entry| written(&entry.kind)).collect();
        if !known.iter().any(|one| one == provider) {
            let known = list(known.iter().map(String::as_str));
            return Err(Refusal::new(format!("`{tree}` has no component `{provider}`: there is {known}")));
        }
        Ok(vec![Splice::new(source.of(&draft.roles[place].provider), provider)])
    })
}

/// Runs an edit of the tree with that name.
fn in_tree<T>(
    context: &Context<'_>,
    name: &str,
    edit: impl FnOnce(&Source<'_>, &Draft) -> Result<T, Refusal>,
) -> Result<T, Refusal> {
    let source = parse(context.text).ok_or_else(|| Refusal::new("this file is nested too deeply"))?;
    let drafts = drafts(&Outline::of(&source));
    let Some(draft) = drafts.iter().find(|draft| draft.name == name) else {
        let known: Vec<String> = drafts.iter().map(|draft| draft.name.to_string()).collect();
        let known = list(known.iter().map(String::as_str));
        return Err(Refusal::new(format!("no tree `{name}` is in this file: there is {known}")));
    };
    edit(&source, draft)
}

/// Removes an entry of a list, with its comma. Comments stay.
fn without(text: &str, entries: &[Span], place: usize) -> Splice {
    let mut span = entry_removal(entries, place);
    if let [only] = entries {
        let next = lexed(&text[only.end..]).into_iter().find(|token| !token.is_trivia());
        span.end += next.filter(|token| token.text == ",").map_or(0, |token| token.span.end);
    }
    Splice::keeping_comments(text, span, "")
}
