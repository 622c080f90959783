//! Edits by pages.

use std::collections::BTreeMap;

use bica_vicode::{Change, Edit, FileError, Keep, Note, Refusal};
use serde_json::{Value, json};

use super::file::OpenFile;
use super::files::{Files, failed, no_component};
use super::{limits, save};
use crate::pages::PageId;
use crate::pages::lock;
use crate::protocol::{ChangedBy, Failed, MovedState, SourcePlace};

/// Returns the error for a page whose edit was refused.
pub(super) fn refused(refusal: &Refusal, file: &OpenFile) -> Failed {
    let before = refusal.span.and_then(|span| file.document.text().get(..span.start));
    let line = before.map(|before| 1 + before.matches('\n').count());
    let help =
        line.map_or_else(|| "nothing was changed".to_owned(), |line| format!("nothing was changed; see line {line}"));
    Failed::new(refusal.message.clone(), help)
}

/// Applies edits to an open file, copies the positions of renamed states, and schedules saving.
pub(super) fn apply(file: &mut OpenFile, edits: &[Edit]) -> Result<Change, Failed> {
    limits::edits(edits, file.document.text().len())?;
    let change = file.document.apply(edits).map_err(|refusal| refused(&refusal, file))?;
    for edit in edits {
        if let Edit::Rename { component, function, to } = edit {
            file.layout.renamed(component, function, to);
        }
    }
    save::later(file);
    Ok(change)
}

impl Files {
    pub(super) fn edit(&self, page: PageId, name: &str, version: u64, edits: &[Edit]) -> Result<Value, Failed> {
        for edit in edits {
            if let Edit::Rename { component, function, .. } = edit {
                self.complete(name, component, function, &[])?;
            }
        }
        let mut open = self.open();
        let file = self.get(&mut open, name)?;
        let from = file.document.version();
        if version != from && edits.iter().any(|edit| matches!(edit, Edit::Replace { .. })) {
            let help = "take in the changes that came meanwhile, then send the edit for the new version";
            return Err(Failed::stale(format!("the text has version {from}, the edit is of version {version}"), help));
        }
        let change = apply(file, edits)?;
        let version = change.version;
        file.publish(&self.pages, Some((from, change)), ChangedBy::Page, page);
        Ok(json!({ "version": version }))
    }

    pub(super) fn undo(&self, page: PageId, name: &str, again: bool) -> Result<Value, Failed> {
        let mut open = self.open();
        let file = self.get(&mut open, name)?;
        if let Some(group) = file.document.next_group(again) {
            let names = lock(&self.groups).get(group).cloned().unwrap_or_default();
            let shown = file.name.clone();
            for name in names.iter().filter(|name| **name != shown) {
                let other = self.get(&mut open, name)?;
                if other.document.next_group(again) != Some(group) {
                    let what = format!("the step changed several files, and `{name}` was changed since");
                    return Err(Failed::new(what, "undo the later changes of that file first"));
                }
            }
            for name in names.iter().filter(|name| **name != shown) {
                self.undo_one(&mut open, page, name, again)?;
            }
        }
        self.undo_one(&mut open, page, name, again)
    }

    /// Undoes the last step of one file, or redoes it (`again`).
    fn undo_one(
        &self,
        open: &mut BTreeMap<String, OpenFile>,
        page: PageId,
        name: &str,
        again: bool,
    ) -> Result<Value, Failed> {
        let file = self.get(open, name)?;
        let from = file.document.version();
        let change = if again { file.document.redo() } else { file.document.undo() };
        let what = if again { "no undone step" } else { "no step to undo" };
        let change = change.ok_or_else(|| {
            Failed::new(format!("there is {what}"), "1000 steps are remembered while the server runs")
        })?;
        let version = change.version;
        save::later(file);
        file.publish(&self.pages, Some((from, change)), ChangedBy::Undo, page);
        Ok(json!({ "version": version }))
    }

    pub(super) fn resolve(&self, page: PageId, name: &str, keep: Keep) -> Result<Value, Failed> {
        if let Keep::Text(text) = &keep {
            limits::text(text)?;
        }
        let mut open = self.open();
        let file = self.get(&mut open, name)?;
        let from = file.document.version();
        let none = || Failed::new("there is no conflict", "the other side may have taken its change back");
        let change = file.document.resolve(keep).ok_or_else(none)?;
        let version = change.version;
        save::later(file);
        file.publish(&self.pages, Some((from, change)), ChangedBy::Page, page);
        Ok(json!({ "version": version }))
    }

    /// Moves states; writes the layout file.
    pub(super) fn shift(&self, page: PageId, name: &str, moved: &[MovedState]) -> Result<Value, Failed> {
        limits::positions(moved)?;
        let mut open = self.open();
        let file = self.get(&mut open, name)?;
        for MovedState { component, state, .. } in moved {
            let found = file.document.model().component(component).and_then(|component| component.state(state));
            // Names in the model are identifiers: they cannot add lines to the layout file.
            found.ok_or_else(|| {
                let what = format!(
                    "`{component}` has no state `{state}` in this file",
                    component = component.escape_debug(),
                    state = state.escape_debug()
                );
                Failed::new(what, "it may have been renamed or deleted meanwhile")
            })?;
        }
        for MovedState { component, state, x, y } in moved {
            file.layout.set(component, state, *x, *y);
        }
        file.publish(&self.pages, None, ChangedBy::Page, page);
        let name = file.name.clone();
        drop(open);
        self.layout_changed(&name).map(|()| Value::Null)
    }

