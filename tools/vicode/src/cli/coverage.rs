//! `vicode coverage`

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use bica_recording::Recording;

use super::draw::chosen;
use super::{print, print_json, text_of};
use crate::coverage::{Coverage, Visits};

/// Format of the printed coverage.
#[derive(Clone, Copy)]
pub(super) enum Form {
    Table,
    Line,
    Json,
}

pub(super) fn run(
    file: &Path,
    recordings: &[PathBuf],
    component: Option<&str>,
    form: Form,
    out: &mut dyn Write,
) -> Result<bool, String> {
    let model = crate::read(&text_of(file)?);
    let component = chosen(&model, component)?;
    let mut visits = Visits::default();
    for path in recordings {
        let add = if path.is_dir() { add_tests } else { add };
        add(&mut visits, path, &component.name.text).map_err(|error| format!("`{}`: {error}", path.display()))?;
    }
    let coverage = Coverage::of(component, &visits);
    match form {
        Form::Table => print(out, &coverage.to_string())?,
        Form::Line => print(out, &(coverage.summary() + "\n"))?,
        Form::Json => print_json(out, &coverage)?,
    }
    Ok(true)
}

/// Adds a recording; if it is truncated, all readable cycles.
fn add(visits: &mut Visits, path: &Path, component: &str) -> Result<(), String> {
    let mut recording = Recording::open(path).map_err(|error| error.to_string())?.without_blobs();
    let header = recording.header().clone();
    let names: Vec<&str> = header.tree.components.iter().map(|one| base(one.type_name())).collect();
    let all_of_it = names.iter().enumerate().filter(|(_, name)| **name == base(component));
    let mut runs: Vec<(usize, Samples<'_>)> = all_of_it.map(|(index, _)| (index, Vec::new())).collect();
    if runs.is_empty() {
        return Err(format!("its robot has no component `{component}`; it has {}", names.join(", ")));
    }
    while let Some(cycle) = recording.next_cycle().map_err(|error| error.to_string())? {
        let time_us = header.nanoseconds(cycle.tick.instant) / 1000;
        for &mut (index, ref mut run) in &mut runs {
            let state = cycle.tree.is_active(index).then(|| header.tree.state(index, cycle.tree.state(index)));
            run.push((time_us, state.flatten()));
        }
    }
    for (_, run) in &runs {
        add_run(visits, run);
    }
    Ok(())
}

/// Time in µs and state of one component of a tree, in the order of time.
type Samples<'a> = Vec<(u64, Option<&'a str>)>;

fn add_run(visits: &mut Visits, run: &Samples<'_>) {
    visits.begin();
    for &(time_us, state) in run {
        visits.sample(time_us, state);
    }
}

/// Adds the files that tests wrote into a folder, except those of robots without the component.
fn add_tests(visits: &mut Visits, folder: &Path, component: &str) -> Result<(), String> {
    let mut is_known = false;
    for entry in fs::read_dir(folder).map_err(|error| error.to_string())? {
        let path = entry.map_err(|error| error.to_string())?.path();
        if path.extension().is_none_or(|extension| extension != "states") {
            continue;
        }
        let text = text_of(&path)?;
        let mut runs: BTreeMap<&str, Samples<'_>> = BTreeMap::new();
        for (index, line) in text.lines().enumerate() {
            let words: Vec<&str> = line.split('\t').collect();
            let parsed =
                if let [time, name, state] = words[..] { time.parse().ok().zip(Some((name, state))) } else { None };
            let (time_us, (name, state)) =
                parsed.ok_or_else(|| format!("line {} of `{}` is `{line}`", index + 1, path.display()))?;
            if base(name) == base(component) {
                runs.entry(name).or_default().push((time_us, (state != "-").then_some(state)));
            }
        }
        is_known |= !runs.is_empty();
        for run in runs.values() {
            add_run(visits, run);
        }
    }
    let help = "run them with the variable BICA_COVERAGE, and with the harness of bica";
    if is_known { Ok(()) } else { Err(format!("no test in it has run `{component}`: {help}")) }
}

fn base(name: &str) -> &str {
    name.split('<').next().unwrap_or_default()
}
