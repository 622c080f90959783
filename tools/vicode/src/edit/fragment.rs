//! Validation of code and names in edits.

use proc_macro2::Ident;
use syn::{ImplItem, Item, Type};

use super::request::Refusal;
use crate::read::{is_keyword, parse};

/// Refuses an invalid name of a function.
pub(super) fn name(name: &str) -> Result<(), Refusal> {
    if is_keyword(name) {
        return Err(Refusal::new(format!("`{name}` is a keyword of Rust: choose another name")));
    }
    if !name.starts_with("r#") && syn::parse_str::<Ident>(name).is_ok_and(|ident| ident == name) {
        return Ok(());
    }
    Err(Refusal::new(format!(
        "`{name}` is no name: use letters, digits and `_`, beginning with a letter, as in `look_around`"
    )))
}

const BRACES: &str = "this code closes more braces than it opens";

/// Refuses code that is no function body.
pub(super) fn body(code: &str) -> Result<(), Refusal> {
    only(&format!("fn body() {{\n{code}\n}}"), "this code", BRACES).map(drop)
}

/// Refuses an invalid value.
pub(super) fn value(value: &str, what: &str) -> Result<(), Refusal> {
    one_line(value, what)?;
    only(&format!("const VALUE: () = {value};"), what, &format!("`{value}` is no value for {what}")).map(drop)
}

/// Refuses an invalid type of a component.
pub(super) fn ty(ty: &str) -> Result<(), Refusal> {
    one_line(ty, "a type")?;
    let message = format!("`{ty}` is no type of a component: write its name, as in `LineDetector`");
    match only(&format!("type Type = {ty};"), "this type", &message)? {
        Item::Type(item) if matches!(*item.ty, Type::Path(_)) => Ok(()),
        _ => Err(Refusal::new(message)),
    }
}

/// Refuses an invalid type of a child: neither that of a component nor `impl Role`.
pub(super) fn child(child: &str) -> Result<(), Refusal> {
    match child.strip_prefix("impl ") {
        Some(role) => name(role.trim().rsplit("::").next().unwrap_or_default()).and_then(|()| ty(role)),
        None => ty(child),
    }
}

/// Refuses an invalid path of a module.
pub(super) fn path(path: &str) -> Result<(), Refusal> {
    one_line(path, "a path")?;
    let message = format!("`{path}` is no path of a module: write it as in `crate::perception`");
    only(&format!("use {path}::Name;"), "this path", &message)?;
    if path.contains(['{', ',', ';', ' ']) { Err(Refusal::new(message)) } else { Ok(()) }
}

/// Returns the names of the functions in code for an impl block; refuses other items.
pub(super) fn functions(code: &str) -> Result<Vec<String>, Refusal> {
    let Item::Impl(block) = only(&format!("impl Block {{\n{code}\n}}"), "this code", BRACES)? else {
        return Err(Refusal::new(BRACES));
    };
    let name = |item: ImplItem| match item {
        ImplItem::Fn(function) => Ok(function.sig.ident.to_string()),
        _ => Err(Refusal::new("only functions can be inserted here")),
    };
    let names: Vec<String> = block.items.into_iter().map(name).collect::<Result<_, Refusal>>()?;
    if names.is_empty() { Err(Refusal::new("this code has no function")) } else { Ok(names) }
}

fn one_line(code: &str, what: &str) -> Result<(), Refusal> {
    let comment = code.contains("//") || code.contains("/*");
    if code.trim().is_empty() || code.contains(['\n', '\r']) || comment {
        return Err(Refusal::new(format!("{what} must be one line without a comment, not `{}`", code.trim())));
    }
    Ok(())
}

/// Returns the only item of a text; refuses, with `message`, anything else.
fn only(text: &str, what: &str, message: &str) -> Result<Item, Refusal> {
    let mut source = parse(text).ok_or_else(|| Refusal::new(format!("{what} is nested too deeply")))?;
    if let Some(problem) = source.problems.first() {
        return Err(Refusal::new(format!("{what} is no Rust: {}", problem.message)));
    }
    match source.file.items.pop() {
        Some(item) if source.file.items.is_empty() => Ok(item),
        _ => Err(Refusal::new(message)),
    }
}
