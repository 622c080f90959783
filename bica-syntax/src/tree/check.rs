//! The rules that the text of a tree can break.

use proc_macro2::Ident;
use quote::ToTokens;

use super::model::{Draft, Entry, RoleEntry, Tree};
use crate::report::Report;
use crate::{text, wording};

/// Largest number of roles of a tree, as in the description of the tree.
const MOST_ROLES: usize = 16;

/// The tree, or `None` with mistakes reported.
pub fn check(draft: &Draft, report: &mut Report) -> Option<Tree> {
    if draft.names_a_component() {
        report.add(&draft.name, wording::tree_of_a_component(&text::name(&draft.name)));
        return None;
    }
    let roles = roles(&draft.roles, report);
    let components = draft.components.as_ref().map(|entries| distinct(entries, &draft.name, report));
    // After an error of the parser nothing is missing: it was not read.
    if report.is_empty() {
        let gaps = [
            (draft.root.is_none(), "root", "Name"),
            (draft.cycle_hz.is_none(), "cycle_hz", "100"),
            (components.is_none(), "components", "[Name]"),
        ];
        for (_, key, example) in gaps.into_iter().filter(|(missing, ..)| *missing) {
            report.add(&draft.name, wording::missing(key, example));
        }
        if components.as_ref().is_some_and(Vec::is_empty) {
            report.add(&draft.name, wording::EMPTY_TREE);
        }
    }
    if !report.is_empty() {
        return None;
    }
    Some(Tree {
        attributes: draft.attributes.clone(),
        visibility: draft.visibility.clone(),
        name: draft.name.clone(),
        root: draft.root.clone()?,
        cycle_hz: draft.cycle_hz?,
        budget_ms: draft.budget_ms,
        tunable: draft.tunable,
        components: components?,
        roles,
        krate: draft.krate.clone(),
    })
}

/// Each role once. Two paths to one trait are left to the compiler.
fn roles(roles: &[RoleEntry], report: &mut Report) -> Vec<RoleEntry> {
    let mut distinct: Vec<RoleEntry> = Vec::new();
    for entry in roles {
        let name = text::written(&entry.role);
        if distinct.iter().any(|known| text::written(&known.role) == name) {
            report.add(&entry.role, wording::role_listed_twice(&name));
        } else if distinct.len() == MOST_ROLES {
            report.add(&entry.role, wording::TOO_MANY_ROLES);
            break;
        } else {
            distinct.push(entry.clone());
        }
    }
    distinct
}

/// The message about a type that is listed a second time: who gives it a second name wants two components.
fn twice(kind: &str, first: &Entry, second: &Entry) -> String {
    if first.name.is_none() && second.name.is_none() {
        return wording::listed_twice(kind);
    }
    wording::kind_listed_twice(kind, &first.label(), &second.label())
}

/// Each component and each name once. Two paths to one type are left to the compiler.
fn distinct(components: &[Entry], tree: &Ident, report: &mut Report) -> Vec<Entry> {
    let mut distinct: Vec<Entry> = Vec::new();
    for entry in components {
        let (kind, name) = (text::written(&entry.kind), entry.label());
        let known =
            |text: &dyn Fn(&Entry) -> String, of: &str| distinct.iter().find(|known| text(known) == of).cloned();
        if kind == text::name(tree) || kind == "Self" {
            report.add(&entry.kind, wording::TREE_IN_ITSELF);
        } else if let Some(first) = known(&|known| text::written(&known.kind), &kind) {
            report.add(&entry.kind, twice(&kind, &first, entry));
        } else if known(&Entry::label, &name).is_some() {
            report.add(entry.name.to_token_stream(), wording::named_twice(&name));
        } else {
            distinct.push(entry.clone());
        }
    }
    distinct
}
