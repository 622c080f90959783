//! Merge of edits in the document and changes of its file on disk.

use serde::Serialize;

use super::words::difference;
use crate::edit::{Splice, applied};
use crate::model::Span;
use crate::read::parse;

/// Two versions of a text whose changes overlap or meet.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Conflict {
    /// Common ancestor of both texts.
    pub base: String,
    /// Text of the document.
    pub ours: String,
    /// Text of the file.
    pub theirs: String,
    /// Parts of `base` that both versions changed.
    pub spans: Vec<Span>,
}

/// Merges two changes of one text.
///
/// # Errors
/// If both sides changed parts that overlap or meet, but not to the same text, or if the result has more syntax errors than either side.
pub(super) fn merge(base: &str, ours: &str, theirs: &str) -> Result<String, Conflict> {
    if ours == theirs || base == theirs {
        return Ok(ours.to_owned());
    }
    if base == ours {
        return Ok(theirs.to_owned());
    }
    let (here, there) = (difference(base, ours), difference(base, theirs));
    let conflict = |spans| {
        let (base, ours, theirs) = (base.to_owned(), ours.to_owned(), theirs.to_owned());
        Err(Conflict { base, ours, theirs, spans })
    };
    let mut spans = Vec::new();
    let mut all = here.clone();
    for splice in there.into_iter().filter(|splice| !here.contains(splice)) {
        for other in here.iter().filter(|other| touch(other, &splice)) {
            spans.push(Span::new(other.span.start.min(splice.span.start), other.span.end.max(splice.span.end)));
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
    Ok(merged)
}

/// Returns whether two changes overlap or meet.
const fn touch(one: &Splice, other: &Splice) -> bool {
    one.span.start <= other.span.end && other.span.start <= one.span.end
}

fn mistakes(text: &str) -> usize {
    parse(text).map_or(1, |source| source.problems.len())
}
