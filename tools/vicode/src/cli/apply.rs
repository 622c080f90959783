//! `vicode apply`

use std::io::Write;
use std::path::Path;

use super::{diff, folder_of, list_of, place, print, text_of, width_of};
use crate::{Document, Edit};

pub(super) fn run(file: &Path, edits: &Path, dry_run: bool, out: &mut dyn Write) -> Result<bool, String> {
    let edits: Vec<Edit> = list_of(edits, "edits")?;
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
