//! `vicode diff`

use std::io::Write;
use std::path::Path;

use super::draw::{layout, write};
use super::{print, print_json, text_of};
use crate::compare::{ComponentChange, Version, committed, compare, report, union};
use crate::draw::{Diagram, svg};
use crate::model::Model;

/// Outputs of a comparison beside its text.
pub(super) struct Output<'a> {
    pub(super) svg: Option<&'a Path>,
    pub(super) json: bool,
}

/// Prints the comparison; returns whether the versions are equal.
pub(super) fn run(
    file: &Path,
    other: Option<&Path>,
    component: Option<&str>,
    output: &Output<'_>,
    out: &mut dyn Write,
) -> Result<bool, String> {
    let second = other.unwrap_or(file);
    let after = text_of(second)?;
    let before = match other {
        Some(_) => text_of(file)?,
        None => committed(file)?.text.unwrap_or_default(),
    };
    let (old, new) = (crate::read(&before), crate::read(&after));
    let mut comparison = compare(Version { text: &before, model: &old }, Version { text: &after, model: &new });
    if let Some(name) = component {
        if old.component(name).or_else(|| new.component(name)).is_none() {
            return Err(format!("no component `{name}` is in either version"));
        }
        comparison.components.retain(|one| one.key == name);
        comparison.parameters.clear();
    }
    let text = report(&comparison);
    if let Some(path) = output.svg {
        let drawn = chosen(&comparison.components, [&old, &new])?;
        write(path, &svg(&drawing(drawn, [&old, &new], &layout(second)?, &text)))?;
    }
    if output.json {
        print_json(out, &comparison)?;
    } else {
        print(out, &text)?;
    }
    Ok(comparison.is_empty())
}

/// Returns the only machine with a difference.
fn chosen<'a>(changes: &'a [ComponentChange], versions: [&Model; 2]) -> Result<&'a ComponentChange, String> {
    let is_machine = |one: &&ComponentChange| {
        versions.iter().any(|model| model.component(&one.key).is_some_and(crate::model::Component::is_machine))
    };
    let machines: Vec<_> = changes.iter().filter(is_machine).collect();
    match machines[..] {
        [one] => Ok(one),
        [] => Err("nothing can be drawn: no state machine has a difference".to_owned()),
        _ => {
            let names: Vec<_> = machines.iter().map(|one| format!("`{}`", one.key)).collect();
            Err(format!("several machines have a difference: choose one by `--component`, {}", names.join(", ")))
        }
    }
}

fn drawing(change: &ComponentChange, [old, new]: [&Model; 2], layout: &crate::Layout, notes: &str) -> Diagram {
    let both = match (old.component(&change.key), new.component(&change.key)) {
        (Some(old), Some(new)) => union(old, new),
        (old, new) => new.or(old).cloned().unwrap_or_default(),
    };
    Diagram::of_difference(&both, layout, &change.marks, notes)
}