    /// Replaces a note of a component; writes the layout file.
    pub(super) fn change_note(
        &self,
        page: PageId,
        name: &str,
        component: &str,
        (from, to): (Option<Note>, Option<Note>),
    ) -> Result<Value, Failed> {
        let mut open = self.open();
        let file = self.get(&mut open, name)?;
        let found = file.document.model().component(component);
        let key = found.ok_or_else(|| no_component(component, "it may have been renamed"))?.key.clone();
        if let Some(to) = &to {
            limits::note(to, file.drawn().notes.len())?;
        }
        if !file.layout.change_note(&key, from.as_ref(), to) {
            return Err(Failed::new("the note is not as it was", "another page or program has changed it"));
        }
        file.publish(&self.pages, None, ChangedBy::Page, page);
        let name = file.name.clone();
        drop(open);
        self.layout_changed(&name).map(|()| Value::Null)
    }

    /// Removes the stored positions of a component's states; writes the layout file.
    pub(super) fn arrange(&self, page: PageId, name: &str, component: &str) -> Result<Value, Failed> {
        let mut open = self.open();
        let file = self.get(&mut open, name)?;
        let found = file.document.model().component(component);
        let none = || no_component(component, "it may have been renamed");
        let states: Vec<String> =
            found.ok_or_else(none)?.states.iter().map(|state| state.function.name.text.clone()).collect();
        for state in states {
            file.layout.remove(component, &state);
        }
        file.publish(&self.pages, None, ChangedBy::Page, page);
        let (name, positions) = (file.name.clone(), file.drawn().positions.clone());
        drop(open);
        self.layout_changed(&name)?;
        Ok(json!({ "positions": positions }))
    }

    fn layout_changed(&self, name: &str) -> Result<(), Failed> {
        let _disk = lock(&self.disk);
        self.write_layout(name, true)
    }

    /// Refuses to rename a function if other files certainly use it at places that are not among the chosen ones.
    fn complete(&self, name: &str, component: &str, function: &str, places: &[SourcePlace]) -> Result<(), Failed> {
        let uses = self.uses(name, component, function)?.into_iter().filter(|one| one.certain);
        let left: Vec<String> = uses
            .filter(|one| !places.iter().any(|place| place.file == one.file && place.span == one.span))
            .map(|one| format!("{}:{}", one.file, one.line))
            .collect();
        if left.is_empty() {
            return Ok(());
        }
        let what = format!("`{function}` is also used in {}", left.join(", "));
        Err(Failed::new(what, "rename it there too: `rename_uses` with the places that `uses` lists"))
    }

    /// Renames a function in its file and at places of other files: all or none.
    pub(super) fn rename(
        &self,
        page: PageId,
        name: &str,
        [component, function, to]: [String; 3],
        places: &[SourcePlace],
    ) -> Result<Value, Failed> {
        self.complete(name, &component, &function, places)?;
        let mut open = self.open();
        let main = self.get(&mut open, name)?.name.clone();
        let mut others: Vec<(String, Vec<Edit>)> = Vec::new();
        for SourcePlace { file: other, span } in places {
            let file = self.get(&mut open, other)?;
            let text = span.of(file.document.text());
            if file.name == main || (text != function && text.strip_prefix("r#") != Some(&*function)) {
                let what = format!("`{}` has no `{}` of another file at byte {}", file.name, function, span.start);
                return Err(Failed::stale(what, "list the uses again"));
            }
            let edit = Edit::Replace { span: *span, text: to.clone() };
            let file = file.name.clone();
            match others.iter_mut().find(|(known, _)| *known == file) {
                Some((_, edits)) => edits.push(edit),
                None => others.push((file, vec![edit])),
            }
        }
        for (file, edits) in &mut others {
            // From the end, so that earlier offsets stay valid.
            edits.sort_by_key(|edit| {
                std::cmp::Reverse(if let Edit::Replace { span, .. } = edit { span.start } else { 0 })
            });
            edits.dedup();
            limits::edits(edits, self.get(&mut open, file)?.document.text().len())?;
        }
        // The main file is the first: if its edit is refused, nothing has changed.
        others.insert(0, (main, vec![Edit::Rename { component, function, to }]));
        let names: Vec<String> = others.iter().map(|(name, _)| name.clone()).collect();
        let group = lock(&self.groups).len();
        let mut changed = Vec::new();
        for (name, edits) in others {
            let file = self.get(&mut open, &name)?;
            let from = file.document.version();
            let change = apply(file, &edits)?;
            file.document.group(group);
            changed.push(json!({ "file": name, "version": change.version }));
            file.publish(&self.pages, Some((from, change)), ChangedBy::Page, page);
        }
        lock(&self.groups).push(names);
        Ok(json!({ "files": changed }))
    }

    /// Saves a file at once.
    pub(super) fn save(&self, name: &str) -> Result<Value, Failed> {
        let (name, deleted) = {
            let mut open = self.open();
            let file = self.get(&mut open, name)?;
            (file.name.clone(), file.deleted)
        };
        if deleted {
            self.make_again(&name)?;
        }
        self.write(&name)?;
        let has_conflict = self.open().get(&name).is_some_and(|file| file.document.conflict().is_some());
        let failed = || {
            let help = "choose what to keep first";
            Failed::new("the file was changed at the same place by another program", help)
        };
        if has_conflict { Err(failed()) } else { Ok(Value::Null) }
    }

    /// Creates a deleted file again.
    fn make_again(&self, name: &str) -> Result<(), Failed> {
        let _disk = lock(&self.disk);
        let text = self.open().get(name).map(|file| file.document.text().to_owned()).unwrap_or_default();
        match self.folder.create(name, &text) {
            // Another program has created it: the next comparison with the disk merges it.
            Ok(()) | Err(FileError::Exists(_)) => {}
            Err(error) => return Err(failed(&error)),
        }
        if let Some(file) = self.open().get_mut(name) {
            file.document.mark_written(&text);
            save::written(file, &self.pages);
        }
        Ok(())
    }
}
