//! Parameter values in layers.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use bica::{ComponentId, Graph, Setting, Tree};
use bica_wire::model::{Component, Description, Invalid, NamedSetting, Param};

use crate::file::{self, Place};

/// Values over the defaults of a tree; each layer replaces values of the ones before it.
#[derive(Clone, Debug)]
pub struct Layers {
    /// The tree with the values.
    tree: Description,
    /// Source of each value that a layer has set.
    sources: BTreeMap<Place, String>,
}

/// A parameter with its value, [`Param::current`].
#[derive(Clone, Copy, Debug)]
pub struct Value<'a> {
    /// Its component.
    pub component: &'a Component,
    /// The parameter.
    pub param: &'a Param,
    /// Source of the value, such as `tune/nao.toml line 3`; none for the default of the source.
    pub source: Option<&'a str>,
}

impl Value<'_> {
    /// Returns whether the value is the default of the source.
    #[must_use]
    pub fn is_default(&self) -> bool {
        self.param.current() == self.param.default
    }

    /// Returns the value as text.
    #[must_use]
    pub fn text(&self) -> String {
        self.param.kind.text(self.param.current()).to_string()
    }
}

impl Layers {
    /// The defaults of a tree.
    #[must_use]
    pub fn new(graph: &Graph) -> Self {
        Self { tree: Description::of(graph), sources: BTreeMap::new() }
    }

    /// The tree with the values.
    #[must_use]
    pub const fn tree(&self) -> &Description {
        &self.tree
    }

    /// Adds the values of a tune file.
    ///
    /// # Errors
    /// If the file cannot be read, is no TOML, names an unknown component or parameter, or has a value of a wrong kind or out
    /// of range.
    pub fn read(&mut self, path: &Path) -> Result<(), Invalid> {
        let text = fs::read_to_string(path).map_err(|error| {
            let what = format!("cannot read `{}`: {error}", path.display());
            Invalid::new(what, "the command `params --write FILE` writes a tune file")
        })?;
        self.read_text(&path.display().to_string(), &text)
    }

    /// Adds the values of a tune file of this name and text.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_text(&mut self, name: &str, text: &str) -> Result<(), Invalid> {
        for (place, value, line) in file::parse(&self.tree, name, text)? {
            self.insert(place, value, format!("{name} line {line}"));
        }
        Ok(())
    }

    /// Adds an assignment `Component.name=value`; `source` names its origin, as `--set`.
    ///
    /// # Errors
    /// If the text is no assignment, a name is unknown, the value is of a wrong kind or out of range, or the same source has
    /// set the parameter before.
    pub fn assign(&mut self, assignment: &str, source: &str) -> Result<(), Invalid> {
        let Setting { component, index, value } = self.tree.setting(&NamedSetting::parse(assignment)?)?;
        let place = (component.index(), usize::from(index));
        if self.sources.get(&place).is_some_and(|of| of == source) {
            let owner = &self.tree.components[place.0];
            let Param { name, kind, .. } = &owner.params[place.1];
            let before = format!("{}.{name}={}", owner.name, kind.text(owner.params[place.1].current()));
            let what = format!("{source} sets one parameter twice: `{before}` and `{assignment}`");
            return Err(Invalid::new(what, "leave one of them out"));
        }
        self.insert(place, value, source.to_owned());
        Ok(())
    }

    fn insert(&mut self, place: Place, value: bica::Value, source: String) {
        self.tree.components[place.0].params[place.1].value = Some(value);
        self.sources.insert(place, source);
    }

    fn places(&self) -> impl Iterator<Item = (Place, Value<'_>)> {
        self.tree.components.iter().enumerate().flat_map(move |(owner, component)| {
            component.params.iter().enumerate().map(move |(index, param)| {
                let place = (owner, index);
                (place, Value { component, param, source: self.sources.get(&place).map(String::as_str) })
            })
        })
    }

    /// All parameters of the tree with their values, in the order of components and fields.
    pub fn all(&self) -> impl Iterator<Item = Value<'_>> {
        self.places().map(|(_, value)| value)
    }

    /// Returns the sources of the values in force, in the order of the parameters, each with its values as assignments.
    #[must_use]
    pub fn in_force(&self) -> Vec<(String, Vec<String>)> {
        let mut layers: Vec<(String, Vec<String>)> = Vec::new();
        for value in self.all() {
            let Some(source) = value.source else { continue };
            let source = source.rsplit_once(" line ").map_or(source, |(file, _)| file);
            let assignment = format!("{}.{}={}", value.component.name, value.param.name, value.text());
            match layers.iter_mut().find(|(before, _)| before == source) {
                Some((_, values)) => values.push(assignment),
                None => layers.push((source.to_owned(), vec![assignment])),
            }
        }
        layers
    }

    /// Removes the values for which `keep` is false; their parameters have the defaults again.
    pub fn retain(&mut self, keep: impl Fn(&Value<'_>) -> bool) {
        let removed: Vec<_> = self.places().filter(|(_, value)| !keep(value)).map(|(place, _)| place).collect();
        for place in removed {
            self.tree.components[place.0].params[place.1].value = None;
            self.sources.remove(&place);
        }
    }

    /// The values as one batch for [`Tree::set_params`].
    #[must_use]
    pub fn settings(&self) -> Vec<Setting> {
        let setting = |((component, index), Value { param, .. }): (Place, Value<'_>)| {
            Setting::new(ComponentId::new(component), index as u16, param.current())
        };
        self.places().filter(|(_, value)| value.source.is_some()).map(setting).collect()
    }

    /// Sets all values in a tree.
    ///
    /// # Errors
    /// If the tree is not tunable, or the values break a rule between parameters.
    pub fn apply<T: Tree>(&self, tree: &mut T) -> Result<(), Invalid> {
        tree.set_params(&self.settings()).map_err(|refusal| {
            let of_component = self.all().filter(|value| value.component.name == refusal.component);
            let sources: Vec<_> = of_component
                .filter_map(|value| Some(format!("{}={} ({})", value.param.name, value.text(), value.source?)))
                .collect();
            Invalid::new(refusal.to_string(), format!("values that are not defaults: {}", sources.join(", ")))
        })
    }
}
