//! Doc comments.

use ra_ap_syntax::ast::{self, HasDocComments};
use ra_ap_syntax::{AstNode, AstToken, SyntaxNode};

use super::span;
use crate::model::{Docs, Span};

/// The doc comment of an item, its `#[doc = "..."]` attributes included.
pub(super) fn docs(item: &impl HasDocComments) -> Docs {
    of_node(item.syntax())
}

/// The doc comment of a node.
pub(super) fn of_node(node: &SyntaxNode) -> Docs {
    let mut lines: Vec<String> = Vec::new();
    let mut docs = Docs { plain: true, ..Docs::default() };
    for child in node.children_with_tokens() {
        let (line, at, plain) = match &child {
            ra_ap_syntax::NodeOrToken::Token(token) => {
                let Some(comment) = ast::Comment::cast(token.clone()) else { continue };
                let Some((text, _)) = comment.doc_comment() else { continue };
                (text.to_owned(), span(token.text_range()), comment.kind().shape.is_line())
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
        lines.push(line.trim().to_owned());
    }
    lines.join("\n").trim().clone_into(&mut docs.text);
    docs
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
