//! Difference of two texts, by functions, lines and words.

use std::time::Duration;

use similar::{Algorithm, DiffOp, DiffTag};

use crate::edit::Splice;
use crate::model::Span;
use crate::read::landmarks;

/// Time limit of the search for the shortest difference.
const LIMIT: Duration = Duration::from_millis(200);

/// Returns the splices that turn one text into another.
///
/// Functions of the same name are compared with each other, so that a copy of a function is not mistaken for the function. Within a
/// function, and between functions, lines are compared, then words within the lines that differ.
pub(super) fn difference(from: &str, to: &str) -> Vec<Splice> {
    let (old, new) = (parts(from), parts(to));
    let key = |part: &Part| part.key.clone();
    let (old_keys, new_keys): (Vec<String>, Vec<String>) =
        (old.iter().map(key).collect(), new.iter().map(key).collect());
    let old_keys: Vec<&str> = old_keys.iter().map(String::as_str).collect();
    let new_keys: Vec<&str> = new_keys.iter().map(String::as_str).collect();
    let deadline = std::time::Instant::now().checked_add(LIMIT);
    let around = |parts: &[Part], range: std::ops::Range<usize>, end: usize| {
        let start = parts.get(range.start).map_or(end, |part| part.span.start);
        Span::new(start, if range.is_empty() { start } else { parts[range.end - 1].span.end })
    };
    let mut splices = Vec::new();
    for op in similar::capture_diff_slices_deadline(Algorithm::Patience, &old_keys, &new_keys, deadline) {
        let (these, those) = (op.old_range(), op.new_range());
        if op.tag() == DiffTag::Equal {
            for (one, other) in these.zip(those) {
                let (one, other) = (old[one].span, new[other].span);
                splices.extend(lines(one.start, one.of(from), other.of(to)));
            }
        } else {
            let (one, other) = (around(&old, these, from.len()), around(&new, those, to.len()));
            splices.extend(lines(one.start, one.of(from), other.of(to)));
        }
    }
    splices
}

/// A function, or the text between two functions.
struct Part {
    /// Name of the function, or text between functions.
    key: String,
    span: Span,
}

fn parts(text: &str) -> Vec<Part> {
    let mut parts = Vec::new();
    let mut at = 0;
    for (name, span) in landmarks(text) {
        if at < span.start {
            parts.push(Part { key: text[at..span.start].to_owned(), span: Span::new(at, span.start) });
        }
        parts.push(Part { key: format!("\0{name}"), span });
        at = span.end;
    }
    if at < text.len() {
        parts.push(Part { key: text[at..].to_owned(), span: Span::new(at, text.len()) });
    }
    parts
}

/// Returns the splices between two parts, the first of which begins at offset `at`.
fn lines(at: usize, from: &str, to: &str) -> Vec<Splice> {
    if from == to {
        return Vec::new();
    }
    let (old, new): (Vec<&str>, Vec<&str>) = (from.split_inclusive('\n').collect(), to.split_inclusive('\n').collect());
    let (old_at, new_at) = (offsets(&old), offsets(&new));
    let mut splices = Vec::new();
    for op in changes(&old, &new) {
        let (lines, others) = (op.old_range(), op.new_range());
        let part = &from[old_at[lines.start]..old_at[lines.end]];
        let other = &to[new_at[others.start]..new_at[others.end]];
        splices.extend(within(at + old_at[lines.start], part, other));
    }
    splices
}

/// Returns the splices between two texts without a common line, the first of which begins at offset `at`.
fn within(at: usize, from: &str, to: &str) -> Vec<Splice> {
    let (old, new) = (words(from), words(to));
    let (old_at, new_at) = (offsets(&old), offsets(&new));
    let splice = |op: DiffOp| {
        let (words, others) = (op.old_range(), op.new_range());
        let span = Span::new(at + old_at[words.start], at + old_at[words.end]);
        Splice::new(span, &to[new_at[others.start]..new_at[others.end]])
    };
    changes(&old, &new).into_iter().map(splice).collect()
}

fn changes(old: &[&str], new: &[&str]) -> Vec<DiffOp> {
    let deadline = std::time::Instant::now().checked_add(LIMIT);
    let ops = similar::capture_diff_slices_deadline(Algorithm::Patience, old, new, deadline);
    ops.into_iter().filter(|op| op.tag() != DiffTag::Equal).collect()
}

/// Returns the offset of each part, and of the end.
fn offsets(parts: &[&str]) -> Vec<usize> {
    let mut at = 0;
    let mut offsets = vec![0];
    for part in parts {
        at += part.len();
        offsets.push(at);
    }
    offsets
}

/// Splits a text into names and numbers, runs of white space, and single other characters.
fn words(text: &str) -> Vec<&str> {
    let class = |character: char| match character {
        '\n' => 0,
        _ if character.is_whitespace() => 1,
        _ if character.is_alphanumeric() || character == '_' => 2,
        _ => 3,
    };
    let mut words = Vec::new();
    let mut start = 0;
    let mut before = None;
    for (at, character) in text.char_indices() {
        let kind = class(character);
        if before.is_some_and(|before| before != kind || kind == 3 || kind == 0) {
            words.push(&text[start..at]);
            start = at;
        }
        before = Some(kind);
    }
    if start < text.len() {
        words.push(&text[start..]);
    }
    words
}
