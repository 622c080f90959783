//! The rules that the text of a tree can break.

use super::model::{Draft, Entry, Tree};
use crate::language::report::Report;
use crate::language::{text, wording};

/// The tree, or `None` if there is too little to generate one.
pub(crate) fn check(draft: Draft, report: &mut Report) -> Option<Tree> {
    let Draft { attributes, visibility, name, root, cycle_hz, budget_ms, components, krate } = draft;
    // Behind an error of the parser nothing is missing: it was not read.
    if report.is_empty() {
        let gaps = [
            (root.is_none(), "root", "Name"),
            (cycle_hz.is_none(), "cycle_hz", "100"),
            (components.is_none(), "components", "[Name]"),
        ];
        for (_, key, example) in gaps.into_iter().filter(|(missing, ..)| *missing) {
            report.add(&name, wording::missing(key, example));
        }
    }
    let components = distinct(components?, report);
    if components.is_empty() {
        report.add(&name, wording::EMPTY_TREE);
        return None;
    }
    let root = match &root {
        Some(root) => place(root, &components).unwrap_or_else(|| {
            report.add(root, wording::root_not_listed(&text::written(root)));
            0
        }),
        None => 0,
    };
    let cycle_hz = cycle_hz.unwrap_or(f32::MAX);
    Some(Tree { attributes, visibility, name, root, cycle_hz, budget_ms, components, krate })
}

fn place(kind: &syn::Type, components: &[Entry]) -> Option<usize> {
    let name = text::written(kind);
    components.iter().position(|entry| text::written(&entry.kind) == name)
}

/// Each component once.
fn distinct(components: Vec<Entry>, report: &mut Report) -> Vec<Entry> {
    let mut distinct: Vec<Entry> = Vec::new();
    for entry in components {
        if place(&entry.kind, &distinct).is_some() {
            report.add(&entry.kind, wording::listed_twice(&text::written(&entry.kind)));
        } else {
            distinct.push(entry);
        }
    }
    distinct
}
