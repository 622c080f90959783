//! A parsed text: the basis of the model and of all edits.

use proc_macro2::Ident;
use proc_macro2::extra::DelimSpan;
use syn::File;
use syn::ext::IdentExt;
use syn::spanned::Spanned;

use super::lexed::{Kind, Token, lexed};
use super::{mend, nesting};
use crate::model::{Name, Problem, Span};

/// A parsed text.
pub(crate) struct Source<'a> {
    pub(crate) text: &'a str,
    /// All tokens.
    pub(crate) tokens: Vec<Token<'a>>,
    /// Its items, without omitted parts.
    pub(crate) file: File,
    /// Its syntax errors.
    pub(crate) problems: Vec<Problem>,
    /// Parts that were omitted to parse the rest.
    pub(crate) omitted: Vec<Span>,
}

/// The parser keeps the texts of a thread to resolve spans, so a thread has one source at a time.
impl Drop for Source<'_> {
    fn drop(&mut self) {
        proc_macro2::extra::invalidate_current_thread_spans();
    }
}

/// Parses a text; returns `None` if its nesting could overflow the parser's stack.
pub(crate) fn parse(text: &str) -> Option<Source<'_>> {
    let tokens = lexed(text);
    if nesting::is_too_deep(&tokens) {
        return None;
    }
    let (file, problems, omitted) = mend::file(text, &tokens);
    Some(Source { text, tokens, file, problems, omitted })
}

impl Source<'_> {
    /// Returns the span of a node.
    pub(crate) fn of(&self, node: &impl Spanned) -> Span {
        let range = node.span().byte_range();
        // Missing brackets were appended after the end of the text.
        Span::new(range.start.min(self.text.len()), range.end.min(self.text.len()))
    }

    /// Returns a name without the `r#` of a raw identifier.
    pub(crate) fn name(&self, ident: &Ident) -> Name {
        Name { text: ident.unraw().to_string(), span: self.of(ident) }
    }

    /// Returns the span between brackets; `None` if the closing one is missing.
    pub(super) fn within(&self, brackets: &DelimSpan) -> Option<Span> {
        let (open, close) = (brackets.open().byte_range(), brackets.close().byte_range());
        (close.start < self.text.len()).then(|| Span::new(open.end, close.start))
    }

    /// Returns the span of an item with the comments on lines of their own directly above.
    pub(crate) fn item(&self, node: &impl Spanned) -> Span {
        let Span { start, end } = self.of(node);
        let first = self.tokens.partition_point(|token| token.span.start < start);
        let above = self.tokens[..first].iter().enumerate().rev().take_while(|(_, token)| {
            token.kind == Kind::Comment || token.kind == Kind::Space && token.text.matches('\n').count() < 2
        });
        let starts_line = |index: usize| index == 0 || self.tokens[index - 1].text.contains('\n');
        let begin = above.filter(|(index, token)| token.kind == Kind::Comment && starts_line(*index)).last();
        Span::new(begin.map_or(start, |(_, comment)| comment.span.start), end)
    }
}
