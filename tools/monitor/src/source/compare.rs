//! Differences from the last commit.

use std::collections::BTreeMap;

use bica_vicode::compare::{Version, committed, compare, report, union};
use bica_vicode::read;
use serde_json::{Value, json};

use super::files::Files;
use super::limits;
use crate::protocol::Failed;

impl Files {
    /// Compares the text of a file, saved or not, with the file in the last commit.
    pub(super) fn compare(&self, name: &str) -> Result<Value, Failed> {
        let (path, text, model) = {
            let mut open = self.open();
            let file = self.get(&mut open, name)?;
            (file.path.clone(), file.document.text().to_owned(), file.document.model().clone())
        };
        let help = "the drawing of the file is shown without it";
        let commit = committed(&path).map_err(|error| Failed::new(error, help))?;
        let before = commit.text.as_deref().unwrap_or_default();
        limits::text(before)?;
        let old = read(before);
        let comparison = compare(Version { text: before, model: &old }, Version { text: &text, model: &model });
        let of = |key: &str| match (old.component(key), model.component(key)) {
            (Some(old), Some(new)) => union(old, new),
            (old, new) => new.or(old).cloned().unwrap_or_default(),
        };
        let both: BTreeMap<&str, _> = comparison.components.iter().map(|one| (&*one.key, of(&one.key))).collect();
        Ok(json!({
            "revision": commit.revision,
            "new": commit.text.is_none(),
            "report": report(&comparison),
            "comparison": comparison,
            "both": both,
        }))
    }
}
