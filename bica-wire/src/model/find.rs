//! Search by name.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::{Component, Description, Invalid};

/// Minimum similarity, 0 to 1, of a name that is suggested in place of an unknown one.
const MIN_SIMILARITY: f64 = 0.6;

impl Description {
    /// Finds a component by name.
    ///
    /// # Errors
    /// If there is none; the remedy is the most similar name.
    pub fn component(&self, name: &str) -> Result<usize, Invalid> {
        let names: Vec<_> = self.components.iter().map(|component| component.name.as_str()).collect();
        find(name, &names)
            .ok_or_else(|| Invalid::new(format!("there is no component `{name}`"), remedy(name, &names, "the tree")))
    }

    /// Finds a parameter by `Component.name`: the indices of the component and of the parameter.
    ///
    /// # Errors
    /// As [`component`](Self::component).
    pub fn param(&self, path: &str) -> Result<(usize, usize), Invalid> {
        self.member(path, "parameter", |component| component.params.iter().map(|param| param.name.as_str()).collect())
    }

    /// Finds an output by `Component.name`: the indices of the component and of the output.
    ///
    /// # Errors
    /// As [`component`](Self::component).
    pub fn output(&self, path: &str) -> Result<(usize, usize), Invalid> {
        self.member(path, "output", |component| component.outputs.iter().map(|output| output.name.as_str()).collect())
    }

    /// Finds a modulation by `Component.name`: the indices of the component and of the modulation.
    ///
    /// # Errors
    /// As [`component`](Self::component).
    pub fn modulation(&self, path: &str) -> Result<(usize, usize), Invalid> {
        self.member(path, "modulation", |component| {
            component.modulations.iter().map(|modulation| modulation.name.as_str()).collect()
        })
    }

    /// Finds a state by `Component.name`: the indices of the component and of the state.
    ///
    /// # Errors
    /// As [`component`](Self::component).
    pub fn machine_state(&self, path: &str) -> Result<(usize, usize), Invalid> {
        self.member(path, "state", |component| component.states.iter().map(|state| state.name.as_str()).collect())
    }

    /// Finds an action of the world by name.
    ///
    /// # Errors
    /// As [`component`](Self::component).
    pub fn action(&self, name: &str) -> Result<usize, Invalid> {
        let names: Vec<_> = self.actions.iter().map(|action| action.name.as_str()).collect();
        let unknown = || Invalid::new(format!("the world has no action `{name}`"), remedy(name, &names, "it"));
        find(name, &names).ok_or_else(unknown)
    }

    /// Returns the name of a state of a component.
    #[must_use]
    pub fn state(&self, component: usize, state: Option<usize>) -> Option<&str> {
        self.components.get(component)?.states.get(state?).map(|state| state.name.as_str())
    }

    fn member(
        &self,
        path: &str,
        what: &str,
        names: impl for<'a> Fn(&'a Component) -> Vec<&'a str>,
    ) -> Result<(usize, usize), Invalid> {
        let Some((component, name)) = path.split_once('.') else {
            let text = format!("`{path}` is not the name of a {what}");
            return Err(Invalid::new(text, "write it as `Component.name`"));
        };
        let index = self.component(component)?;
        let names = names(&self.components[index]);
        let found = find(name, &names)
            .ok_or_else(|| Invalid::new(format!("`{component}` has no {what} `{name}`"), remedy(name, &names, "it")));
        Ok((index, found?))
    }
}

fn find(name: &str, names: &[&str]) -> Option<usize> {
    names.iter().position(|known| *known == name)
}

/// Returns the most similar name as a remedy, or all names of `owner` if none is similar.
fn remedy(name: &str, names: &[&str], owner: &str) -> String {
    let similarity = |known: &&str| strsim::normalized_damerau_levenshtein(&name.to_lowercase(), &known.to_lowercase());
    let nearest = names.iter().max_by(|one, two| similarity(one).total_cmp(&similarity(two)));
    match nearest.filter(|known| similarity(known) >= MIN_SIMILARITY) {
        Some(nearest) => format!("did you mean `{nearest}`?"),
        None if names.is_empty() => format!("{owner} has none"),
        None => {
            let names: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
            format!("{owner} has {}", names.join(", "))
        }
    }
}
