//! Places of new functions, and spans of removed ones.

use super::request::Refusal;
use super::splice::Splice;
use super::style::{Style, indentation, line_end, line_start, starts_line};
use crate::model::{Component, Function, Span};

/// Inserts formatted functions after `after`, or at the end of the block.
pub(super) fn insert(
    text: &str,
    component: &Component,
    style: &Style,
    after: Option<&Function>,
    code: &str,
) -> Result<Splice, Refusal> {
    let newline = style.newline;
    let Some(block) = component.block else {
        return Err(Refusal::at(component.name.span, "the braces of this block are not complete: close them first"));
    };
    if let Some(after) = after {
        let end = line_end(text, after.span.end);
        let rest = text[after.span.end..end].trim();
        if rest.is_empty() || rest.starts_with("//") && !rest.starts_with("///") {
            // The following text begins with the line break at `end`.
            return Ok(Splice::insert(end, format!("{newline}{newline}{code}")));
        }
        let indent = &style.indent;
        return Ok(Splice::insert(after.span.end, format!("{newline}{newline}{code}{newline}{newline}{indent}")));
    }
    let inner = block.of(text);
    let at = block.start + inner.trim_end().len();
    let lines = if inner.trim().is_empty() { newline.to_owned() } else { newline.repeat(2) };
    let tail = if text[at..block.end].contains('\n') { String::new() } else { format!("{newline}{}", style.outer) };
    Ok(Splice::insert(at, format!("{lines}{code}{tail}")))
}

/// Returns the span of a function with its lines and one of the empty lines around it.
pub(super) fn removal(text: &str, function: &Function) -> Span {
    let Span { start, end } = function.span;
    if !starts_line(text, start) || !text[end..line_end(text, end)].trim().is_empty() {
        return function.span;
    }
    let start = line_start(text, start);
    let end = next_line(text, end);
    let empty_before = start > 0 && text[line_start(text, start - 1)..start].trim().is_empty();
    let next = next_line(text, end);
    let empty_behind = end < text.len() && text[end..next].trim().is_empty() && next > end;
    if empty_behind {
        Span::new(start, next)
    } else if empty_before {
        Span::new(line_start(text, start - 1), end)
    } else {
        Span::new(start, end)
    }
}

/// Returns the offset of the next line.
fn next_line(text: &str, at: usize) -> usize {
    text[at..].find('\n').map_or(text.len(), |newline| at + newline + 1)
}

/// Returns the span of an attribute, with its line if it is alone there.
pub(super) fn attribute_removal(text: &str, attribute: Span) -> Span {
    let end = line_end(text, attribute.end);
    if starts_line(text, attribute.start) && text[attribute.end..end].trim().is_empty() {
        return Span::new(line_start(text, attribute.start), next_line(text, attribute.end));
    }
    let behind = text[attribute.end..].len() - text[attribute.end..].trim_start_matches([' ', '\t']).len();
    Span::new(attribute.start, attribute.end + behind)
}

/// Returns the span of an entry of a list with the separator behind it, or that before it if it is the last one.
pub(super) fn entry_removal(entries: &[Span], place: usize) -> Span {
    let (entry, before) = (entries[place], place.checked_sub(1).map(|before| entries[before]));
    match (entries.get(place + 1), before) {
        (Some(next), _) => Span::new(entry.start, next.start),
        (None, before) => Span::new(before.map_or(entry.start, |before| before.end), entry.end),
    }
}

/// Returns the lines of a function, the first with its indentation.
pub(super) fn lines<'a>(text: &'a str, function: &Function) -> &'a str {
    let Span { start, end } = function.span;
    if starts_line(text, start) { &text[start - indentation(text, start).len()..end] } else { &text[start..end] }
}
