//! Tokens of a node without white space and comments.

use ra_ap_parser::LexedStr;
use ra_ap_syntax::{Edition, NodeOrToken, SyntaxKind, SyntaxNode, T};

use super::span;
use crate::model::{Name, Span};

/// A token and its place.
#[derive(Clone, Debug)]
pub(crate) struct Token {
    pub(crate) kind: SyntaxKind,
    pub(crate) name: Name,
}

/// The tokens of a node, those of its brackets too.
pub(crate) fn tokens(node: &SyntaxNode) -> Vec<Token> {
    let all = node.descendants_with_tokens().filter_map(NodeOrToken::into_token);
    let tokens = all.filter(|token| !token.kind().is_trivia());
    tokens.map(|token| Token { kind: token.kind(), name: name(token.text(), span(token.text_range())) }).collect()
}

/// The tokens of a text that is no file, white space and comments too.
pub(crate) fn lexed(text: &str) -> Vec<Token> {
    let lexed = LexedStr::new(Edition::Edition2024, text);
    let token = |index| Name { text: lexed.text(index).to_owned(), span: lexed.text_range(index).into() };
    (0..lexed.len()).map(|index| Token { kind: lexed.kind(index), name: token(index) }).collect()
}

/// Whether a word is a keyword of the language.
pub(crate) fn is_keyword(word: &str) -> bool {
    LexedStr::single_token(Edition::Edition2024, word).is_some_and(|(kind, _)| kind.is_keyword(Edition::Edition2024))
}

/// A name without the `r#` of a raw identifier.
pub(crate) fn name(text: &str, span: Span) -> Name {
    Name { text: text.strip_prefix("r#").unwrap_or(text).to_owned(), span }
}

/// The tokens as one writes them: `Eye<320, 240>`.
pub(crate) fn written(tokens: &[Token]) -> String {
    let mut text = String::new();
    let mut before: Option<SyntaxKind> = None;
    for token in tokens {
        let word = |kind: SyntaxKind| kind == SyntaxKind::IDENT || kind.is_literal() || kind.is_any_identifier();
        let spaced = before.is_some_and(|before| {
            word(before) && word(token.kind) || matches!(before, T![,] | T![;]) || before == T![mut]
        });
        if spaced {
            text.push(' ');
        }
        text.push_str(&token.name.text);
        before = Some(token.kind);
    }
    text
}

/// From the first to the last token.
pub(crate) fn around(tokens: &[Token]) -> Option<Span> {
    Some(Span::new(tokens.first()?.name.span.start, tokens.last()?.name.span.end))
}

/// The parts between the separators that stand outside of brackets.
pub(crate) fn split(tokens: &[Token], separator: SyntaxKind) -> Vec<&[Token]> {
    let mut depth = 0_usize;
    tokens
        .split(|token| {
            match token.kind {
                T!['('] | T!['['] | T!['{'] => depth += 1,
                T![')'] | T![']'] | T!['}'] => depth = depth.saturating_sub(1),
                _ => {}
            }
            depth == 0 && token.kind == separator
        })
        .collect()
}
