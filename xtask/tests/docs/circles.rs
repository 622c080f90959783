//! Circles between the modules of a package, or of one of its folders.

use std::collections::{BTreeMap, BTreeSet};

use crate::pages::Page;

/// Folders whose modules use each other in one direction, and what precedes the name of a module there.
const LAYERED: [(&str, &[&str]); 8] = [
    ("bica-core/src/tree/", &["super::", "crate::tree::"]),
    ("bica-wire/src/", PACKAGE),
    ("tools/app/src/", PACKAGE),
    ("tools/link/src/", PACKAGE),
    ("tools/monitor/src/", PACKAGE),
    ("tools/recording/src/", PACKAGE),
    ("tools/ros/src/", PACKAGE),
    ("tools/vicode/src/", PACKAGE),
];
const PACKAGE: &[&str] = &["crate::"];

/// Modules of a folder, each with those that it uses.
type Uses = BTreeMap<String, BTreeSet<String>>;

/// Returns the folders with the modules that are in a circle or use one, and the number of modules that were read.
pub(crate) fn found(sources: &[Page]) -> (Vec<String>, usize) {
    let (mut circles, mut read) = (Vec::new(), 0);
    for (folder, before) in LAYERED {
        let mut uses = uses(sources, folder, before);
        read += uses.len();
        while let Some(last) = uses.iter().find_map(|(name, used)| used.is_empty().then(|| name.clone())) {
            uses.remove(&last);
            for used in uses.values_mut() {
                used.remove(&last);
            }
        }
        circles.extend((!uses.is_empty()).then(|| format!("{folder}: {uses:?}")));
    }
    (circles, read)
}

fn uses(sources: &[Page], folder: &str, before: &[&str]) -> Uses {
    let parts = sources.iter().filter_map(|page| {
        let module = page.name.strip_prefix(folder)?.split('/').next()?.trim_end_matches(".rs");
        (!matches!(module, "lib" | "main")).then_some((module, page))
    });
    let mut uses = Uses::new();
    for (module, page) in parts {
        let code = page.text.lines().filter(|line| !line.trim_start().starts_with("//"));
        let found = code.flat_map(|line| before.iter().flat_map(move |before| named(line, before)));
        uses.entry(module.to_owned()).or_default().extend(found.map(str::to_owned));
    }
    let names: BTreeSet<String> = uses.keys().cloned().collect();
    for (module, used) in &mut uses {
        used.retain(|name| name != module && names.contains(name));
    }
    uses
}

/// Returns what a line names after a path such as `crate::`: `a` in `crate::a::B`, `a` and `b` in `crate::{a, b}`.
fn named<'a>(line: &'a str, before: &str) -> impl Iterator<Item = &'a str> {
    line.split(before).skip(1).flat_map(|rest| {
        let names = rest.strip_prefix('{').map_or(rest, |list| list.split('}').next().unwrap_or_default());
        let count = if rest.starts_with('{') { usize::MAX } else { 1 };
        names.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|name| !name.is_empty()).take(count)
    })
}
