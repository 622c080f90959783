//! `vicode apply`

use std::fs;
use std::io::{Read, Write};
use std::path::Path;

use super::{diff, folder_of, place, print, text_of, width_of};
use crate::{Document, Edit};

pub(super) fn run(file: &Path, edits: &Path, dry_run: bool, out: &mut dyn Write) -> Result<bool, String> {
    let edits = read_edits(edits)?;
    let text = text_of(file)?;
    let mut document = Document::new(&text).with_width(width_of(file));
    for (index, edit) in edits.iter().enumerate() {
        document.apply(std::slice::from_ref(edit)).map_err(|refusal| {
            let at = refusal.span.map_or_else(String::new, |span| {
                let (line, column) = place(document.text(), span.start);
                format!(" at {line}:{column}")
            });
            format!("edit {} is refused{at}, nothing was changed: {refusal}", index + 1)
        })?;
    }
    if dry_run {
        print(out, &diff::unified(&file.display().to_string(), &text, document.text()))?;
        return Ok(true);
    }
    let (folder, name) = folder_of(file)?;
    folder.save(&name, &text, document.text()).map_err(|error| error.to_string())?;
    Ok(true)
}

fn read_edits(path: &Path) -> Result<Vec<Edit>, String> {
    let failed = |error| format!("cannot read `{}`: {error}", path.display());
    let json = if path == Path::new("-") {
        let mut json = String::new();
        std::io::stdin().read_to_string(&mut json).map_err(failed)?;
        json
    } else {
        fs::read_to_string(path).map_err(failed)?
    };
    serde_json::from_str(&json).map_err(|error| format!("`{}` is no list of edits: {error}", path.display()))
}
