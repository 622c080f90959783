//! `vicode draw`

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use super::{print, text_of};
use crate::draw::{Diagram, Format, dot, mermaid, svg};
use crate::files::Layout;
use crate::model::{Component, Model};

pub(super) fn run(
    file: &Path,
    format: Format,
    component: Option<&str>,
    output: Option<&Path>,
    out: &mut dyn Write,
) -> Result<bool, String> {
    let model = crate::read(&text_of(file)?);
    let component = chosen(&model, component)?;
    let diagram = || Ok::<_, String>(Diagram::of(component, &layout(file)?));
    let text = match format {
        Format::Svg => svg(&diagram()?),
        Format::Mermaid => mermaid(component),
        Format::Dot => dot(component),
        Format::Png => {
            picture(&diagram()?, &output.map_or_else(|| default_picture(component), Path::to_owned))?;
            return Ok(true);
        }
    };
    match output {
        Some(path) => write(path, &text)?,
        None => print(out, &text)?,
    }
    Ok(true)
}

pub(super) fn write(path: &Path, text: &str) -> Result<(), String> {
    fs::write(path, text).map_err(|error| format!("cannot write `{}`: {error}", path.display()))
}

#[cfg(feature = "png")]
fn picture(diagram: &Diagram, path: &Path) -> Result<(), String> {
    let failed = |error| format!("cannot write `{}`: {error}", path.display());
    bica_drawing::png::write(path, &crate::draw::png(diagram)).map_err(failed)
}

#[cfg(not(feature = "png"))]
fn picture(_: &Diagram, _: &Path) -> Result<(), String> {
    Err("this program was built without pictures: take `--format svg`, or build it with the feature `png`".to_owned())
}

/// Returns the default file name of a picture: `player.png` for `Player`.
fn default_picture(component: &Component) -> PathBuf {
    PathBuf::from(component.name.text.split('<').next().unwrap_or_default().to_lowercase()).with_extension("png")
}

pub(super) fn chosen<'a>(model: &'a Model, name: Option<&str>) -> Result<&'a Component, String> {
    let machines: Vec<&Component> = model.components.iter().filter(|component| component.is_machine()).collect();
    let names = || machines.iter().map(|component| format!("`{}`", component.key)).collect::<Vec<_>>().join(", ");
    match (name, &machines[..]) {
        (_, []) => Err("no state machine is in this file: a machine has functions with `#[state]`".to_owned()),
        (None, [machine]) => Ok(machine),
        (None, _) => Err(format!("this file has several machines: choose one by `--component`, {}", names())),
        (Some(name), _) => model
            .component(name)
            .filter(|component| component.is_machine())
            .ok_or_else(|| format!("no machine `{name}` is in this file: there is {}", names())),
    }
}

/// Reads the layout file beside a source; empty without one.
pub(super) fn layout(source: &Path) -> Result<Layout, String> {
    let path = Layout::beside(source);
    match fs::read_to_string(&path) {
        Ok(text) => Layout::parse(&text).map_err(|error| format!("`{}`: {error}", path.display())),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Layout::default()),
        Err(error) => Err(format!("cannot read `{}`: {error}", path.display())),
    }
}
