//! Checks of code and names that an edit brings: each must be what it claims to be, and no more.

use ra_ap_parser::LexedStr;
use ra_ap_syntax::ast::{self, HasName};
use ra_ap_syntax::{AstNode, Edition, SyntaxKind};

use super::request::Refusal;
use crate::read::{is_keyword, parse};

/// Refuses an invalid name of a function.
pub(super) fn name(name: &str) -> Result<(), Refusal> {
    if is_keyword(name) {
        return Err(Refusal::new(format!("`{name}` is a keyword of Rust: choose another name")));
    }
    let is_name = matches!(LexedStr::single_token(Edition::Edition2024, name), Some((SyntaxKind::IDENT, None)));
    if is_name && !name.starts_with("r#") {
        return Ok(());
    }
    Err(Refusal::new(format!(
        "`{name}` is no name: use letters, digits and `_`, beginning with a letter, as in `look_for_ball`"
    )))
}

const BRACES: &str = "this code closes more braces than it opens";

/// Refuses code that cannot stand in the braces of a function.
pub(super) fn body(code: &str) -> Result<(), Refusal> {
    only::<ast::Fn>(&format!("fn body() {{\n{code}\n}}"), "this code", BRACES).map(drop)
}

/// Refuses an invalid value.
pub(super) fn value(value: &str, what: &str) -> Result<(), Refusal> {
    one_line(value, what)?;
    let message = format!("`{value}` is no value for {what}");
    only::<ast::Const>(&format!("const VALUE: () = {value};"), what, &message).map(drop)
}

/// Refuses an invalid type of a component.
pub(super) fn ty(ty: &str) -> Result<(), Refusal> {
    one_line(ty, "a type")?;
    let message = format!("`{ty}` is no type of a component: write its name, as in `BallDetector`");
    let alias = only::<ast::TypeAlias>(&format!("type Type = {ty};"), "this type", &message)?;
    if matches!(alias.ty(), Some(ast::Type::PathType(_))) { Ok(()) } else { Err(Refusal::new(message)) }
}

/// Refuses an invalid path of a module.
pub(super) fn path(path: &str) -> Result<(), Refusal> {
    one_line(path, "a path")?;
    let message = format!("`{path}` is no path of a module: write it as in `crate::perception`");
    only::<ast::Use>(&format!("use {path}::Name;"), "this path", &message)?;
    if path.contains(['{', ',', ';', ' ']) { Err(Refusal::new(message)) } else { Ok(()) }
}

/// The names of functions in code for an impl block; refuses other items.
pub(super) fn functions(code: &str) -> Result<Vec<String>, Refusal> {
    let block = only::<ast::Impl>(&format!("impl Block {{\n{code}\n}}"), "this code", BRACES)?;
    let name = |item| match item {
        ast::AssocItem::Fn(function) => Ok(function.name().map(|name| name.text().to_string()).unwrap_or_default()),
        _ => Err(Refusal::new("only functions can be inserted here")),
    };
    let items = block.assoc_item_list().into_iter().flat_map(|list| list.assoc_items().collect::<Vec<_>>());
    let names: Vec<String> = items.map(name).collect::<Result<_, Refusal>>()?;
    if names.is_empty() { Err(Refusal::new("this code has no function")) } else { Ok(names) }
}

fn one_line(code: &str, what: &str) -> Result<(), Refusal> {
    let comment = code.contains("//") || code.contains("/*");
    if code.trim().is_empty() || code.contains(['\n', '\r']) || comment {
        return Err(Refusal::new(format!("{what} must be one line without a comment, not `{}`", code.trim())));
    }
    Ok(())
}

/// The item of a text; refuses, with `message`, what is not this one item.
fn only<Item: AstNode>(text: &str, what: &str, message: &str) -> Result<Item, Refusal> {
    let root = parse(text).ok_or_else(|| Refusal::new(format!("{what} is nested too deeply")))?;
    if let Some(problem) = root.problems.first() {
        return Err(Refusal::new(format!("{what} is no Rust: {}", problem.message)));
    }
    let items: Vec<ast::Item> = root.tree.children().filter_map(ast::Item::cast).collect();
    let item = if let [item] = &items[..] { Item::cast(item.syntax().clone()) } else { None };
    item.ok_or_else(|| Refusal::new(message))
}
