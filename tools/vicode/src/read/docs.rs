//! Doc comments.

use ra_ap_syntax::ast::{self, HasDocComments};
use ra_ap_syntax::{AstNode, AstToken};

use super::span;
use crate::model::{Docs, Span};

/// The doc comment of an item, its `#[doc = "..."]` attributes included.
pub(super) fn docs(item: &impl HasDocComments) -> Docs {
    let mut lines: Vec<String> = Vec::new();
    let mut docs = Docs { plain: true, ..Docs::default() };
    for child in item.syntax().children_with_tokens() {
        let (line, at, plain) = match &child {
            ra_ap_syntax::NodeOrToken::Token(token) => {
                let Some(comment) = ast::Comment::cast(token.clone()) else { continue };
                let Some((text, _)) = comment.doc_comment() else { continue };
                // With `\r\n` the token of a line comment ends after the `\r`.
                let at = span(token.text_range());
                let at = Span::new(at.start, at.end - usize::from(token.text().ends_with('\r')));
                (text.to_owned(), at, comment.kind().shape.is_line())
            }
            ra_ap_syntax::NodeOrToken::Node(node) => {
                let Some(text) = ast::Attr::cast(node.clone()).and_then(|attribute| attribute_text(&attribute)) else {
                    continue;
                };
                (text, span(node.text_range()), false)
            }
        };
        docs.plain &= plain;
        docs.span = Some(docs.span.map_or(at, |before| Span::new(before.start, at.end)));
        lines.extend(line.split('\n').map(|line| line.trim_end().to_owned()));
    }
    let common = lines.iter().filter(|line| !line.is_empty()).map(|line| indent(line)).min().unwrap_or(0);
    let lines: Vec<&str> = lines.iter().map(|line| line.get(common..).unwrap_or_default()).collect();
    lines.join("\n").trim_matches('\n').clone_into(&mut docs.text);
    docs
}

/// White space before a line of docs, bytes.
fn indent(line: &str) -> usize {
    line.len() - line.trim_start_matches([' ', '\t']).len()
}

/// The text of `#[doc = "..."]`.
fn attribute_text(attribute: &ast::Attr) -> Option<String> {
    let ast::Meta::KeyValueMeta(pair) = attribute.meta()? else { return None };
    if pair.path()?.syntax().text() != "doc" {
        return None;
    }
    let ast::Expr::Literal(literal) = pair.expr()? else { return None };
    match literal.kind() {
        ast::LiteralKind::String(text) => text.value().ok().map(std::borrow::Cow::into_owned),
        _ => None,
    }
}
