//! Tune files as text.

use std::borrow::Cow;
use std::fs::{self, File};
use std::io::{ErrorKind, Write as _};
use std::path::Path;

use bica_wire::model::{Invalid, Kind, Param};

use crate::comments::{Comments, GENERATED};
use crate::layers::{Layers, Value};

/// First line of a tune file.
const TITLE: &str = "# Parameters that differ from the defaults of the source.";

/// Returns the tune file of all values that differ from the defaults of the source: sections and lines sorted by name, with
/// description, default and range as comments.
#[must_use]
pub fn render(layers: &Layers) -> String {
    render_over(layers, "")
}

/// As [`render`], with the comments that a person wrote in the `old` file. Comments of values that are no longer in the file are
/// its last lines.
fn render_over(layers: &Layers, old: &str) -> String {
    let mut values: Vec<_> = layers.all().filter(|value| !value.is_default()).collect();
    values.sort_by_key(|Value { component, param, .. }| (&component.name, &param.name));
    let mut comments = Comments::read(old);
    let mut lines = vec![TITLE.to_owned()];
    lines.extend(comments.take("", "", &lines));
    let mut section = "";
    for value in values {
        let Value { component, param, .. } = value;
        if section != component.name {
            section = &component.name;
            lines.push(String::new());
            lines.extend(comments.take(section, "", &[]));
            lines.push(format!("[{}]", key(section)));
        }
        let doc = doc(param);
        lines.extend(comments.take(section, &param.name, &doc));
        lines.extend(doc);
        let text = match param.kind {
            Kind::Choice { .. } => format!("\"{}\"", value.text()),
            _ => value.text(),
        };
        lines.push(format!("{} = {text} {GENERATED}{}", key(&param.name), describe(param)));
    }
    let mut rest = Vec::new();
    for Value { component, param, .. } in layers.all() {
        rest.extend(comments.take(&component.name, &param.name, &doc(param)));
    }
    rest.extend(comments.rest());
    if !rest.is_empty() {
        lines.push(String::new());
        lines.extend(rest);
    }
    lines.join("\n") + "\n"
}

/// Returns a name as a key of TOML: in quotes if it has letters or signs that a bare key must not have, as `größe` or `Filter<3>`.
#[must_use]
pub fn key(name: &str) -> Cow<'_, str> {
    let is_bare = |letter: char| letter.is_ascii_alphanumeric() || matches!(letter, '_' | '-');
    if name.chars().all(is_bare) { Cow::Borrowed(name) } else { Cow::Owned(format!("\"{name}\"")) }
}

/// Writes a tune file; another program never reads a part of it, and after a failure an old file is unchanged. The comments that
/// a person wrote in the old file are kept.
///
/// # Errors
/// If the file exists and is not to be replaced, or cannot be read or written.
pub fn write(layers: &Layers, path: &Path, replace: bool) -> Result<(), Invalid> {
    let failed = |error: std::io::Error| {
        Invalid::new(format!("cannot write `{}`: {error}", path.display()), "name a file in a folder that exists")
    };
    let old = match fs::read_to_string(path) {
        Ok(_) if !replace => return Err(Invalid::new(format!("`{}` exists", path.display()), "--force replaces it")),
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
        // The user needs the error of the write, not of the removal.
        let _ = fs::remove_file(&temporary);
    }
    result.map_err(failed)
}

/// Returns the description of a parameter as comments.
fn doc(param: &Param) -> Vec<String> {
    param.doc.lines().map(|line| format!("# {}", line.trim())).collect()
}

/// Returns default, range and unit.
fn describe(param: &Param) -> String {
    let unit = param.unit.as_deref().map(|unit| format!(" {unit}")).unwrap_or_default();
    let (default, values) = (param.kind.text(param.default), param.range());
    match param.kind {
        Kind::Choice { .. } => format!("{default}, one of {values}"),
        Kind::Bool => default.to_string(),
        _ => format!("{default}, {values}{unit}"),
    }
}
