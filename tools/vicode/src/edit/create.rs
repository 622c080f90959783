//! New components: a file, its `mod` line, its entry in a tree.

use std::iter::successors;

use ra_ap_syntax::ast::{self, HasName, HasVisibility};
use ra_ap_syntax::{AstNode, T};

use super::plan::Context;
use super::request::Refusal;
use super::splice::Splice;
use super::style::{Style, indentation, snake};
use super::types::previous;
use super::{fragment, imports};
use crate::DEFAULT_WIDTH;
use crate::model::{Model, Span};
use crate::read::{content, parse, span};

/// The name of the file and module of a component: `ball_keeper` of `BallKeeper`.
///
/// # Errors
/// If the name is not that of a type, or if the module would be named like a keyword.
pub fn module_of(name: &str) -> Result<String, Refusal> {
    fragment::name(name)?;
    if !name.starts_with(|first: char| first.is_ascii_uppercase())
        || !name.chars().all(|one| one.is_ascii_alphanumeric())
    {
        return Err(Refusal::new(format!("a component is called like a type: `BallKeeper`, not `{name}`")));
    }
    if matches!(name, "Time" | "Rate" | "Tuned" | "Self") {
        return Err(Refusal::new(format!("`{name}` means something else in signatures: choose another name")));
    }
    let module = snake(name);
    fragment::name(&module)?;
    Ok(module)
}

/// The file of a new component: a machine with one state.
#[must_use]
pub fn blank(name: &str) -> String {
    format!(
        "//! What `{name}` does.\n\nuse bica::prelude::*;\n\n/// What `{name}` does.\n#[derive(Debug)]\npub struct {name};\n\n\
         #[component]\nimpl {name} {{\n    /// Creates the component.\n    #[must_use]\n    pub const fn new() -> Self {{\n        \
         Self\n    }}\n\n    /// What it does first.\n    #[state(initial, last)]\n    fn begin(&mut self) {{}}\n}}\n"
    )
}

/// Declares the module of a new component in the file of its parent, and exports the component if the file exports others.
///
/// # Errors
/// If the file has such a module or name already.
pub fn declare(text: &str, name: &str) -> Result<Vec<Splice>, Refusal> {
    let module = module_of(name)?;
    let root = parse(text).ok_or_else(|| Refusal::new("this file is nested too deeply"))?;
    let style = Style::of(text, None, DEFAULT_WIDTH);
    let place = |node: &ra_ap_syntax::SyntaxNode| span(node.text_range());
    let modules: Vec<ast::Module> = root.tree.children().filter_map(ast::Module::cast).collect();
    let named = |item: &ast::Module| item.name().map(|name| name.text().to_string()).unwrap_or_default();
    if let Some(taken) = modules.iter().find(|item| named(item) == module) {
        return Err(Refusal::at(
            place(taken.syntax()),
            format!("there is a module `{module}` already: choose another name"),
        ));
    }
    let plain: Vec<&ast::Module> = modules.iter().filter(|item| item.item_list().is_none()).collect();
    let code = format!("mod {module};");
    let next = plain.iter().find(|item| named(item) > module && item.visibility().is_none());
    let line = match (next, plain.last()) {
        (Some(next), _) => Splice::insert(place(next.syntax()).start, format!("{code}{}", style.newline)),
        (None, Some(last)) => Splice::insert(place(last.syntax()).end, format!("{}{code}", style.newline)),
        (None, None) => imports::line(text, &style, &root.tree, &code),
    };
    let exports = root.tree.children().filter_map(ast::Use::cast).filter(|item| item.visibility().is_some());
    let export = exports.last().map(|item| {
        let visibility = item.visibility().map(|one| one.syntax().text().to_string()).unwrap_or_default();
        let this = if place(item.syntax()).of(text).contains("self::") { "self::" } else { "" };
        Splice::insert(place(item.syntax()).end, format!("{}{visibility} use {this}{module}::{name};", style.newline))
    });
    Ok([line].into_iter().chain(export).collect())
}

/// Adds a component to the list of the first tree of a file, and imports it from `import` if given.
///
/// # Errors
/// If the file has no tree, or the tree has the component.
pub fn enlist(text: &str, model: &Model, name: &str, import: Option<&str>) -> Result<Vec<Splice>, Refusal> {
    fragment::ty(name)?;
    let root = parse(text);
    let trees = root.iter().flat_map(|root| root.tree.descendants()).filter_map(ast::TokenTree::cast);
    let is_list = |tree: &ast::TokenTree| {
        let before: Vec<_> =
            tree.syntax().first_token().iter().flat_map(|open| successors(previous(open), previous)).take(2).collect();
        matches!(&before[..], [colon, key] if colon.kind() == T![:] && key.text() == "components")
    };
    let Some((place, list)) = trees.filter(is_list).map(|tree| content(&tree)).next() else {
        return Err(Refusal::new("no `components: [...]` of an `activation_tree!` is in this file"));
    };
    if let Some(taken) = list.iter().find(|token| token.name.text == name) {
        return Err(Refusal::at(taken.name.span, format!("the tree has a component `{name}` already")));
    }
    let newline = Style::of(text, None, DEFAULT_WIDTH).newline;
    let at = list.last().map_or(place.start, |last| last.name.span.end);
    let lines = Span::new(place.start, at).of(text).contains('\n');
    let added = match (list.last().map(|last| last.kind), lines) {
        (None, _) => name.to_owned(),
        (Some(T![,]), true) => format!("{newline}{}{name},", indentation(text, at)),
        (Some(T![,]), false) => format!(" {name},"),
        _ => format!(", {name}"),
    };
    let mut splices = vec![Splice::insert(at, added)];
    if let Some(import) = import {
        fragment::path(import)?;
        splices.extend(imports::add(&Context { text, model, width: DEFAULT_WIDTH }, 0, import, name));
    }
    Ok(splices)
}
