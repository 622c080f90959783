//! Structs with `#[derive(Params)]`.

use ra_ap_syntax::AstNode;
use ra_ap_syntax::ast::{self, HasAttrs, HasName};

use super::attributes::{self, attribute};
use super::tokens::{name, tokens, written};
use super::{docs, span};
use crate::model::{Name, Parameter, ParameterGroup};

/// Reads a struct; `None` if it holds no parameters.
pub(super) fn group(item: &ast::Struct, text: &str) -> Option<ParameterGroup> {
    if !derives(item, "Params") {
        return None;
    }
    let ident = item.name()?;
    let fields = match item.field_list()? {
        ast::FieldList::RecordFieldList(list) => list.fields().filter_map(|field| parameter(&field, text)).collect(),
        ast::FieldList::TupleFieldList(_) => Vec::new(),
    };
    Some(ParameterGroup {
        name: name(ident.text(), span(ident.syntax().text_range())),
        span: span(item.syntax().text_range()),
        docs: docs::docs(item),
        parameters: fields,
    })
}

/// Whether an item has `#[derive(..., name, ...)]`.
pub(super) fn derives(item: &impl HasAttrs, name: &str) -> bool {
    item.attrs().filter_map(|one| attribute(&one)).any(|one| {
        one.name == "derive" && one.list.iter().flat_map(|(_, tokens)| tokens).any(|token| token.name.text == name)
    })
}

fn parameter(field: &ast::RecordField, text: &str) -> Option<Parameter> {
    let (ident, ty) = (field.name()?, field.ty()?);
    let param = field.attrs().filter_map(|one| attribute(&one)).find(|one| one.name == "param");
    let list = param.and_then(|param| param.list);
    Some(Parameter {
        name: name(ident.text(), span(ident.syntax().text_range())),
        span: span(field.syntax().text_range()),
        docs: docs::docs(field),
        ty: Name { text: written(&tokens(ty.syntax())), span: span(ty.syntax().text_range()) },
        keys: list.map(|(_, tokens)| attributes::settings(&tokens, text)).unwrap_or_default(),
    })
}
