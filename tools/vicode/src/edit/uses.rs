//! Uses of a function of a component.

use serde::Serialize;
use syn::Item;

use super::finder::find;
use super::types::Types;
use crate::model::{Component, Span};
use crate::read::{Node, Outline, parse};

/// A place that uses a function of a component, or may use it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Use {
    /// The name.
    pub span: Span,
    /// Whether the type before the name is the component. If not, the text of the file does not decide it.
    pub certain: bool,
}

/// The component whose functions are looked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Target {
    /// Names of its type: its own, and aliases in its file.
    pub(super) names: Vec<String>,
    /// Modules of its file that contain it.
    pub(super) module: String,
    /// Whether other files have a component of that name, so that a path to it decides nothing.
    pub(super) has_namesakes: bool,
}

impl Target {
    /// A component of a file; `has_namesakes` if another file has a component of that name.
    #[must_use]
    pub fn new(text: &str, component: &Component, has_namesakes: bool) -> Self {
        let name = component.name.text.split('<').next().unwrap_or_default();
        let name = name.rsplit("::").next().unwrap_or_default().trim().to_owned();
        let mut target = Self { names: vec![name], module: component.module.clone(), has_namesakes };
        // Without the word nothing has to be parsed.
        let Some(source) = text.contains("type ").then(|| parse(text)).flatten() else { return target };
        let outline = Outline::of(&source);
        let types = Types { target: &target, is_home: true, outline: &outline };
        let names = outline.regions.iter().filter_map(|region| match region.node {
            Node::Item(Item::Type(alias)) if types.of(&alias.ty) == Some(true) => Some(alias.ident.to_string()),
            _ => None,
        });
        let names: Vec<String> = names.collect();
        target.names.extend(names);
        target
    }
}

/// Uses of the function `name` of a component in a text, its definition left out; `is_home` if the text has the component.
#[must_use]
pub fn uses(text: &str, target: &Target, name: &str, is_home: bool) -> Vec<Use> {
    of_each(text, target, &[name], is_home).into_iter().map(|(_, one)| one).collect()
}

/// Uses of each of some functions, as [`uses`] finds them.
pub(super) fn of_each<'a>(text: &str, target: &Target, names: &[&'a str], is_home: bool) -> Vec<(&'a str, Use)> {
    let Some(source) = parse(text) else { return Vec::new() };
    let outline = Outline::of(&source);
    find(Types { target, is_home, outline: &outline }, names)
}
