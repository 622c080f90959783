//! New components: a file, its `mod` line, its entry in a tree.

use syn::{Item, ItemMod, ItemUse, Visibility};

use super::context::Context;
use super::request::Refusal;
use super::splice::Splice;
use super::style::{DEFAULT_WIDTH, Style, indentation, snake};
use super::{fragment, imports};
use crate::model::{Model, Span};
use crate::read::{Outline, Token, lexed, parse, within};

/// Returns the name of the file and module of a component: `wall_finder` for `WallFinder`.
///
/// # Errors
/// If the name is not that of a type, or if the module would be named like a keyword.
pub fn module_of(name: &str) -> Result<String, Refusal> {
    fragment::name(name)?;
    if !name.starts_with(char::is_uppercase) || name.contains('_') {
        return Err(Refusal::new(format!("a component is called like a type: `WallFinder`, not `{name}`")));
    }
    if matches!(name, "Time" | "Rate" | "Age" | "Outcome" | "Tuned" | "Found" | "Work" | "Self") {
        return Err(Refusal::new(format!("`{name}` means something else in signatures: choose another name")));
    }
    let module = snake(name);
    fragment::name(&module)?;
    Ok(module)
}

/// Returns the text of a new component's file: a machine with one state.
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
    let source = parse(text).ok_or_else(|| Refusal::new("this file is nested too deeply"))?;
    let style = Style::of(text, None, DEFAULT_WIDTH);
    let items = &source.file.items;
    let modules: Vec<&ItemMod> =
        items.iter().filter_map(|item| if let Item::Mod(item) = item { Some(item) } else { None }).collect();
    if let Some(taken) = modules.iter().find(|item| item.ident == module) {
        let message = format!("there is a module `{module}` already: choose another name");
        return Err(Refusal::at(source.of(taken), message));
    }
    let plain: Vec<&ItemMod> = modules.into_iter().filter(|item| item.content.is_none()).collect();
    let code = format!("mod {module};");
    let is_private = |item: &ItemMod| matches!(item.vis, Visibility::Inherited);
    let next = plain.iter().find(|item| item.ident.to_string().as_str() > module.as_str() && is_private(item));
    let line = match (next, plain.last()) {
        (Some(next), _) => Splice::insert(source.item(next).start, format!("{code}{}", style.newline)),
        (None, Some(last)) => Splice::insert(source.item(last).end, format!("{}{code}", style.newline)),
        (None, None) => imports::line(&Outline::of(&source), &style, 0, &code),
    };
    let exports: Vec<&ItemUse> =
        imports::uses(items.iter()).filter(|item| !matches!(item.vis, Visibility::Inherited)).collect();
    let export = exports.last().map(|item| {
        let (visibility, place) = (source.of(&item.vis).of(text), source.of(item));
        let this = if place.of(text).contains("self::") { "self::" } else { "" };
        Splice::insert(place.end, format!("{}{visibility} use {this}{module}::{name};", style.newline))
    });
    Ok([line].into_iter().chain(export).collect())
}

/// Adds a component to the list of the first tree of a file, and imports it from `import` if given.
///
/// # Errors
/// If the file has no tree, or the tree has the component.
pub fn enlist(text: &str, model: &Model, name: &str, import: Option<&str>) -> Result<Vec<Splice>, Refusal> {
    fragment::ty(name)?;
    let code: Vec<Token<'_>> = lexed(text).into_iter().filter(|token| !token.is_trivia()).collect();
    let open =
        code.windows(3).position(|three| three[0].is("components") && three[1].text == ":" && three[2].text == "[");
    let Some(open) = open.map(|at| at + 2) else {
        return Err(Refusal::new("no `components: [...]` of an `activation_tree!` is in this file"));
    };
    let list = within(&code[open + 1..]);
    if let Some(taken) = list.iter().find(|token| token.text == name) {
        return Err(Refusal::at(taken.span, format!("the tree has a component `{name}` already")));
    }
    let newline = Style::of(text, None, DEFAULT_WIDTH).newline;
    let start = code[open].span.end;
    let at = list.last().map_or(start, |last| last.span.end);
    let lines = Span::new(start, at).of(text).contains('\n');
    let added = match (list.last().map(|last| last.text), lines) {
        (None, _) => name.to_owned(),
        (Some(","), true) => format!("{newline}{}{name},", indentation(text, at)),
        (Some(","), false) => format!(" {name},"),
        _ => format!(", {name}"),
    };
    let mut splices = vec![Splice::insert(at, added)];
    if let Some(import) = import {
        fragment::path(import)?;
        splices.extend(imports::add(&Context { text, model, width: DEFAULT_WIDTH }, 0, import, name));
    }
    Ok(splices)
}
