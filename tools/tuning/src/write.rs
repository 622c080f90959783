//! Tune files as text.

use std::fs::{self, File};
use std::io::{ErrorKind, Write as _};
use std::path::Path;

use bica::params::{Kind, Param};
use bica_console::Failure;

use crate::comments::{Comments, GENERATED};
use crate::layers::{Layers, Value};
use crate::names::{Place, range};

/// First line of a tune file.
const TITLE: &str = "# Parameters that differ from the defaults of the source.";

/// Returns the tune file of all values that differ from the defaults of the source: sections and lines sorted by name, with
/// description, default and range as comments.
#[must_use]
pub fn render(layers: &Layers) -> String {
    render_over(layers, "")
}

/// As [`render`], with the comments that a person wrote in the `old` file. Those of values that it has no more are its last lines.
fn render_over(layers: &Layers, old: &str) -> String {
    let mut values: Vec<_> = layers.all().filter(|value| value.value != value.place.param.default).collect();
    values.sort_by_key(|Value { place, .. }| (place.node.name, place.param.name));
    let mut comments = Comments::read(old);
    let mut lines = vec![TITLE.to_owned()];
    lines.extend(comments.take("", "", &lines));
    let mut section = "";
    for Value { place, value, .. } in values {
        if section != place.node.name {
            section = place.node.name;
            lines.push(String::new());
            lines.extend(comments.take(section, "", &[]));
            lines.push(format!("[{section}]"));
        }
        let doc = doc(place.param);
        lines.extend(comments.take(section, place.param.name, &doc));
        lines.extend(doc);
        let value = toml_value(place.param, value);
        lines.push(format!("{} = {value} {GENERATED}{}", place.param.name, describe(place.param)));
    }
    let mut rest = Vec::new();
    for place in Place::all(layers.graph()) {
        rest.extend(comments.take(place.node.name, place.param.name, &doc(place.param)));
    }
    rest.extend(comments.rest());
    if !rest.is_empty() {
        lines.push(String::new());
        lines.extend(rest);
    }
    lines.join("\n") + "\n"
}

/// Writes a tune file; another program never sees a part of it, and a failure leaves an old file as it was. The comments that a person
/// wrote in the old file are kept.
///
/// # Errors
/// If the file exists and is not to be replaced, or cannot be read or written.
pub fn write(layers: &Layers, path: &Path, replace: bool) -> Result<(), Failure> {
    let failed = |error: std::io::Error| Failure::of_path("write", path, &error, "name a file in a folder that exists");
    let old = match fs::read_to_string(path) {
        Ok(_) if !replace => return Err(Failure::new(format!("`{}` exists", path.display()), "--force replaces it")),
        Err(error) if error.kind() != ErrorKind::NotFound => return Err(failed(error)),
        old => old.unwrap_or_default(),
    };
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let temporary = path.with_file_name(format!(".{name}.{}", std::process::id()));
    let result = File::create_new(&temporary).and_then(|mut file| {
        file.write_all(render_over(layers, &old).as_bytes())?;
        file.sync_all()?;
        fs::rename(&temporary, path)
    });
    if result.is_err() {
        // The failure of the writing is what the user has to know.
        let _ = fs::remove_file(&temporary);
    }
    result.map_err(failed)
}

/// Returns the description of a parameter as comments.
fn doc(param: &Param) -> Vec<String> {
    param.doc.lines().map(|line| format!("# {}", line.trim())).collect()
}

fn toml_value(param: &Param, value: bica::Value) -> String {
    let text = param.kind.text(value);
    match param.kind {
        Kind::Choice { .. } => format!("\"{text}\""),
        _ => text.to_string(),
    }
}

/// Returns default, range and unit.
fn describe(param: &Param) -> String {
    let unit = param.unit.map(|unit| format!(" {unit}")).unwrap_or_default();
    let default = param.kind.text(param.default);
    let values = range(&param.kind);
    match param.kind {
        Kind::Choice { .. } => format!("{default}, one of {values}"),
        Kind::Bool => default.to_string(),
        _ => format!("{default}, {values}{unit}"),
    }
}
