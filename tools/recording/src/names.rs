//! Unique names.

use std::collections::BTreeMap;

use bica_wire::model::Invalid;

/// Names with their owners, such as the topics of a robot with its outputs.
#[derive(Clone, Debug)]
pub struct NameTable {
    /// Kind of the names, such as `ROS topic`.
    kind: &'static str,
    sources: BTreeMap<String, String>,
}

impl NameTable {
    /// Creates a table of names of a kind, such as `ROS topic`.
    #[must_use]
    pub const fn new(kind: &'static str) -> Self {
        Self { kind, sources: BTreeMap::new() }
    }

    /// Adds a name and its owner, such as ``the output `Lamp.brightness` ``.
    ///
    /// # Errors
    /// If another owner has the name.
    pub fn add(&mut self, name: impl Into<String>, source: impl Into<String>) -> Result<(), Invalid> {
        let (name, source) = (name.into(), source.into());
        let Some(other) = self.sources.insert(name.clone(), source.clone()).filter(|other| *other != source) else {
            return Ok(());
        };
        let what = format!("{other} and {source} have the same {}, `{name}`", self.kind);
        Err(Invalid::new(what, "rename one of the two"))
    }
}
