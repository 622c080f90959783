//! Replacements of parts of a text.

use serde::{Deserialize, Serialize};

use crate::model::Span;
use crate::read::{Kind, lexed};

/// Replacement of the part `span` of a text by `text`; all other bytes are kept.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Splice {
    /// Replaced part; empty for an insertion.
    pub span: Span,
    /// New text.
    pub text: String,
}

impl Splice {
    /// Creates a replacement.
    pub fn new(span: Span, text: impl Into<String>) -> Self {
        Self { span, text: text.into() }
    }

    /// Creates an insertion before the byte `at`.
    pub fn insert(at: usize, text: impl Into<String>) -> Self {
        Self::new(Span::at(at), text)
    }

    /// Creates a replacement that keeps the comments of the part, after the new text.
    pub(super) fn keeping_comments(text: &str, span: Span, new: impl Into<String>) -> Self {
        let tokens = lexed(span.of(text));
        let mut new = new.into();
        let is_removal = new.is_empty();
        for (index, token) in tokens.iter().enumerate().filter(|(_, token)| token.kind == Kind::Comment) {
            if !new.is_empty() && !new.ends_with(char::is_whitespace) {
                new.push(' ');
            }
            new.push_str(token.text);
            // The space after a line comment is kept: its line break ends the comment.
            if let Some(space) = tokens.get(index + 1).filter(|next| next.kind == Kind::Space) {
                new.push_str(space.text);
            }
        }
        let trimmed = new.trim_end_matches([' ', '\t']);
        if !is_removal && !trimmed.ends_with('\n') {
            new.truncate(trimmed.len());
        }
        Self::new(span, new)
    }

    /// Creates a removal.
    #[must_use]
    pub const fn remove(span: Span) -> Self {
        Self { span, text: String::new() }
    }
}

/// Sorts splices of one text and joins overlapping removals. Returns `None` if two contradict each other or do not fit
/// the text.
#[must_use]
pub fn ordered(text: &str, mut splices: Vec<Splice>) -> Option<Vec<Splice>> {
    splices.sort_by_key(|splice| (splice.span.start, splice.span.end));
    let mut ordered: Vec<Splice> = Vec::new();
    for splice in splices {
        let Span { start, end } = splice.span;
        if start > end || !text.is_char_boundary(start) || !text.is_char_boundary(end) {
            return None;
        }
        match ordered.last_mut() {
            Some(last) if start < last.span.end => {
                if !last.text.is_empty() || !splice.text.is_empty() {
                    return None;
                }
                last.span.end = last.span.end.max(end);
            }
            _ => ordered.push(splice),
        }
    }
    Some(ordered)
}

/// Applies ordered splices to a text.
#[must_use]
pub fn applied(text: &str, splices: &[Splice]) -> String {
    let mut result = String::with_capacity(text.len());
    let mut at = 0;
    for splice in splices {
        result.push_str(&text[at..splice.span.start]);
        result.push_str(&splice.text);
        at = splice.span.end;
    }
    result.push_str(&text[at..]);
    result
}

/// Returns the splices that undo `splices` of `text`.
#[must_use]
pub fn inverse(text: &str, splices: &[Splice]) -> Vec<Splice> {
    let mut inverse = Vec::with_capacity(splices.len());
    let (mut grown, mut shrunk) = (0, 0);
    for splice in splices {
        let start = splice.span.start + grown - shrunk;
        inverse.push(Splice::new(Span::new(start, start + splice.text.len()), splice.span.of(text)));
        grown += splice.text.len();
        shrunk += splice.span.end - splice.span.start;
    }
    inverse
}
