//! A text as the parser sees it. All edits and the model are made from it.

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
    /// Its items, without those that are no Rust.
    pub(crate) file: File,
    /// Where the text is no Rust.
    pub(crate) problems: Vec<Problem>,
    /// The parts that were left out to read the rest.
    pub(crate) omitted: Vec<Span>,
}

/// The parser stores the texts of a thread for their places. So each thread has one source at a time.
impl Drop for Source<'_> {
    fn drop(&mut self) {
        proc_macro2::extra::invalidate_current_thread_spans();
    }
}

/// Parses a text; `None` if it is nested so deeply that the parser's stack could overflow.
pub(crate) fn parse(text: &str) -> Option<Source<'_>> {
    let tokens = lexed(text);
    if nesting::is_too_deep(&tokens) {
        return None;
    }
    let (file, problems, omitted) = mend::file(text, &tokens);
    Some(Source { text, tokens, file, problems, omitted })
}

impl Source<'_> {
    /// The place of a node.
    pub(crate) fn of(&self, node: &impl Spanned) -> Span {
        let range = node.span().byte_range();
        // Brackets that the text lacks stand after its end.
        Span::new(range.start.min(self.text.len()), range.end.min(self.text.len()))
    }

    /// A name without the `r#` of a raw identifier.
    pub(crate) fn name(&self, ident: &Ident) -> Name {
        Name { text: ident.unraw().to_string(), span: self.of(ident) }
    }

    /// The place between brackets; `None` if the text lacks the closing one.
    pub(super) fn within(&self, brackets: &DelimSpan) -> Option<Span> {
        let (open, close) = (brackets.open().byte_range(), brackets.close().byte_range());
        (close.start < self.text.len()).then(|| Span::new(open.end, close.start))
    }

    /// The place of an item with the comments on lines of their own directly above.
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
