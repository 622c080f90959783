//! Functions of an impl block.

use ra_ap_syntax::ast::{self, HasGenericArgs, HasName};
use ra_ap_syntax::{AstNode, AstToken, NodeOrToken, SyntaxElement, SyntaxNode, T};

use super::tokens::{Token, name, tokens, written};
use super::{docs, span};
use crate::model::{Argument, Function, Input, LinkKind, Name, Span};

/// Reads a function; `None` without a name.
pub(super) fn function(item: &ast::Fn, own: &str) -> Option<Function> {
    let ident = item.name()?;
    let ident = name(ident.text(), span(ident.syntax().text_range()));
    let list = item.param_list();
    let inputs = list.as_ref().map_or(Span::at(ident.span.end), |list| within(span(list.syntax().text_range())));
    let arguments = list.iter().flat_map(ast::ParamList::params).map(|param| argument(&param, own)).collect();
    let body = item.body().and_then(|body| body.stmt_list());
    let body = body.filter(|list| list.r_curly_token().is_some()).map(|list| within(span(list.syntax().text_range())));
    Some(Function {
        name: ident,
        span: Span::new(start(item.syntax()), span(item.syntax().text_range()).end),
        docs: docs::docs(item),
        inputs,
        arguments,
        body,
    })
}

/// Where a function begins: with its docs and attributes, and with the comments that stand on lines of their own right above them.
///
/// The parser also counts the comment at the end of the line before, and with `\r\n` comments above an empty line.
fn start(item: &SyntaxNode) -> usize {
    let begins = |element: &SyntaxElement| span(element.text_range()).start;
    let mut start = span(item.text_range()).start;
    let mut pending = None;
    let mut line_is_new =
        item.first_token().and_then(|first| first.prev_token()).is_none_or(|before| before.text().contains('\n'));
    for element in item.children_with_tokens() {
        let comment = element.as_token().cloned().and_then(ast::Comment::cast);
        match (&element, comment) {
            (_, Some(comment)) if comment.doc_comment().is_some() => {
                return pending.unwrap_or_else(|| begins(&element));
            }
            (_, Some(_)) => {
                // A comment that follows code on its line belongs to that code.
                pending = if line_is_new { pending.or(Some(begins(&element))) } else { None };
                line_is_new = false;
            }
            (NodeOrToken::Token(token), None) if token.kind().is_trivia() => {
                let breaks = token.text().matches('\n').count();
                line_is_new |= breaks > 0;
                if breaks > 1 {
                    pending = None;
                }
            }
            _ => {
                start = pending.unwrap_or_else(|| begins(&element));
                break;
            }
        }
    }
    start
}

/// Without the brackets.
fn within(span: Span) -> Span {
    Span::new(span.start + 1, span.end.saturating_sub(1).max(span.start + 1))
}

fn argument(param: &ast::Param, own: &str) -> Argument {
    let place = span(param.syntax().text_range());
    let pattern = param.pat().map(|pattern| pattern.syntax().clone());
    let pattern = pattern.map_or_else(
        || Name { text: String::new(), span: Span::at(place.start) },
        |node| name(&node.text().to_string(), span(node.text_range())),
    );
    let ty = param.ty();
    let type_tokens = ty.as_ref().map(|ty| tokens(ty.syntax())).unwrap_or_default();
    let type_span = ty.as_ref().map_or(Span::at(place.end), |ty| span(ty.syntax().text_range()));
    Argument {
        name: pattern,
        span: place,
        written: Name { text: written(&type_tokens), span: type_span },
        input: ty.map_or(Input::Other, |ty| input(ty, own)),
    }
}

fn plain(mut ty: ast::Type) -> ast::Type {
    while let ast::Type::ParenType(inner) = &ty {
        let Some(inner) = inner.ty() else { break };
        ty = inner;
    }
    ty
}

fn input(ty: ast::Type, own: &str) -> Input {
    let ast::Type::RefType(reference) = plain(ty) else { return Input::Other };
    let Some(of) = reference.ty().map(plain) else { return Input::Other };
    let ast::Type::PathType(path) = &of else { return Input::Other };
    let mutable = reference.mut_token().is_some();
    let Some(segment) = path.path().and_then(|path| path.segment()) else { return Input::Other };
    let last = segment.name_ref().map(|name| name.text().to_string()).unwrap_or_default();
    match last.as_str() {
        "Time" => Input::Time,
        "Tuned" => argument_of(&segment).map_or(Input::Other, |parameters| Input::Tuned { parameters }),
        "Rate" => match argument_of(&segment) {
            Some(child) if child == "Self" || child == own => Input::OwnRate,
            Some(child) => Input::Link { kind: LinkKind::Rate, child },
            None => Input::Other,
        },
        _ if is_value(&last) => Input::Other,
        _ => {
            let kind = if mutable { LinkKind::Modulation } else { LinkKind::Requirement };
            let child = written(&tokens(of.syntax()));
            if child == "Self" || child == own { Input::Other } else { Input::Link { kind, child } }
        }
    }
}

/// Whether a type begins with a small letter, as those of the language do.
fn is_value(name: &str) -> bool {
    name.starts_with(|first: char| first.is_lowercase())
        || matches!(name, "String" | "Vec" | "Box" | "Option" | "Result" | "Instant" | "Duration" | "ComponentId")
}

/// What stands in the angle brackets.
fn argument_of(segment: &ast::PathSegment) -> Option<String> {
    let all: Vec<Token> = tokens(segment.generic_arg_list()?.syntax());
    let inner = all.get(1..all.len().checked_sub(1)?)?;
    (!inner.is_empty() && all.first()?.kind == T![<]).then(|| written(inner))
}
