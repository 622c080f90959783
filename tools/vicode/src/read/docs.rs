//! Doc comments.

use syn::{AttrStyle, Attribute, Expr, ExprLit, Lit, Meta};

use super::Source;
use crate::model::{Docs, Span};

/// Returns the doc comment of an item, including `#[doc = "..."]`.
pub(super) fn docs(source: &Source<'_>, attributes: &[Attribute]) -> Docs {
    let mut lines: Vec<String> = Vec::new();
    let mut docs = Docs { plain: true, ..Docs::default() };
    for attribute in attributes.iter().filter(|one| matches!(one.style, AttrStyle::Outer)) {
        let Some(text) = text(attribute) else { continue };
        let at = source.of(attribute);
        let written = at.of(source.text);
        docs.plain &= written.starts_with("//");
        // With `\r\n` the token of a line comment ends after the `\r`.
        let at = Span::new(at.start, at.end - usize::from(written.ends_with('\r')));
        docs.span = Some(docs.span.map_or(at, |before| Span::new(before.start, at.end)));
        lines.extend(text.split('\n').map(|line| line.trim_end().to_owned()));
    }
    let common = lines.iter().filter(|line| !line.is_empty()).map(|line| indent(line)).min().unwrap_or(0);
    let lines: Vec<&str> = lines.iter().map(|line| line.get(common..).unwrap_or_default()).collect();
    lines.join("\n").trim_matches('\n').clone_into(&mut docs.text);
    docs
}

/// Returns the indentation of a line, bytes.
fn indent(line: &str) -> usize {
    line.len() - line.trim_start_matches([' ', '\t']).len()
}

/// Returns the text of `#[doc = "..."]`, the form of each doc comment in the syntax tree.
fn text(attribute: &Attribute) -> Option<String> {
    let Meta::NameValue(pair) = &attribute.meta else { return None };
    match &pair.value {
        Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) if pair.path.is_ident("doc") => Some(text.value()),
        _ => None,
    }
}
