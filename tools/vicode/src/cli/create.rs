//! `vicode new`

use std::io::Write;
use std::path::{Path, PathBuf};

use super::{diff, folder_of, print, text_of};
use crate::edit::{applied, blank, declare, enlist, module_of, ordered};
use crate::model::Model;
use crate::{Refusal, Splice, read};

/// A file's text before and after an edit.
struct Changed {
    path: PathBuf,
    before: String,
    after: String,
}

pub(super) fn run(
    name: &str,
    folder: &Path,
    tree: Option<&Path>,
    import: Option<&str>,
    dry_run: bool,
    out: &mut dyn Write,
) -> Result<bool, String> {
    let module = module_of(name).map_err(|refusal| refusal.to_string())?;
    let file = folder.join(format!("{module}.rs"));
    if file.exists() {
        return Err(format!("`{}` exists already: choose another name", file.display()));
    }
    let mut changes = Vec::new();
    change(&mut changes, &parent_of(folder)?, |text, _| declare(text, name))?;
    if let Some(tree) = tree {
        change(&mut changes, tree, |text, model| enlist(text, model, name, import))?;
    }
    let text = blank(name);
    if dry_run {
        print(out, &diff::unified(&file.display().to_string(), "", &text))?;
        for one in &changes {
            print(out, &diff::unified(&one.path.display().to_string(), &one.before, &one.after))?;
        }
        return Ok(true);
    }
    let (folder, name) = folder_of(&file)?;
    folder.create(&name, &text).map_err(|error| error.to_string())?;
    for one in &changes {
        let (folder, file) = folder_of(&one.path)?;
        folder.save(&file, &one.before, &one.after).map_err(|error| error.to_string())?;
    }
    print(out, &format!("made {}\n", file.display()))?;
    Ok(true)
}

/// Returns the file that declares the modules of a folder.
fn parent_of(folder: &Path) -> Result<PathBuf, String> {
    let within = ["mod.rs", "lib.rs", "main.rs"].map(|name| folder.join(name));
    let beside = folder.with_extension("rs");
    let found = within.into_iter().chain([beside]).find(|path| path.is_file());
    found.ok_or_else(|| {
        format!("no `mod.rs`, `lib.rs` or `main.rs` is in `{}`: name another `--folder`", folder.display())
    })
}

/// Edits a file; starts from the text after an earlier edit, if any.
fn change(
    changes: &mut Vec<Changed>,
    path: &Path,
    edit: impl FnOnce(&str, &Model) -> Result<Vec<Splice>, Refusal>,
) -> Result<(), String> {
    let is_same = |one: &Changed| one.path.canonicalize().ok() == path.canonicalize().ok();
    let mut changed = match changes.iter().position(is_same) {
        Some(known) => changes.remove(known),
        None => text_of(path).map(|text| Changed { path: path.to_owned(), after: text.clone(), before: text })?,
    };
    let text = &changed.after;
    let splices = edit(text, &read(text)).map_err(|refusal| format!("`{}`: {refusal}", path.display()))?;
    let splices = ordered(text, splices).ok_or_else(|| format!("`{}` cannot be changed", path.display()))?;
    changed.after = applied(text, &splices);
    changes.push(changed);
    Ok(())
}
