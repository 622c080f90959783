//! Reading of a file's text into its model. Any text is read: parts with syntax errors are omitted.

mod check;
mod component;
mod docs;
mod lexed;
mod mend;
mod nesting;
mod outline;
mod params;
mod source;
mod tables;
mod trees;

use std::collections::BTreeMap;

use bica_syntax::text::written;
use syn::Item;

use self::component::settings;
pub(crate) use self::lexed::{Kind, Token, is_keyword, lexed};
pub(crate) use self::outline::{Node, Outline};
pub(crate) use self::source::{Source, parse};
pub use self::trees::{TreeSource, trees};
pub(crate) use self::trees::{drafts, within};
use crate::model::{Component, Model, Name, Problem, Span};

/// Reads a file.
#[must_use]
pub fn read(text: &str) -> Model {
    let Some(source) = parse(text) else {
        let span = Span::new(0, text.len());
        let message = "this text is nested too deeply: VICODE does not read it".to_owned();
        return Model { problems: vec![Problem::syntax(span, message)], ..Model::default() };
    };
    let outline = Outline::of(&source);
    let mut model = Model::default();
    for (index, region) in outline.regions.iter().enumerate() {
        match region.node {
            Node::Item(Item::Impl(block)) => {
                model.components.extend(component::component(&source, block, outline.path(index)));
            }
            Node::Item(Item::Struct(item)) => model.parameters.extend(params::group(&source, item)),
            _ => {}
        }
    }
    keyed(&mut model.components);
    model.tables = tables::tables(&source);
    model.trees = drafts(&outline).iter().map(trees::model).collect();
    model.problems.clone_from(&source.problems);
    check::check(&outline, &model.components, &mut model.problems);
    model.problems.sort();
    model.problems.dedup();
    model
}

/// Assigns each component a unique key.
fn keyed(components: &mut [Component]) {
    let mut numbers: BTreeMap<String, u32> = BTreeMap::new();
    for Component { key, module, name, .. } in components {
        *key = if module.is_empty() { name.text.clone() } else { format!("{module}::{}", name.text) };
        let number = numbers.entry(key.clone()).or_default();
        *number += 1;
        if *number > 1 {
            *key = format!("{key}#{number}");
        }
    }
}

/// Returns the functions of impl blocks as `Type::name`, in the order of the text, without nested ones.
pub(crate) fn landmarks(text: &str) -> Vec<(String, Span)> {
    let Some(source) = parse(text) else { return Vec::new() };
    let outline = Outline::of(&source);
    let mut found: Vec<(String, Span)> = Vec::new();
    for (signature, region, block) in outline.methods() {
        let (of, place) = (outline.block(block).map(|block| written(&block.self_ty)), outline.regions[region].span);
        if found.last().is_none_or(|(_, last)| last.end <= place.start) {
            found.push((format!("{}::{}", of.unwrap_or_default(), signature.ident), place));
        }
    }
    found
}

/// Returns the functions of all impl blocks of a component's type, for any of its generic arguments.
pub(crate) fn functions_of(text: &str, component: &Component) -> Vec<Name> {
    let Some(source) = parse(text) else { return Vec::new() };
    let outline = Outline::of(&source);
    let base = |written: &str| written.split('<').next().unwrap_or_default().trim().to_owned();
    let is_own = |block: &usize| {
        outline.path(*block) == component.module
            && outline.block(*block).is_some_and(|block| {
                block.trait_.is_none() && base(&written(&block.self_ty)) == base(&component.name.text)
            })
    };
    let own = outline.methods().filter(|(.., block)| is_own(block));
    own.map(|(signature, ..)| source.name(&signature.ident)).collect()
}
