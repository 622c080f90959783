//! `vicode new`

use std::io::Write;
use std::path::{Path, PathBuf};

use super::{diff, folder_of, print, text_of};
use crate::edit::{applied, blank, declare, enlist, module_of, ordered};
use crate::model::Model;
use crate::{Refusal, Splice, read};

/// A file before and after.
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
    let parent = parent_of(folder)?;
    let mut changes = vec![changed(&parent, |text, _| declare(text, name))?];
    match tree {
        Some(tree) if same(tree, &parent) => {
            // Both edits of one file: the second on the result of the first.
            let before = std::mem::take(&mut changes[0].before);
            let second = change(tree, changes[0].after.clone(), |text, model| enlist(text, model, name, import))?;
            changes[0] = Changed { path: parent, before, after: second.after };
        }
        Some(tree) => changes.push(changed(tree, |text, model| enlist(text, model, name, import))?),
        None => {}
    }
    let new = Changed { path: file, before: String::new(), after: blank(name) };
    if dry_run {
        for one in [&new].into_iter().chain(&changes) {
            print(out, &diff::unified(&one.path.display().to_string(), &one.before, &one.after))?;
        }
        return Ok(true);
    }
    let (folder, file) = folder_of(&new.path)?;
    folder.create(&file, &new.after).map_err(|error| error.to_string())?;
    for one in &changes {
        let (folder, file) = folder_of(&one.path)?;
        folder.save(&file, &one.before, &one.after).map_err(|error| error.to_string())?;
    }
    print(out, &format!("made {}\n", new.path.display()))?;
    Ok(true)
}

/// The file that declares the modules of a folder.
fn parent_of(folder: &Path) -> Result<PathBuf, String> {
    let within = ["mod.rs", "lib.rs", "main.rs"].map(|name| folder.join(name));
    let beside = folder.with_extension("rs");
    let found = within.into_iter().chain([beside]).find(|path| path.is_file());
    found.ok_or_else(|| {
        format!("no `mod.rs`, `lib.rs` or `main.rs` is in `{}`: name another `--folder`", folder.display())
    })
}

fn same(one: &Path, other: &Path) -> bool {
    let real = |path: &Path| path.canonicalize().ok();
    real(one).is_some() && real(one) == real(other)
}

fn changed(path: &Path, edit: impl FnOnce(&str, &Model) -> Result<Vec<Splice>, Refusal>) -> Result<Changed, String> {
    change(path, text_of(path)?, edit)
}

fn change(
    path: &Path,
    before: String,
    edit: impl FnOnce(&str, &Model) -> Result<Vec<Splice>, Refusal>,
) -> Result<Changed, String> {
    let refused = |refusal: Refusal| format!("`{}`: {refusal}", path.display());
    let splices = edit(&before, &read(&before)).map_err(refused)?;
    let splices = ordered(&before, splices).ok_or_else(|| format!("`{}` cannot be changed", path.display()))?;
    Ok(Changed { path: path.to_owned(), after: applied(&before, &splices), before })
}
