//! Edits on both sides: here, and in the file on disk.

use serde::Serialize;

use super::words::difference;
use crate::edit::{Splice, applied};
use crate::model::{Reporter, Span};
use crate::read::read;

/// Both sides' changes in one text, or why not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Merged {
    /// The text with the changes of both.
    Clean(String),
    /// Both changed the same part.
    Conflict(Conflict),
}

/// Two texts whose changes touch each other.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Conflict {
    /// The text that both began with.
    pub base: String,
    /// The text here.
    pub ours: String,
    /// The text of the file.
    pub theirs: String,
    /// The parts of `base` that both changed.
    pub spans: Vec<Span>,
}

/// Merges two changes of one text.
///
/// Changes that touch different parts are both taken. Parts that overlap or meet are a conflict, unless both sides changed them to
/// the same. So is a result that is worse Rust than both sides.
#[must_use]
pub fn merge(base: &str, ours: &str, theirs: &str) -> Merged {
    if ours == theirs || base == theirs {
        return Merged::Clean(ours.to_owned());
    }
    if base == ours {
        return Merged::Clean(theirs.to_owned());
    }
    let (here, there) = (difference(base, ours), difference(base, theirs));
    let conflict = |spans| {
        let (base, ours, theirs) = (base.to_owned(), ours.to_owned(), theirs.to_owned());
        Merged::Conflict(Conflict { base, ours, theirs, spans })
    };
    let mut spans = Vec::new();
    let mut all = here.clone();
    for splice in there {
        if here.contains(&splice) {
            continue;
        }
        for other in here.iter().filter(|other| touch(other, &splice)) {
            let span = Span::new(other.span.start.min(splice.span.start), other.span.end.max(splice.span.end));
            spans.push(span);
        }
        all.push(splice);
    }
    if !spans.is_empty() {
        return conflict(spans);
    }
    all.sort_by_key(|splice| splice.span.start);
    let merged = applied(base, &all);
    if mistakes(&merged) > mistakes(ours).max(mistakes(theirs)) {
        return conflict(all.iter().map(|splice| splice.span).collect());
    }
    Merged::Clean(merged)
}

/// Whether two changes overlap or meet.
const fn touch(one: &Splice, other: &Splice) -> bool {
    one.span.start <= other.span.end && other.span.start <= one.span.end
}

fn mistakes(text: &str) -> usize {
    read(text).problems.iter().filter(|problem| problem.from == Reporter::Syntax).count()
}
