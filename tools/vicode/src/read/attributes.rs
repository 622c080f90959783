//! Attributes of the macros.

use ra_ap_syntax::{AstNode, SyntaxKind, T, ast};

use super::span;
use super::tokens::{Token, around, split, tokens};
use crate::model::{Arrow, Name, Setting, Sources, Span};

/// An attribute: its name, its place, and what stands in its parentheses.
#[derive(Clone, Debug)]
pub(super) struct Attribute {
    pub(super) name: String,
    pub(super) span: Span,
    /// Place and tokens between the parentheses.
    pub(super) list: Option<(Span, Vec<Token>)>,
}

/// Reads an attribute; `None` without a name.
pub(super) fn attribute(attribute: &ast::Attr) -> Option<Attribute> {
    let meta = attribute.meta()?;
    let (path, tree) = match &meta {
        ast::Meta::PathMeta(meta) => (meta.path()?, None),
        ast::Meta::TokenTreeMeta(meta) => (meta.path()?, meta.token_tree()),
        ast::Meta::KeyValueMeta(meta) => (meta.path()?, None),
        _ => return None,
    };
    let name = path.segment()?.name_ref()?.text().to_string();
    Some(Attribute { name, span: span(attribute.syntax().text_range()), list: tree.map(|tree| content(&tree)) })
}

/// What stands between the brackets of a tree.
pub(crate) fn content(tree: &ast::TokenTree) -> (Span, Vec<Token>) {
    let mut all = tokens(tree.syntax());
    let whole = span(tree.syntax().text_range());
    let (mut start, mut end) = (whole.start, whole.end);
    if tree.left_delimiter_token().is_some() {
        start = all.remove(0).name.span.end;
    }
    if tree.right_delimiter_token().is_some()
        && let Some(last) = all.pop()
    {
        end = last.name.span.start;
    }
    (Span::new(start, end), all)
}

/// `key = value, key`
pub(super) fn settings(list: &[Token], text: &str) -> Vec<Setting> {
    split(list, T![,]).into_iter().filter_map(|part| setting(part, text)).collect()
}

fn setting(part: &[Token], text: &str) -> Option<Setting> {
    let (span, key) = (around(part)?, part.first()?.name.clone());
    let value = part.get(1).filter(|token| token.kind == T![=]).and_then(|_| around(&part[2..]));
    let value = value.map(|span| Name { text: span.of(text).to_owned(), span });
    Some(Setting { span, key, value })
}

/// `a | b`
pub(super) fn names(list: &[Token]) -> Vec<Name> {
    let names = list.iter().filter(|token| is_name(token.kind));
    names.map(|token| token.name.clone()).collect()
}

fn is_name(kind: SyntaxKind) -> bool {
    kind == SyntaxKind::IDENT || kind.is_any_identifier() || kind.is_keyword(ra_ap_syntax::Edition::Edition2024)
}

/// `a | b -> c, after_ms = N`
pub(super) fn arrow(attribute: &Attribute) -> Option<Arrow> {
    let (list, tokens) = attribute.list.as_ref()?;
    let at = tokens.windows(2).position(|pair| pair[0].kind == T![-] && pair[1].kind == T![>])?;
    let (before, behind) = (&tokens[..at], &tokens[at + 2..]);
    let from_span = around(before).unwrap_or(Span::at(list.start));
    let from = match before {
        [star] if star.kind == T![*] => Sources::Any,
        _ => Sources::These(names(before)),
    };
    let to = behind.first().filter(|token| is_name(token.kind)).map(|token| token.name.clone());
    let comma = behind.iter().position(|token| token.kind == T![,]);
    let after_ms = comma.and_then(|comma| timer(&behind[comma..]));
    Some(Arrow { span: attribute.span, list: *list, from, from_span, to, after_ms })
}

/// `, after_ms = N`
fn timer(part: &[Token]) -> Option<(u32, Span)> {
    let [comma, key, equals, value, ..] = part else { return None };
    if key.name.text != "after_ms" || equals.kind != T![=] {
        return None;
    }
    let digits: String = value.name.text.chars().filter(|character| *character != '_').collect();
    let digits = digits.find(|character: char| !character.is_ascii_digit()).map_or(&*digits, |at| &digits[..at]);
    Some((digits.parse().ok()?, Span::new(comma.name.span.start, value.name.span.end)))
}
