//! Circles between the modules of a package.

use std::collections::{BTreeMap, BTreeSet};

use crate::pages::Page;

/// Packages whose modules use each other in one direction. The macros of `bica-core` need its traits to name each other.
const LAYERED: [&str; 7] =
    ["bica-wire", "tools/app", "tools/link", "tools/monitor", "tools/recording", "tools/ros", "tools/vicode"];

/// Modules of a package's root, each with those that it uses.
type Uses = BTreeMap<String, BTreeSet<String>>;

/// Returns the packages with the modules that are in a circle or use one, and the number of modules that were read.
pub(crate) fn found(sources: &[Page]) -> (Vec<String>, usize) {
    let (mut circles, mut read) = (Vec::new(), 0);
    for package in LAYERED {
        let mut uses = uses(sources, &format!("{package}/src/"));
        read += uses.len();
        while let Some(last) = uses.iter().find_map(|(name, used)| used.is_empty().then(|| name.clone())) {
            uses.remove(&last);
            for used in uses.values_mut() {
                used.remove(&last);
            }
        }
        circles.extend((!uses.is_empty()).then(|| format!("{package}: {uses:?}")));
    }
    (circles, read)
}

fn uses(sources: &[Page], folder: &str) -> Uses {
    let parts = sources.iter().filter_map(|page| {
        let module = page.name.strip_prefix(folder)?.split('/').next()?.trim_end_matches(".rs");
        (!matches!(module, "lib" | "main")).then_some((module, page))
    });
    let mut uses = Uses::new();
    for (module, page) in parts {
        let code = page.text.lines().filter(|line| !line.trim_start().starts_with("//"));
        uses.entry(module.to_owned()).or_default().extend(code.flat_map(named).map(str::to_owned));
    }
    let names: BTreeSet<String> = uses.keys().cloned().collect();
    for (module, used) in &mut uses {
        used.retain(|name| name != module && names.contains(name));
    }
    uses
}

/// Returns what a line names in the root of its package: `a` in `crate::a::B`, `a` and `b` in `crate::{a, b}`.
fn named(line: &str) -> impl Iterator<Item = &str> {
    line.split("crate::").skip(1).flat_map(|rest| {
        let names = rest.strip_prefix('{').map_or(rest, |list| list.split('}').next().unwrap_or_default());
        let count = if rest.starts_with('{') { usize::MAX } else { 1 };
        names.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|name| !name.is_empty()).take(count)
    })
}
