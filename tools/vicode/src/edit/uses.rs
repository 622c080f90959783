//! Uses of a component's functions.

use syn::Item;

use super::finder::find;
use super::target::{Target, Use};
use super::types::Types;
use crate::model::Component;
use crate::read::{Node, Outline, parse};

impl Target {
    /// A component of a file; `has_namesakes` if another file has a component of that name.
    #[must_use]
    pub fn new(text: &str, component: &Component, has_namesakes: bool) -> Self {
        let name = component.name.text.split('<').next().unwrap_or_default();
        let name = name.rsplit("::").next().unwrap_or_default().trim().to_owned();
        let mut target = Self { names: vec![name], module: component.module.clone(), has_namesakes };
        // A text without `type` has no aliases, and is not parsed.
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

/// Returns the uses of a component's function `name` in a text, without its definition; `is_home`: the text contains the component.
#[must_use]
pub fn uses(text: &str, target: &Target, name: &str, is_home: bool) -> Vec<Use> {
    of_each(text, target, &[name], is_home).into_iter().map(|(_, one)| one).collect()
}

/// Returns the uses of several functions, as [`uses`] does.
pub(super) fn of_each<'a>(text: &str, target: &Target, names: &[&'a str], is_home: bool) -> Vec<(&'a str, Use)> {
    let Some(source) = parse(text) else { return Vec::new() };
    let outline = Outline::of(&source);
    find(Types { target, is_home, outline: &outline }, names)
}
