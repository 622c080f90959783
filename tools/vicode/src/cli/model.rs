//! `vicode model`

use std::io::Write;
use std::path::Path;

use super::{print, text_of};

pub(super) fn run(file: &Path, out: &mut dyn Write) -> Result<bool, String> {
    let model = crate::read(&text_of(file)?);
    let json = serde_json::to_string_pretty(&model).map_err(|error| format!("cannot write JSON: {error}"))?;
    print(out, &(json + "\n"))?;
    Ok(true)
}
