//! Values in layers.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use bica::graph::Graph;
use bica::params::Kind;
use bica::refusal::Reason;
use bica::{Setting, Tree};
use bica_console::Failure;

use crate::file;
use crate::names::{Place, find, range};

/// Values over the defaults of a tree; each layer replaces values of the ones before it.
#[derive(Clone, Debug)]
pub struct Layers {
    graph: &'static Graph,
    /// By component and parameter.
    values: BTreeMap<(usize, u16), (bica::Value, String)>,
}

/// A parameter with its value.
#[derive(Clone, Copy, Debug)]
pub struct Value<'a> {
    /// The parameter.
    pub place: Place,
    /// The value.
    pub value: bica::Value,
    /// Where it comes from, as `tune/nao.toml line 3`; none for the default of the source.
    pub source: Option<&'a str>,
}

impl Layers {
    /// The defaults of a tree.
    #[must_use]
    pub const fn new(graph: &'static Graph) -> Self {
        Self { graph, values: BTreeMap::new() }
    }

    /// The tree.
    pub(crate) const fn graph(&self) -> &'static Graph {
        self.graph
    }

    /// Adds the values of a tune file.
    ///
    /// # Errors
    /// If the file cannot be read, is no TOML, names an unknown component or parameter, or has a value of a wrong kind or out
    /// of range.
    pub fn read(&mut self, path: &Path) -> Result<(), Failure> {
        let name = path.display().to_string();
        let help = "the command `params --write FILE` writes a tune file";
        let text = fs::read_to_string(path).map_err(|error| Failure::of_path("read", path, &error, help))?;
        self.read_text(&name, &text)
    }

    /// Adds the values of a tune file of this name and text.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_text(&mut self, name: &str, text: &str) -> Result<(), Failure> {
        for (place, value, line) in file::parse(self.graph, name, text)? {
            self.insert(place, value, format!("{name} line {line}"));
        }
        Ok(())
    }

    /// Adds an assignment `Component.name=value`; `source` names its origin, as `--set`.
    ///
    /// # Errors
    /// If the text is no assignment, a name is unknown, the value is of a wrong kind or out of range, or the same source has
    /// set the parameter before.
    pub fn assign(&mut self, assignment: &str, source: &str) -> Result<(), Failure> {
        let parts = assignment.split_once('=').and_then(|(name, value)| Some((name.split_once('.')?, value)));
        let Some(((component, name), value)) = parts else {
            let what = format!("`{assignment}` is not an assignment");
            return Err(Failure::new(what, "write it as `Component.name=value`, as `Drive.speed=0.9`"));
        };
        let place = find(self.graph, component.trim(), name.trim())?;
        let value = place.param.kind.parse(value.trim());
        let value = value.map_err(|reason| value_failure(&format!("`{assignment}`"), &place, reason))?;
        match self.values.get(&(place.component.index(), place.index)) {
            Some((before, of)) if of == source => {
                let before = format!("{}.{}={}", place.node.name, place.param.name, place.param.kind.text(*before));
                Err(Failure::new(
                    format!("{source} sets one parameter twice: `{before}` and `{assignment}`"),
                    "leave one of them out",
                ))
            }
            _ => {
                self.insert(place, value, source.to_owned());
                Ok(())
            }
        }
    }

    fn insert(&mut self, place: Place, value: bica::Value, source: String) {
        self.values.insert((place.component.index(), place.index), (value, source));
    }

    /// All parameters of the tree with their values, in the order of components and fields.
    pub fn all(&self) -> impl Iterator<Item = Value<'_>> {
        Place::all(self.graph).map(|place| match self.values.get(&(place.component.index(), place.index)) {
            Some((value, source)) => Value { place, value: *value, source: Some(source) },
            None => Value { place, value: place.param.default, source: None },
        })
    }

    /// Removes the values for which `keep` is false; their parameters have the defaults again.
    pub fn retain(&mut self, keep: impl Fn(&Value<'_>) -> bool) {
        let kept: Vec<_> = self.all().filter(|value| keep(value)).map(|Value { place, .. }| place).collect();
        let is_kept = |key: &(usize, u16)| kept.iter().any(|place| (place.component.index(), place.index) == *key);
        self.values.retain(|key, _| is_kept(key));
    }

    /// The values as one batch for [`Tree::set_params`].
    #[must_use]
    pub fn settings(&self) -> Vec<Setting> {
        self.all().filter(|value| value.source.is_some()).map(|value| value.place.setting(value.value)).collect()
    }

    /// Sets all values in a tree.
    ///
    /// # Errors
    /// If the tree is not tunable, or the values break a rule between parameters.
    pub fn apply<T: Tree>(&self, tree: &mut T) -> Result<(), Failure> {
        tree.set_params(&self.settings()).map_err(|refusal| {
            let of_component = self.all().filter(|value| value.place.node.name == refusal.component);
            let sources = of_component.filter_map(|value| {
                let Value { place, value, source } = value;
                Some(format!("{}={} ({})", place.param.name, place.param.kind.text(value), source?))
            });
            let sources: Vec<_> = sources.collect();
            Failure::new(refusal.to_string(), format!("values that are not defaults: {}", sources.join(", ")))
        })
    }
}

/// An error in a value; `at` is the place of its text.
pub(crate) fn value_failure(at: &str, place: &Place, reason: Reason) -> Failure {
    let (component, name) = (place.node.name, place.param.name);
    let unit = place.param.unit.map(|unit| format!(" {unit}")).unwrap_or_default();
    let values = range(&place.param.kind);
    let help = match place.param.kind {
        Kind::F32 { .. } => format!("write a number from {values}{unit}"),
        Kind::I32 { .. } | Kind::U32 { .. } => format!("write a whole number from {values}{unit}"),
        Kind::Choice { .. } => format!("write one of {values}"),
        Kind::Bool => "write true or false".to_owned(),
    };
    let what = match reason {
        Reason::UnknownVariant { .. } => "there is no such variant".to_owned(),
        Reason::WrongKind { expected, .. } => format!("expected {expected}"),
        reason => reason.to_string(),
    };
    Failure::new(format!("{at}: `{component}.{name}`: {what}"), help)
}
