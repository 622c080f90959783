//! `params`: the parameters with their values, and tune files.

mod args;
mod tuning;

use bica::{Graph, Tree};
use bica_tuning::{Layers, Value, render, write};
use serde::Serialize;

pub(crate) use args::Params;
use args::ParamsFormat;

use crate::console::{Console, Failure, Outcome, Style};
pub use tuning::{InForce, Layer, TuningArgs, in_force, print_in_force};

/// Lists or writes parameters as the command line requests. `kind` is the default of `--kind`.
pub(crate) fn run<T: Tree + Default, L: Layer>(args: &Params<L>, kind: &str) -> Result<Outcome, Failure> {
    let graph: &'static Graph = const { &T::GRAPH };
    let layers = args.tuning.layers(graph, args.kind.as_deref().unwrap_or(kind))?;
    layers.apply(&mut *Box::<T>::default())?;
    for component in &args.components {
        layers.tree().component(component)?;
    }
    if let Some(path) = &args.write {
        write(&layers, path, args.force)?;
        let count = layers.all().filter(|value| !value.is_default()).count();
        Console::new(false).print(&format!(
            "{count} value{} in {}",
            if count == 1 { "" } else { "s" },
            path.display()
        ))?;
        return Ok(Outcome::Success);
    }
    let values: Vec<_> = layers.all().filter(|value| is_listed(args, value)).collect();
    match if args.json { ParamsFormat::Json } else { args.format } {
        ParamsFormat::Table => print_table(Console::new(false), &values)?,
        ParamsFormat::Toml => Console::new(false).print(render(&only(args, &layers)).trim_end())?,
        ParamsFormat::Json => {
            let parameters = values.iter().map(ParameterRow::new).collect();
            Console::new(true).print_json(&Report { schema: "bica/params/1", parameters })?;
        }
    }
    Ok(Outcome::Success)
}

fn is_listed<L: Layer>(args: &Params<L>, value: &Value<'_>) -> bool {
    let named = args.components.is_empty() || args.components.contains(&value.component.name);
    named && (!args.changed || !value.is_default())
}

/// Returns the layers with only the listed parameters.
fn only<L: Layer>(args: &Params<L>, layers: &Layers) -> Layers {
    let mut only = layers.clone();
    only.retain(|value| is_listed(args, value));
    only
}

fn print_table(console: Console, values: &[Value<'_>]) -> Result<(), Failure> {
    let rows: Vec<_> = values.iter().map(row).collect();
    let titles = ["parameter", "value", "default", "range", "unit"].map(str::to_owned);
    let width = |column: usize| {
        rows.iter().map(|row| &row.0).chain([&titles]).map(|row| row[column].chars().count()).max().unwrap_or_default()
    };
    let widths = [0, 1, 2, 3, 4].map(width);
    let line = |cells: &[String; 5]| {
        let cell = |(text, width): (&String, usize)| format!("{text:<width$}");
        cells.iter().zip(widths).map(cell).collect::<Vec<_>>().join("  ")
    };
    console.print(&console.styled(Style::Strong, &format!("{}  description", line(&titles))))?;
    for ((cells, changed, text), value) in rows.iter().zip(values) {
        let style = if *changed { Style::New } else { Style::Plain };
        let source = value.source.map(|source| format!(" ({source})")).unwrap_or_default();
        console.print(&format!("{}  {text}{source}", console.styled(style, &line(cells))))?;
    }
    Ok(())
}

/// Returns the cells of a parameter's row, whether its value differs from the default, and its description.
fn row(value: &Value<'_>) -> ([String; 5], bool, String) {
    let Value { component, param, .. } = value;
    let cells = [
        format!("{}.{}", component.name, param.name),
        value.text(),
        param.kind.text(param.default).to_string(),
        param.range(),
        param.unit.clone().unwrap_or_default(),
    ];
    (cells, !value.is_default(), param.doc.split_whitespace().collect::<Vec<_>>().join(" "))
}

#[derive(Serialize)]
struct Report<'a> {
    schema: &'static str,
    parameters: Vec<ParameterRow<'a>>,
}

#[derive(Serialize)]
struct ParameterRow<'a> {
    component: &'a str,
    name: &'a str,
    doc: &'a str,
    unit: Option<&'a str>,
    kind: &'static str,
    range: String,
    default: String,
    value: String,
    source: Option<&'a str>,
}

impl<'a> ParameterRow<'a> {
    fn new(value: &Value<'a>) -> Self {
        let Value { component, param, source } = *value;
        Self {
            component: &component.name,
            name: &param.name,
            doc: &param.doc,
            unit: param.unit.as_deref(),
            kind: param.kind.name(),
            range: param.range(),
            default: param.kind.text(param.default).to_string(),
            value: value.text(),
            source,
        }
    }
}
