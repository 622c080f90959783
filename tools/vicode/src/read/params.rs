//! Structs with `#[derive(Params)]`.

use bica_syntax::text;
use proc_macro2::TokenTree;
use syn::{Attribute, Field, Fields, ItemStruct, Meta};

use super::{Source, docs, settings};
use crate::model::{Name, Parameter, ParameterGroup};

/// Reads a struct; `None` if it holds no parameters.
pub(super) fn group(source: &Source<'_>, item: &ItemStruct) -> Option<ParameterGroup> {
    if !derives(&item.attrs, "Params") {
        return None;
    }
    let fields = match &item.fields {
        Fields::Named(fields) => fields.named.iter().filter_map(|field| parameter(source, field)).collect(),
        _ => Vec::new(),
    };
    Some(ParameterGroup {
        name: source.name(&item.ident),
        span: source.item(item),
        docs: docs::docs(source, &item.attrs),
        parameters: fields,
    })
}

/// Returns whether an item has `#[derive(..., name, ...)]`.
pub(super) fn derives(attributes: &[Attribute], name: &str) -> bool {
    let is_named = |token: TokenTree| matches!(token, TokenTree::Ident(word) if word == name);
    attributes.iter().any(|one| match &one.meta {
        Meta::List(list) => list.path.is_ident("derive") && list.tokens.clone().into_iter().any(is_named),
        _ => false,
    })
}

fn parameter(source: &Source<'_>, field: &Field) -> Option<Parameter> {
    let param = field.attrs.iter().find(|one| one.path().is_ident("param"));
    Some(Parameter {
        name: source.name(field.ident.as_ref()?),
        span: source.item(field),
        docs: docs::docs(source, &field.attrs),
        ty: Name { text: text::written(&field.ty), span: source.of(&field.ty) },
        keys: param.map(|param| settings(source, param)).unwrap_or_default(),
    })
}
