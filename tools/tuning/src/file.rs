//! Parser of tune files: a section for each component, a line for each parameter.

use std::ops::Range;

use bica::Value;
use bica::graph::Graph;
use bica::params::Kind;
use bica_console::Failure;
use toml::de::{DeTable, DeValue};

use crate::layers::value_failure;
use crate::names::{Place, find, find_component};

/// Returns parameters, values and line numbers of a tune file.
pub(crate) fn parse(graph: &Graph, file: &str, text: &str) -> Result<Vec<(Place, Value, usize)>, Failure> {
    let at = |span: &Range<usize>| format!("`{file}` line {}", line(text, span));
    let root = DeTable::parse(text).map_err(|error| {
        let what = format!("{}: {}", at(&error.span().unwrap_or_default()), error.message());
        Failure::new(what, "a tune file is TOML: `[Component]` and under it `name = value` lines")
    })?;
    let mut values = Vec::new();
    for (component, section) in root.get_ref() {
        let name = component.get_ref();
        find_component(graph, name).map_err(|failure| failure.at(&at(&component.span())))?;
        let DeValue::Table(section) = section.get_ref() else {
            let what = format!("{}: `{name}` is a component, not a value", at(&component.span()));
            return Err(Failure::new(what, format!("write a section `[{name}]` with `name = value` lines")));
        };
        for (key, value) in section {
            let place = find(graph, name, key.get_ref()).map_err(|failure| failure.at(&at(&key.span())))?;
            let span = value.span();
            let parsed = place.param.kind.parse(&plain(value.get_ref(), &place.param.kind));
            let parsed = parsed.map_err(|reason| value_failure(&at(&span), &place, reason))?;
            values.push((place, parsed, line(text, &span)));
        }
    }
    Ok(values)
}

/// Returns the text of a value of the right TOML type, and otherwise one that is no value of any kind.
fn plain(value: &DeValue<'_>, kind: &Kind) -> String {
    match (value, kind) {
        (DeValue::Integer(number), Kind::I32 { .. } | Kind::U32 { .. } | Kind::F32 { .. }) if number.radix() == 10 => {
            number.as_str().to_owned()
        }
        (DeValue::Float(number), Kind::F32 { .. }) => number.as_str().to_owned(),
        (DeValue::Boolean(value), Kind::Bool) => value.to_string(),
        (DeValue::String(name), Kind::Choice { .. }) => name.to_string(),
        _ => "?".to_owned(),
    }
}

/// Returns the number of the line at the start of a span, from 1.
fn line(text: &str, span: &Range<usize>) -> usize {
    1 + text.get(..span.start).unwrap_or(text).matches('\n').count()
}
