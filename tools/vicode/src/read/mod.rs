//! From the text of a file to its model. Reads any text: what cannot be understood is left out.

mod attributes;
mod block;
mod check;
mod docs;
mod function;
mod nesting;
mod params;
mod tokens;

use std::collections::BTreeMap;

use ra_ap_syntax::ast::HasName;
use ra_ap_syntax::{AstNode, Edition, SourceFile, SyntaxNode, TextRange, ast};

use crate::model::{Component, Model, Name, Problem, Reporter, Span};

pub(crate) use self::attributes::content;
pub(crate) use self::tokens::{Token, is_keyword, lexed, tokens};

/// Reads a file.
#[must_use]
pub fn read(text: &str) -> Model {
    let Some(root) = parse(text) else {
        let span = Span::new(0, text.len());
        let message = "this text is nested too deeply: VICODE does not read it".to_owned();
        return Model { problems: vec![Problem { span, message, from: Reporter::Syntax }], ..Model::default() };
    };
    let text = &root.tree.to_string();
    let mut model = Model::default();
    for node in root.tree.descendants() {
        if let Some(block) = ast::Impl::cast(node.clone()) {
            model.components.extend(block::component(&block, text));
        } else if let Some(item) = ast::Struct::cast(node) {
            model.parameters.extend(params::group(&item, text));
        }
    }
    keyed(&mut model.components);
    model.problems = root.problems;
    check::check(&root.tree, text, &mut model.problems);
    model.problems.sort();
    model.problems.dedup();
    model
}

/// Gives each component the key that no other one has.
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

/// The modules and functions of the file that contain a node, as `one::two`.
pub(crate) fn module_of(node: &SyntaxNode) -> String {
    let name = |node| match ast::Item::cast(node)? {
        ast::Item::Module(module) => module.name(),
        ast::Item::Fn(function) => function.name(),
        _ => None,
    };
    let mut names: Vec<String> = node.ancestors().filter_map(name).map(|name| name.text().to_string()).collect();
    names.reverse();
    names.join("::")
}

/// The list of items that contains the byte `at`: of the innermost module around it, else of the file.
pub(crate) fn scope(text: &str, at: usize) -> Option<SyntaxNode> {
    let root = parse(text)?.tree;
    let lists = root.descendants().filter_map(ast::Module::cast).filter_map(|module| module.item_list());
    let around = lists.filter(|list| span(list.syntax().text_range()).contains(Span::at(at)));
    Some(around.last().map_or_else(|| root.clone(), |list| list.syntax().clone()))
}

/// A syntax tree, and where the text is no Rust.
pub(crate) struct Root {
    pub(crate) tree: SyntaxNode,
    pub(crate) problems: Vec<Problem>,
}

/// Parses a file; `None` if it is nested so deeply that the parser's stack could overflow.
pub(crate) fn parse(text: &str) -> Option<Root> {
    // A byte order mark is no Rust; spaces of its length keep all offsets.
    let plain = text.strip_prefix('\u{feff}').map(|rest| match rest.strip_prefix("#!") {
        // The first line of a script, which nothing may precede.
        Some(script) if !script.trim_start().starts_with('[') => format!("//   {script}"),
        _ => format!("   {rest}"),
    });
    let text = plain.as_deref().unwrap_or(text);
    if nesting::is_too_deep(text) {
        return None;
    }
    let parse = SourceFile::parse(text, Edition::Edition2024);
    // The parser places an error of a string's content within a character if it is not ASCII.
    let whole = |Span { start, end }| Span::new(text.floor_char_boundary(start), text.ceil_char_boundary(end));
    let problem = |error: &ra_ap_syntax::SyntaxError| Problem {
        span: whole(span(error.range())),
        message: error.to_string(),
        from: Reporter::Syntax,
    };
    // The compiler reads `\r\n` as a line end also within a string.
    let line_end = |problem: &Problem| text[problem.span.start..].starts_with("\r\n");
    let problems = parse.errors().iter().map(problem).filter(|problem| !line_end(problem)).collect();
    Some(Root { tree: parse.syntax_node(), problems })
}

/// The place of a node or token.
pub(crate) fn span(range: TextRange) -> Span {
    Span::new(range.start().into(), range.end().into())
}

/// Without the brackets.
fn within(span: Span) -> Span {
    Span::new(span.start + 1, span.end.saturating_sub(1).max(span.start + 1))
}

/// The functions of all impl blocks, each with its block, in the order of the text.
fn functions(root: &SyntaxNode) -> impl Iterator<Item = (ast::Impl, ast::Fn)> {
    let function = |item: SyntaxNode| {
        let item = ast::Fn::cast(item)?;
        Some((ast::Impl::cast(item.syntax().parent()?.parent()?)?, item))
    };
    root.descendants().filter_map(function)
}

/// The functions of impl blocks with the names of their types, in the order of the text, those within another one left out.
pub(crate) fn landmarks(text: &str) -> Vec<(String, Span)> {
    let root = parse(text);
    let mut found: Vec<(String, Span)> = Vec::new();
    for (block, item) in root.iter().flat_map(|root| functions(&root.tree)) {
        let of = block.self_ty().map(|ty| tokens::written(&tokens(ty.syntax()))).unwrap_or_default();
        let Some(name) = item.name() else { continue };
        let place = Span::new(function::start(item.syntax()), span(item.syntax().text_range()).end);
        if found.last().is_none_or(|(_, last)| last.end <= place.start) {
            found.push((format!("{of}::{}", name.text()), place));
        }
    }
    found
}

/// The functions of all impl blocks of a component's type, whatever its arguments.
pub(crate) fn functions_of(text: &str, component: &Component) -> Vec<Name> {
    let root = parse(text);
    let base = |written: &str| written.split('<').next().unwrap_or_default().trim().to_owned();
    let is_own = |block: &ast::Impl| {
        let ty = block.self_ty().map(|ty| base(&ty.syntax().text().to_string()));
        block.for_token().is_none()
            && module_of(block.syntax()) == component.module
            && ty == Some(base(&component.name.text))
    };
    let all = root.iter().flat_map(|root| functions(&root.tree)).filter(|(block, _)| is_own(block));
    let names = all.filter_map(|(_, item)| item.name());
    names.map(|ident| tokens::name(ident.text(), span(ident.syntax().text_range()))).collect()
}
