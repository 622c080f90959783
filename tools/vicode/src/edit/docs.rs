//! Doc comments.

use super::context::{Context, function};
use super::request::Refusal;
use super::splice::Splice;
use super::style::{indentation, line_end, starts_line};
use crate::model::{Docs, Span};

/// Sets the doc comment of a function or of the block.
pub(super) fn set(
    context: &Context<'_>,
    component: &str,
    name: Option<&str>,
    docs: &str,
) -> Result<Vec<Splice>, Refusal> {
    let component = context.component(component)?;
    let (old, start) = match name {
        Some(name) => {
            let function = function(component, name)?;
            (&function.docs, function.span.start)
        }
        None => (&component.docs, component.span.start),
    };
    let style = context.style(component);
    let Some(span) = old.span else {
        let indent = indentation(context.text, start).to_owned();
        let lines = style.docs(docs, &indent);
        // The first line has its indentation already, and the code after it needs one.
        let own_line = starts_line(context.text, start);
        let lines = if own_line { lines.trim_start_matches([' ', '\t']).to_owned() + &indent } else { lines };
        let lines = if own_line { lines } else { format!("{}{lines}{indent}", style.newline) };
        return Ok(if docs.trim().is_empty() { Vec::new() } else { vec![Splice::insert(start, lines)] });
    };
    simple(context.text, old, span)?;
    let indent = indentation(context.text, span.start);
    let lines = style.docs(docs, indent);
    if lines.is_empty() {
        let end = line_end(context.text, span.end);
        let behind = &context.text[end..];
        let white = behind.len() - behind.trim_start().len();
        return Ok(vec![Splice::remove(Span::new(span.start, end + white))]);
    }
    // The span excludes the indentation of the first line, and the last line break.
    let lines = lines.trim_start_matches([' ', '\t']).trim_end();
    Ok(vec![Splice::new(span, lines)])
}

/// Refuses a doc comment that does not consist of consecutive `///` lines.
fn simple(text: &str, docs: &Docs, span: Span) -> Result<(), Refusal> {
    let simple = docs.plain && span.of(text).lines().all(|line| line.trim_start().starts_with("///"));
    if simple {
        return Ok(());
    }
    Err(Refusal::at(span, "this doc comment has more than `///` lines: change it in the code"))
}
