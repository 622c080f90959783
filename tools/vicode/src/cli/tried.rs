//! `vicode try`

use std::fs;
use std::io::Write;
use std::path::Path;

use super::draw::chosen;
use super::{list_of, print, print_json, text_of};
use crate::trial::{Place, Step, Trial};

pub(super) fn run(
    file: &Path,
    steps: &Path,
    component: Option<&str>,
    json: bool,
    out: &mut dyn Write,
) -> Result<bool, String> {
    let text = text_of(file)?;
    let model = crate::read(&text);
    let component = chosen(&model, component)?;
    let steps: Vec<Step> = list_of(steps, "steps")?;
    let file = fs::canonicalize(file).map_err(|error| format!("cannot read `{}`: {error}", file.display()))?;
    let place = Place::of(&file, &component.name.text);
    let trial = Trial::run(component, &text, place.cycle_hz(), &steps)?;
    if json {
        print_json(out, &trial)?;
    } else {
        print(out, &trial.skeleton(component, &text, &place, &steps))?;
    }
    Ok(true)
}
