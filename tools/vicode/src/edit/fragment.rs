//! Checks of code and names that an edit brings: each must be what it claims to be, and no more.

use ra_ap_parser::LexedStr;
use ra_ap_syntax::ast::{self, HasName};
use ra_ap_syntax::{AstNode, Edition, SyntaxKind};

use super::request::Refusal;
use crate::read::parse;

/// Refuses what is no name for a function.
pub(super) fn name(name: &str) -> Result<(), Refusal> {
    match LexedStr::single_token(Edition::Edition2024, name) {
        Some((SyntaxKind::IDENT, None)) if !name.starts_with("r#") => Ok(()),
        Some((kind, _)) if kind.is_keyword(Edition::Edition2024) => {
            Err(Refusal::new(format!("`{name}` is a keyword of Rust: choose another name")))
        }
        _ => Err(Refusal::new(format!(
            "`{name}` is no name: take letters, digits and `_`, and begin with a letter, as in `look_for_ball`"
        ))),
    }
}

/// Refuses code that cannot stand in the braces of a function.
pub(super) fn body(code: &str) -> Result<(), Refusal> {
    let items = items(&format!("fn body() {{\n{code}\n}}"), "this code")?;
    match &items[..] {
        [ast::Item::Fn(_)] => Ok(()),
        _ => Err(Refusal::new("this code closes more braces than it opens")),
    }
}

/// Refuses what is no value.
pub(super) fn value(value: &str, what: &str) -> Result<(), Refusal> {
    one_line(value, what)?;
    match &items(&format!("const VALUE: () = {value};"), what)?[..] {
        [ast::Item::Const(_)] => Ok(()),
        _ => Err(Refusal::new(format!("`{value}` is no value for {what}"))),
    }
}

/// Refuses what is no type of a component.
pub(super) fn ty(ty: &str) -> Result<(), Refusal> {
    one_line(ty, "a type")?;
    let items = items(&format!("type Type = {ty};"), "this type")?;
    let is_path = |item: &ast::TypeAlias| matches!(item.ty(), Some(ast::Type::PathType(_)));
    match &items[..] {
        [ast::Item::TypeAlias(alias)] if is_path(alias) => Ok(()),
        _ => Err(Refusal::new(format!("`{ty}` is no type of a component: write its name, as in `BallDetector`"))),
    }
}

/// Refuses what is no path of a module.
pub(super) fn path(path: &str) -> Result<(), Refusal> {
    one_line(path, "a path")?;
    match &items(&format!("use {path}::Name;"), "this path")?[..] {
        [ast::Item::Use(_)] if !path.contains(['{', ',', ';', ' ']) => Ok(()),
        _ => Err(Refusal::new(format!("`{path}` is no path of a module: write it as in `crate::perception`"))),
    }
}

/// The names of functions in code for an impl block; refuses other items.
pub(super) fn functions(code: &str) -> Result<Vec<String>, Refusal> {
    let items = items(&format!("impl Block {{\n{code}\n}}"), "this code")?;
    let [ast::Item::Impl(block)] = &items[..] else {
        return Err(Refusal::new("this code closes more braces than it opens"));
    };
    let list = block.assoc_item_list();
    let name = |item| match item {
        ast::AssocItem::Fn(function) => Ok(function.name().map(|name| name.text().to_string()).unwrap_or_default()),
        _ => Err(Refusal::new("only functions can be inserted here")),
    };
    let names: Vec<String> =
        list.iter().flat_map(ast::AssocItemList::assoc_items).map(name).collect::<Result<_, Refusal>>()?;
    if names.is_empty() { Err(Refusal::new("this code has no function")) } else { Ok(names) }
}

fn one_line(code: &str, what: &str) -> Result<(), Refusal> {
    let comment = code.contains("//") || code.contains("/*");
    if code.trim().is_empty() || code.contains(['\n', '\r']) || comment {
        return Err(Refusal::new(format!("{what} stands on one line without a comment: `{}` does not", code.trim())));
    }
    Ok(())
}

/// The items of a text that is Rust.
fn items(text: &str, what: &str) -> Result<Vec<ast::Item>, Refusal> {
    let root = parse(text).ok_or_else(|| Refusal::new(format!("{what} is nested too deeply")))?;
    if let Some(problem) = root.problems.first() {
        return Err(Refusal::new(format!("{what} is no Rust: {}", problem.message)));
    }
    Ok(root.tree.children().filter_map(ast::Item::cast).collect())
}
