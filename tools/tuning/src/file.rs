//! Parser of tune files: a section for each component, a line for each parameter.

use std::ops::Range;

use bica::Value;
use bica_wire::model::{Description, Invalid, Kind};
use toml::de::{DeTable, DeValue};

use crate::write::key;

/// Index of a component, and of a parameter in it.
pub(crate) type Place = (usize, usize);

/// Returns parameters, values and line numbers of a tune file.
pub(crate) fn parse(tree: &Description, file: &str, text: &str) -> Result<Vec<(Place, Value, usize)>, Invalid> {
    let at = |span: &Range<usize>| format!("`{file}` line {}", line(text, span));
    let root = DeTable::parse(text).map_err(|error| {
        let what = format!("{}: {}", at(&error.span().unwrap_or_default()), error.message());
        Invalid::new(what, "a tune file is TOML: `[Component]` and under it `name = value` lines")
    })?;
    let mut values = Vec::new();
    for (component, section) in root.get_ref() {
        let name = component.get_ref();
        tree.component(name).map_err(|invalid| invalid.within(&at(&component.span())))?;
        let DeValue::Table(section) = section.get_ref() else {
            let what = format!("{}: `{name}` is a component, not a value", at(&component.span()));
            return Err(Invalid::new(what, format!("write a section `[{}]` with `name = value` lines", key(name))));
        };
        for (key, value) in section {
            let place = tree.param(&format!("{name}.{}", key.get_ref()));
            let place = place.map_err(|invalid| invalid.within(&at(&key.span())))?;
            let (span, param) = (value.span(), &tree.components[place.0].params[place.1]);
            let written = match (value.get_ref(), &param.kind) {
                (DeValue::Integer(number), _) if number.radix() == 10 => number.as_str(),
                (DeValue::Float(number), _) => number.as_str(),
                (DeValue::String(name), Kind::Choice { .. }) => name,
                // The text of any other type is a value only of `bool`.
                _ => &text[span.clone()],
            };
            let parsed = param.parse(written).map_err(|invalid| invalid.within(&at(&span)))?;
            values.push((place, parsed, line(text, &span)));
        }
    }
    Ok(values)
}

/// Returns the number of the line at the start of a span, from 1.
fn line(text: &str, span: &Range<usize>) -> usize {
    1 + text.get(..span.start).unwrap_or(text).matches('\n').count()
}
