//! Tune files as text.

use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::Write as _;
use std::path::Path;

use bica::params::{Kind, Param};
use bica_console::Failure;

use crate::layers::{Layers, Value};
use crate::names::range;

/// Returns the tune file of all values that differ from the defaults of the source: sections and lines sorted by name, with
/// description, default and range as comments.
#[must_use]
pub fn render(layers: &Layers) -> String {
    let mut values: Vec<_> = layers.all().filter(|value| value.value != value.place.param.default).collect();
    values.sort_by_key(|Value { place, .. }| (place.node.name, place.param.name));
    let mut text = "# Parameters that differ from the defaults of the source.\n".to_owned();
    let mut section = "";
    for Value { place, value, .. } in values {
        if section != place.node.name {
            section = place.node.name;
            // Writing to a string cannot fail.
            let _ = writeln!(text, "\n[{section}]");
        }
        for line in place.param.doc.lines() {
            let _ = writeln!(text, "# {}", line.trim());
        }
        let value = toml_value(place.param, value);
        let _ = writeln!(text, "{} = {value} # {}", place.param.name, describe(place.param));
    }
    text
}

/// Writes a tune file; another program never sees a part of it, and a failure leaves an old file as it was.
///
/// # Errors
/// If the file exists and is not to be replaced, or cannot be written.
pub fn write(layers: &Layers, path: &Path, replace: bool) -> Result<(), Failure> {
    let failed = |error: std::io::Error| Failure::of_path("write", path, &error, "name a file in a folder that exists");
    if !replace && path.exists() {
        return Err(Failure::new(format!("`{}` exists", path.display()), "--force replaces it"));
    }
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let temporary = path.with_file_name(format!(".{name}.{}", std::process::id()));
    let result = File::create_new(&temporary).and_then(|mut file| {
        file.write_all(render(layers).as_bytes())?;
        file.sync_all()?;
        fs::rename(&temporary, path)
    });
    if result.is_err() {
        // The failure of the writing is what the user has to know.
        let _ = fs::remove_file(&temporary);
    }
    result.map_err(failed)
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
        Kind::Choice { .. } => format!("default {default}, one of {values}"),
        Kind::Bool => format!("default {default}"),
        _ => format!("default {default}, {values}{unit}"),
    }
}
