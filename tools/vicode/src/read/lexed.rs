//! Tokens of any text, including white space and comments.

use proc_macro2::Ident;
use ra_ap_rustc_lexer::LiteralKind::{Byte, Char, Float, Int};
use ra_ap_rustc_lexer::{FrontmatterAllowed, TokenKind, strip_shebang, tokenize};
use syn::ext::IdentExt;
use syn::parse::Parser;

use crate::model::Span;

/// Kind of a token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Space,
    Comment,
    /// A name or a keyword.
    Word,
    /// A string of any kind.
    Text,
    /// A number or a character.
    Literal,
    /// A sign, a bracket, or an unknown character.
    Mark,
}

/// A token and its span.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Token<'a> {
    pub(crate) kind: Kind,
    pub(crate) text: &'a str,
    pub(crate) span: Span,
}

impl Token<'_> {
    pub(crate) const fn is_trivia(&self) -> bool {
        matches!(self.kind, Kind::Space | Kind::Comment)
    }

    /// Returns whether it is a doc comment.
    pub(crate) fn is_doc(&self) -> bool {
        self.kind == Kind::Comment && ["///", "//!", "/**", "/*!"].iter().any(|mark| self.text.starts_with(mark))
    }

    /// Returns whether it is this word, with or without `r#`.
    pub(crate) fn is(&self, name: &str) -> bool {
        self.kind == Kind::Word && self.text.strip_prefix("r#").unwrap_or(self.text) == name
    }
}

/// Splits a text into tokens; each byte belongs to one.
pub(crate) fn lexed(text: &str) -> Vec<Token<'_>> {
    let mut at = prefix(text);
    let first = (at > 0).then(|| Token { kind: Kind::Space, text: &text[..at], span: Span::new(0, at) });
    let rest = tokenize(&text[at..], FrontmatterAllowed::No).map(|token| {
        let span = Span::new(at, at + usize::try_from(token.len).unwrap_or_default());
        at = span.end;
        Token { kind: kind(token.kind), text: span.of(text), span }
    });
    first.into_iter().chain(rest).collect()
}

/// Returns the length of a byte order mark and of a shebang line at the beginning.
pub(super) fn prefix(text: &str) -> usize {
    let mark = text.len() - text.trim_start_matches('\u{feff}').len();
    mark + strip_shebang(&text[mark..]).unwrap_or_default()
}

fn kind(kind: TokenKind) -> Kind {
    match kind {
        TokenKind::Whitespace => Kind::Space,
        TokenKind::LineComment { .. } | TokenKind::BlockComment { terminated: true, .. } => Kind::Comment,
        TokenKind::Ident | TokenKind::RawIdent => Kind::Word,
        TokenKind::Literal { kind, .. } => match kind {
            Int { .. } | Float { .. } | Char { .. } | Byte { .. } => Kind::Literal,
            _ => Kind::Text,
        },
        _ => Kind::Mark,
    }
}

/// Returns whether a word is a keyword of Rust.
pub(crate) fn is_keyword(word: &str) -> bool {
    word == "gen" || word != "_" && syn::parse_str::<Ident>(word).is_err() && Ident::parse_any.parse_str(word).is_ok()
}
