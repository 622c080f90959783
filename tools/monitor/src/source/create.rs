//! New components.

use bica_vicode::cli::unified;
use bica_vicode::{Edit, Refusal, Splice, applied, blank, declare, enlist, module_of, ordered, read};
use serde_json::{Value, json};

use super::files::{Files, failed};
use super::{edit, limits};
use crate::pages::PageId;
use crate::protocol::{ChangedBy, Failed};

/// A component to create.
pub(super) struct New {
    pub(super) name: String,
    /// Folder of its file.
    pub(super) folder: String,
    /// File of the tree to which the component is added.
    pub(super) tree: Option<String>,
    /// Module from which that file imports it.
    pub(super) import: Option<String>,
}

/// A file before and after.
struct Changed {
    name: String,
    before: String,
    splices: Vec<Splice>,
}

impl Files {
    /// Creates a component; with `dry` it only returns the differences.
    pub(super) fn create(&self, page: PageId, new: &New, dry: bool) -> Result<Value, Failed> {
        limits::name(&new.name)?;
        limits::name(&new.folder)?;
        let refused = |refusal: Refusal| Failed::new(refusal.message, "nothing was made");
        let module = module_of(&new.name).map_err(refused)?;
        let file = join(&new.folder, &format!("{module}.rs"));
        let exists = || Failed::new(format!("`{file}` exists already"), "choose another name");
        if self.open().contains_key(&file) || self.folder.source(&file).is_ok() {
            return Err(exists());
        }
        let parent = self.parent_of(&new.folder)?;
        let mut changes = vec![self.change(&parent, |text| declare(text, &new.name))?];
        if let Some(tree) = &new.tree {
            let enlisted = self.change(tree, |text| enlist(text, &read(text), &new.name, new.import.as_deref()))?;
            match changes.iter_mut().find(|one| one.name == enlisted.name) {
                Some(same) => same.splices.extend(enlisted.splices),
                None => changes.push(enlisted),
            }
        }
        let text = blank(&new.name);
        let mut files = vec![json!({ "file": file, "diff": unified(&file, "", &text) })];
        for one in &mut changes {
            let splices = ordered(&one.before, std::mem::take(&mut one.splices));
            let unclear = || Failed::new(format!("`{}` cannot be changed", one.name), "write the lines by hand");
            one.splices = splices.ok_or_else(unclear)?;
            let after = applied(&one.before, &one.splices);
            files.push(json!({ "file": one.name, "diff": unified(&one.name, &one.before, &after) }));
        }
        if !dry {
            self.folder.create(&file, &text).map_err(|error| failed(&error))?;
            changes.iter().try_for_each(|one| self.take(page, one))?;
        }
        Ok(json!({ "file": file, "files": files }))
    }

    /// Applies a change to an open file, and saves it.
    fn take(&self, page: PageId, changed: &Changed) -> Result<(), Failed> {
        {
            let mut open = self.open();
            let file = self.get(&mut open, &changed.name)?;
            if file.document.text() != changed.before {
                let what =
                    format!("`{}` was changed meanwhile; the new file is made, but not declared there", changed.name);
                return Err(Failed::new(what, "write the lines by hand"));
            }
            // From the end, so that earlier offsets stay valid.
            let replace = |splice: &Splice| Edit::Replace { span: splice.span, text: splice.text.clone() };
            let edits: Vec<Edit> = changed.splices.iter().rev().map(replace).collect();
            let from = file.document.version();
            let change = edit::apply(file, &edits)?;
            file.publish(&self.pages, Some((from, change)), ChangedBy::Page, page);
        }
        self.write(&changed.name)
    }

    fn change(&self, name: &str, plan: impl FnOnce(&str) -> Result<Vec<Splice>, Refusal>) -> Result<Changed, Failed> {
        let mut open = self.open();
        let file = self.get(&mut open, name)?;
        let before = file.document.text().to_owned();
        let splices = plan(&before)
            .map_err(|refusal| Failed::new(format!("`{}`: {}", file.name, refusal.message), "nothing was made"))?;
        Ok(Changed { name: file.name.clone(), before, splices })
    }

    /// Returns the file that declares the modules of a folder.
    fn parent_of(&self, folder: &str) -> Result<String, Failed> {
        let within = ["mod.rs", "lib.rs", "main.rs"].map(|name| join(folder, name));
        let beside = format!("{folder}.rs");
        let found = within.into_iter().chain([beside]).find(|name| self.folder.source(name).is_ok());
        let what = || format!("no `mod.rs`, `lib.rs` or `main.rs` is in the folder `{}`", folder.escape_debug());
        found.ok_or_else(|| Failed::new(what(), "choose a folder of modules below the folder of sources"))
    }
}

fn join(folder: &str, name: &str) -> String {
    let folder = folder.trim_end_matches('/');
    if folder.is_empty() { name.to_owned() } else { format!("{folder}/{name}") }
}
