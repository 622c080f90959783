//! Comparisons as text.

use std::fmt::Write;

use similar::{ChangeTag, TextDiff};

use super::{Change, Comparison, Detail, PartChange};

/// Formats a comparison for a terminal; empty without differences.
#[must_use]
pub fn report(comparison: &Comparison) -> String {
    let mut out = String::new();
    for component in &comparison.components {
        let sign =
            if component.change == Change::Changed { String::new() } else { format!("{} ", component.change.sign()) };
        line(&mut out, 0, &format!("{sign}{}", component.key));
        for part in component.parts.iter().filter(|part| part.part != "component" || !part.details.is_empty()) {
            of_part(&mut out, part);
        }
    }
    if !comparison.parameters.is_empty() {
        line(&mut out, 0, "parameters");
        comparison.parameters.iter().for_each(|part| of_part(&mut out, part));
    }
    if !comparison.is_empty() {
        line(&mut out, 0, &comparison.summary());
    }
    out
}

fn of_part(out: &mut String, part: &PartChange) {
    line(out, 1, &format!("{} {} {}", part.change.sign(), part.part, part.name));
    // Docs and code of added and removed parts are omitted: they are in the file.
    let is_short = |one: &&Detail| part.change == Change::Changed || (one.what != "docs" && one.what != "code");
    part.details.iter().filter(is_short).for_each(|one| of_detail(out, one));
}

fn of_detail(out: &mut String, Detail { what, before, after }: &Detail) {
    let (old, new) = (before.as_deref().unwrap_or_default(), after.as_deref().unwrap_or_default());
    let is_code = what == "condition" || what == "code" || what == "docs";
    match (before, after) {
        _ if is_code || old.contains('\n') || new.contains('\n') => {
            line(out, 3, what);
            for change in TextDiff::from_lines(format!("{old}\n"), format!("{new}\n")).iter_all_changes() {
                let sign = match change.tag() {
                    ChangeTag::Equal => ' ',
                    ChangeTag::Delete => '-',
                    ChangeTag::Insert => '+',
                };
                let text = change.value().trim_end();
                if !text.is_empty() {
                    line(out, 4, &format!("{sign} {text}"));
                }
            }
        }
        (Some(old), Some(new)) if old.contains(" | ") || new.contains(" | ") => {
            line(out, 3, &format!("{what}: {}", names(old, new)));
        }
        (Some(old), Some(new)) => line(out, 3, &format!("{what}: {old} -> {new}")),
        (Some(old), None) => line(out, 3, &format!("- {what}: {old}")),
        (None, _) => line(out, 3, &format!("+ {what}: {new}")),
    }
}

/// Formats the difference of two lists of names: `+ wait, - dribble`.
fn names(old: &str, new: &str) -> String {
    let split = |text: &'_ str| text.split(" | ").map(str::to_owned).collect::<Vec<_>>();
    let (old, new) = (split(old), split(new));
    let added = new.iter().filter(|name| !old.contains(name)).map(|name| format!("+ {name}"));
    let removed = old.iter().filter(|name| !new.contains(name)).map(|name| format!("- {name}"));
    added.chain(removed).collect::<Vec<_>>().join(", ")
}

fn line(out: &mut String, indent: usize, text: &str) {
    writeln!(out, "{}{text}", "  ".repeat(indent)).unwrap_or_default();
}
