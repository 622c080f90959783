//! Error recovery of the parser: a text is read without the smallest parts around its syntax errors.

use std::ops::Range;

use proc_macro2::TokenStream;
use syn::File;

use super::lexed::{Kind, Token, prefix};
use crate::model::{Problem, Span};

/// Largest number of omitted parts; of a text with more errors no item is read.
const MOST: usize = 40;

/// Parses a text; returns its items, its syntax errors, and the omitted parts.
pub(super) fn file(text: &str, tokens: &[Token<'_>]) -> (File, Vec<Problem>, Vec<Span>) {
    let tokens = tokens.iter().filter(|token| !token.is_trivia() || token.is_doc()).copied().collect();
    let plain = " ".repeat(prefix(text)) + &text[prefix(text)..];
    let mut mender = Mender { tokens, plain, length: text.len(), problems: Vec::new(), omitted: Vec::new() };
    let mut balanced = false;
    for _ in 0..MOST {
        match mender.plain.parse::<TokenStream>() {
            Ok(tokens) => match syn::parse2(tokens) {
                Ok(file) => return (file, mender.problems, mender.omitted),
                Err(error) => mender.unexpected(&error),
            },
            Err(_) if !std::mem::replace(&mut balanced, true) => mender.brackets(),
            Err(error) => mender.unknown(error.span().byte_range().start),
        }
    }
    let file = File { shebang: None, frontmatter: None, attrs: Vec::new(), items: Vec::new() };
    (file, mender.problems, vec![Span::new(0, text.len())])
}

struct Mender<'a> {
    /// Tokens that are not omitted, and appended brackets.
    tokens: Vec<Token<'a>>,
    /// The text with spaces in place of omitted parts, and missing brackets after its end.
    plain: String,
    /// Length of the text.
    length: usize,
    problems: Vec<Problem>,
    omitted: Vec<Span>,
}

impl Mender<'_> {
    fn omit(&mut self, tokens: Range<usize>) {
        let omitted = &self.tokens[tokens.clone()];
        let (Some(first), Some(last)) = (omitted.first(), omitted.last()) else { return };
        let part = Span::new(first.span.start, last.span.end);
        self.plain.replace_range(part.range(), &" ".repeat(part.range().len()));
        self.omitted.push(part);
        self.tokens.drain(tokens);
    }

    fn report(&mut self, span: Span, message: String) {
        let Span { start, end } = span;
        let span = Span::new(start.min(self.length), end.min(self.length));
        self.problems.push(Problem::syntax(span, message));
    }

    /// Omits brackets without a partner, and closes open blocks.
    fn brackets(&mut self) {
        let (mut open, mut wrong) = (Vec::new(), Vec::new());
        for (index, token) in self.tokens.iter().enumerate() {
            if closing(token).is_some() {
                open.push(index);
            } else if is_closing(token) {
                // A closing brace also closes brackets within the braces; other closing brackets close no brace.
                let at = open.iter().rposition(|one| closing(&self.tokens[*one]) == Some(token.text));
                let is_within = |at: &usize| open[at + 1..].iter().all(|one| self.tokens[*one].text != "{");
                let at = at.filter(|at| token.text == "}" || is_within(at));
                wrong.extend(at.map_or_else(|| vec![index], |at| open.drain(at..).skip(1).collect()));
            }
        }
        for index in wrong.iter().chain(&open) {
            let token = self.tokens[*index];
            let what = if is_closing(&token) { "closes nothing" } else { "is never closed" };
            self.report(token.span, format!("this `{}` {what}", token.text));
        }
        let is_block =
            |index: &usize| self.tokens[*index].text == "{" && self.tokens[index.saturating_sub(1)].text != ":";
        let (blocks, others): (Vec<usize>, Vec<usize>) = open.into_iter().partition(is_block);
        wrong.extend(others);
        wrong.sort_unstable();
        wrong.into_iter().rev().for_each(|index| self.omit(index..index + 1));
        for _ in blocks {
            let span = Span::new(self.plain.len(), self.plain.len() + 1);
            self.tokens.push(Token { text: "}", kind: Kind::Mark, span });
            self.plain.push('}');
        }
    }

    /// Omits the invalid token at a place.
    fn unknown(&mut self, at: usize) {
        let token = self.tokens.partition_point(|token| token.span.end <= at);
        if let Some(Token { span, .. }) = self.tokens.get(token).copied() {
            self.report(span, "this is no token of Rust".to_owned());
            self.omit(token..token + 1);
        }
    }

    /// Omits the part between the separators around the position of a parser error. If that part is empty, it omits the content of the
    /// brackets around it, or else the brackets. In braces a closing brace ends a part.
    fn unexpected(&mut self, error: &syn::Error) {
        let range = error.span().byte_range();
        // An error at the end of the text has an empty range.
        let at = if range.is_empty() { self.plain.len() } else { range.start };
        self.report(Span::new(at, range.end.max(at)), error.to_string());
        let at = self.tokens.partition_point(|token| token.span.start < at);
        let pairs = self.pairs();
        let open = (0..at).rev().find(|open| pairs[*open].is_some_and(|close| close >= at));
        let within = open.map_or(0..self.tokens.len(), |open| open + 1..pairs[open].unwrap_or(open));
        let last = if open.is_none_or(|open| self.tokens[open].text == "{") { "}" } else { "," };
        let ends = |token: usize| [";", last].contains(&self.tokens[token].text);
        let mut part = at..at;
        while part.start > within.start && !ends(part.start - 1) {
            part.start = pairs[part.start - 1].unwrap_or(part.start - 1);
        }
        while part.end < within.end && (part.end == at || !ends(part.end - 1)) {
            part.end = pairs[part.end].unwrap_or(part.end) + 1;
        }
        let brackets = open.map_or(0..0, |open| open..within.end + 1);
        self.omit([part, within, brackets].into_iter().find(|tokens| !tokens.is_empty()).unwrap_or_default());
    }

    /// Returns the partner of each bracket.
    fn pairs(&self) -> Vec<Option<usize>> {
        let (mut pairs, mut open) = (vec![None; self.tokens.len()], Vec::new());
        for (index, token) in self.tokens.iter().enumerate() {
            if closing(token).is_some() {
                open.push(index);
            } else if let Some(first) = Some(token).filter(|token| is_closing(token)).and_then(|_| open.pop()) {
                (pairs[first], pairs[index]) = (Some(index), Some(first));
            }
        }
        pairs
    }
}

/// Returns the closing partner of a bracket.
fn closing(open: &Token<'_>) -> Option<&'static str> {
    [("(", ")"), ("[", "]"), ("{", "}")].iter().find(|(one, _)| *one == open.text).map(|(_, close)| *close)
}

fn is_closing(token: &Token<'_>) -> bool {
    matches!(token.text, ")" | "]" | "}")
}
