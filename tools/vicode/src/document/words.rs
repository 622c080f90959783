//! The difference of two texts, by words.

use std::time::Duration;

use similar::{Algorithm, DiffOp, DiffTag};

use crate::edit::Splice;
use crate::model::Span;

/// Longest search for the shortest difference; a longer one is taken then.
const LIMIT: Duration = Duration::from_millis(200);

/// The splices that lead from one text to another: first by lines, then by words within the lines that differ.
#[must_use]
pub fn difference(from: &str, to: &str) -> Vec<Splice> {
    let (old, new): (Vec<&str>, Vec<&str>) = (from.split_inclusive('\n').collect(), to.split_inclusive('\n').collect());
    let (old_at, new_at) = (offsets(&old), offsets(&new));
    let mut splices = Vec::new();
    for op in changes(&old, &new) {
        let (lines, others) = (op.old_range(), op.new_range());
        let part = &from[old_at[lines.start]..old_at[lines.end]];
        let other = &to[new_at[others.start]..new_at[others.end]];
        splices.extend(within(old_at[lines.start], part, other));
    }
    splices
}

/// The difference of two texts that have no line in common, the first at offset `at`.
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

/// Offset of each part, and of the end.
fn offsets(parts: &[&str]) -> Vec<usize> {
    let mut at = 0;
    let mut offsets = vec![0];
    for part in parts {
        at += part.len();
        offsets.push(at);
    }
    offsets
}

/// Names and numbers, runs of white space, and single other characters.
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
