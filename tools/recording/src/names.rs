//! Names that are given once.

use std::collections::BTreeMap;

use bica_wire::model::Invalid;

/// Names with what has them, such as the topics of a robot with its outputs.
#[derive(Clone, Debug)]
pub struct NameTable {
    /// What is named, such as `ROS topic`.
    kind: &'static str,
    sources: BTreeMap<String, String>,
}

impl NameTable {
    /// A table of names of a kind, such as `ROS topic`.
    #[must_use]
    pub const fn new(kind: &'static str) -> Self {
        Self { kind, sources: BTreeMap::new() }
    }

    /// Adds a name, and what has it, such as ``the output `Lamp.brightness` ``.
    ///
    /// # Errors
    /// If something else has the name.
    pub fn add(&mut self, name: impl Into<String>, source: impl Into<String>) -> Result<(), Invalid> {
        let (name, source) = (name.into(), source.into());
        let Some(other) = self.sources.insert(name.clone(), source.clone()).filter(|other| *other != source) else {
            return Ok(());
        };
        let what = format!("{other} and {source} have the same {}, `{name}`", self.kind);
        Err(Invalid::new(what, "rename one of the two"))
    }
}
