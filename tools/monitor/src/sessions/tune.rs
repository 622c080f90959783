//! Values of parameters in tune files.

use bica_link::{Description, Kind};
use bica_tuning::Layers;
use serde_json::{Value, json};

use super::session::Session;
use super::value::unknown;
use crate::files;
use crate::protocol::Failed;

/// Writes current values to a tune file. Other lines of the file stay as they are.
pub(super) fn save(session: &Session, params: &[(usize, usize)], name: &str) -> Result<Value, Failed> {
    let description = session.description()?;
    let path = files::path(&session.options.tune, name, ".toml")?;
    let mut text = match files::read(&path) {
        Ok(text) => text,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => String::new(),
        Err(error) => return Err(files::failed("read", &path, &error, "mend or remove the file")),
    };
    for &(component, param) in params {
        let (section, key, value) = value(&description, component, param)?;
        text = with_value(&text, section, key, &value);
    }
    if let Some(graph) = session.program.graph.filter(|_| session.program.has_tree(&description.hash)) {
        // The earlier lines may be wrong, too: then the file is not changed, and the user receives the error.
        Layers::new(graph).read_text(&path.display().to_string(), &text)?;
    }
    files::replace(&path, text.as_bytes())?;
    Ok(json!({ "path": path.display().to_string() }))
}

/// Returns section, key and value of a parameter, as in a tune file.
fn value(description: &Description, component: usize, param: usize) -> Result<(&str, &str, String), Failed> {
    let owner = description.components.get(component).ok_or_else(|| unknown("component", component))?;
    let param = owner.params.get(param).ok_or_else(|| unknown("parameter", param))?;
    let text = param.kind.text(param.current());
    let text = if matches!(param.kind, Kind::Choice { .. }) { format!("\"{text}\"") } else { text.to_string() };
    Ok((&owner.name, &param.name, text))
}

/// Returns the text with a value in a section. An existing value is replaced in its line, which keeps its comment; a new one is
/// added at the end of the section.
fn with_value(text: &str, section: &str, key: &str, value: &str) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let (header, key) = (format!("[{}]", bica_tuning::key(section)), bica_tuning::key(key));
    let heading = |line: &String| line.trim_start().starts_with('[');
    let is_header = |line: &String| line.split('#').next().unwrap_or_default().trim() == header;
    let Some(begin) = lines.iter().position(is_header) else {
        if lines.last().is_some_and(|line| !line.is_empty()) {
            lines.push(String::new());
        }
        lines.extend([header, format!("{key} = {value}")]);
        return lines.join("\n") + "\n";
    };
    let end = lines[begin + 1..].iter().position(heading).map_or(lines.len(), |offset| begin + 1 + offset);
    let is_key = |line: &String| line.split_once('=').is_some_and(|(name, _)| name.trim() == key);
    if let Some(line) = lines[begin + 1..end].iter_mut().find(|line| is_key(line)) {
        let comment = line.find('#').map(|at| format!(" {}", &line[at..])).unwrap_or_default();
        *line = format!("{key} = {value}{comment}");
    } else {
        let last = lines[begin..end].iter().rposition(|line| !line.trim().is_empty()).unwrap_or(0);
        lines.insert(begin + last + 1, format!("{key} = {value}"));
    }
    lines.join("\n") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_lines_of_a_tune_file_stay() {
        let text = "# mine\n[A]\nx = 1 # one\ny = 2\n\n[B]\nx = 3\n";
        assert_eq!(with_value(text, "A", "x", "5"), "# mine\n[A]\nx = 5 # one\ny = 2\n\n[B]\nx = 3\n");
        assert_eq!(with_value(text, "A", "z", "5"), "# mine\n[A]\nx = 1 # one\ny = 2\nz = 5\n\n[B]\nx = 3\n");
        assert_eq!(with_value(text, "C", "z", "5"), format!("{text}\n[C]\nz = 5\n"));
        assert_eq!(with_value("", "C", "z", "5"), "[C]\nz = 5\n");
        let quoted = "[\"Filter<3>\"]\n\"höhe\" = 5\n";
        assert_eq!(with_value(&with_value("", "Filter<3>", "höhe", "4"), "Filter<3>", "höhe", "5"), quoted);
    }
}
