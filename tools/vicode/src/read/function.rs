//! Functions of an impl block.

use bica_syntax::component::{meaning, model as syntax};
use bica_syntax::text;
use ra_ap_syntax::ast::{self, HasName};
use ra_ap_syntax::{AstNode, AstToken, NodeOrToken, SyntaxKind, SyntaxNode, SyntaxToken};

use super::tokens::{name, tokens, written};
use super::{docs, span, within};
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

/// Where a function begins: with its docs and attributes, and with the comments on lines of their own directly above.
///
/// The parser also counts the comment at the end of the line before, and with `\r\n` comments above an empty line.
pub(super) fn start(item: &SyntaxNode) -> usize {
    let is_comment =
        |token: &SyntaxToken| ast::Comment::cast(token.clone()).is_some_and(|comment| comment.doc_comment().is_none());
    let is_space = |token: &SyntaxToken| token.kind() == SyntaxKind::WHITESPACE;
    let mut tokens = item.descendants_with_tokens().filter_map(NodeOrToken::into_token);
    let Some(first) = tokens.find(|token| !is_comment(token) && !is_space(token)) else {
        return span(item.text_range()).start;
    };
    let above = std::iter::successors(first.prev_token(), SyntaxToken::prev_token)
        .take_while(|token| is_comment(token) || is_space(token) && token.text().matches('\n').count() < 2);
    let starts_line = |token: &SyntaxToken| token.prev_token().is_none_or(|before| before.text().contains('\n'));
    let begin = above.filter(|token| is_comment(token) && starts_line(token)).last().unwrap_or(first);
    span(begin.text_range()).start
}

fn argument(param: &ast::Param, own: &str) -> Argument {
    let place = span(param.syntax().text_range());
    let pattern = param.pat().map(|pattern| pattern.syntax().clone());
    let pattern = pattern.map_or_else(
        || Name { text: String::new(), span: Span::at(place.start) },
        |node| name(&node.text().to_string(), span(node.text_range())),
    );
    let ty = param.ty();
    let written = ty.map_or(Name { text: String::new(), span: Span::at(place.end) }, |ty| Name {
        text: written(&tokens(ty.syntax())),
        span: span(ty.syntax().text_range()),
    });
    let input = input(&written.text, own);
    Argument { name: pattern, span: place, written, input }
}

/// What a type means, by the rules of the macro.
fn input(ty: &str, own: &str) -> Input {
    let link = |kind, child| Input::Link { kind, child: text::written(&child) };
    let (Ok(ty), Ok(own)) = (ty.parse(), own.parse()) else { return Input::Other };
    match meaning(ty, own) {
        Some(syntax::Argument::Read(child)) => link(LinkKind::Requirement, child),
        Some(syntax::Argument::Write(child)) => link(LinkKind::Modulation, child),
        Some(syntax::Argument::Rate(child)) => link(LinkKind::Rate, child),
        Some(syntax::Argument::OwnRate) => Input::OwnRate,
        Some(syntax::Argument::Time(_)) => Input::Time,
        Some(syntax::Argument::Tuned(of)) => Input::Tuned { parameters: text::written(&of) },
        None => Input::Other,
    }
}
