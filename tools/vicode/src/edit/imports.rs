//! `use` lines.

use ra_ap_syntax::ast::{self, HasAttrs, HasVisibility};
use ra_ap_syntax::{AstNode, SyntaxKind, SyntaxNode};

use super::fragment;
use super::plan::Context;
use super::request::Refusal;
use super::splice::Splice;
use super::style::{Style, indentation, line_end, line_start, starts_line};
use super::types::{imported, named};
use crate::model::Span;
use crate::read::{scope, span, tokens};

/// `Eye` of `Eye<320, 240>`; nothing of a path.
fn name_of(child: &str) -> Option<&str> {
    let name = child.split('<').next().unwrap_or(child).trim();
    (!name.contains("::")).then_some(name)
}

/// The `use` items of the file itself or of a module.
fn items(scope: &SyntaxNode) -> Vec<ast::Use> {
    scope.children().filter_map(ast::Use::cast).collect()
}

/// Whether only this module sees what an item imports, and always: an item with `pub` or `cfg` is not.
fn is_plain(item: &ast::Use) -> bool {
    let is_condition = |one: ast::Attr| matches!(one.meta(), Some(ast::Meta::CfgMeta(_)));
    item.visibility().is_none() && !item.attrs().any(is_condition)
}

/// Imports a child from a module, unless its name is known in the module of the file that contains the byte `at`.
pub(super) fn add(context: &Context<'_>, at: usize, path: &str, child: &str) -> Vec<Splice> {
    let Some(name) = name_of(child) else { return Vec::new() };
    let text = context.text;
    let Some(scope) = scope(text, at).filter(|scope| !is_known(scope, name)) else { return Vec::new() };
    let style = Style::of(text, None, context.width);
    let all = items(&scope);
    for item in all.iter().filter(|item| is_plain(item)).filter_map(ast::Use::use_tree) {
        let Some(of) = item.path().map(|path| path.syntax().text().to_string()) else { continue };
        if let (true, Some(list)) = (of == path, item.use_tree_list()) {
            return into_list(text, &style, &list, name);
        }
        let single = item.use_tree_list().is_none() && item.star_token().is_none();
        if let (true, Some((module, last))) = (single, of.rsplit_once("::"))
            && module == path
        {
            let last = item.rename().map_or(last.to_owned(), |rename| format!("{last} {}", rename.syntax().text()));
            let mut names = [last, name.to_owned()];
            names.sort();
            return vec![Splice::new(span(item.syntax().text_range()), format!("{path}::{{{}}}", names.join(", ")))];
        }
    }
    vec![line(text, &style, &scope, &format!("use {path}::{name};"))]
}

/// Imports a name from a module.
///
/// # Errors
/// If path or name are none, or if the file knows the name.
pub(super) fn name(context: &Context<'_>, path: &str, name: &str) -> Result<Vec<Splice>, Refusal> {
    fragment::path(path)?;
    fragment::name(name)?;
    if scope(context.text, 0).is_some_and(|scope| is_known(&scope, name)) {
        return Err(Refusal::new(format!("`{name}` is known in this file already: it needs no import")));
    }
    Ok(add(context, 0, path, name))
}

/// Whether a module has the name: by `use`, or by an item.
fn is_known(scope: &SyntaxNode, name: &str) -> bool {
    let trees = items(scope).into_iter().flat_map(|item| item.syntax().descendants().filter_map(ast::UseTree::cast));
    let has = |node| match ast::Item::cast(node) {
        Some(ast::Item::Struct(item)) => named(&item, name),
        Some(ast::Item::Enum(item)) => named(&item, name),
        Some(ast::Item::TypeAlias(item)) => named(&item, name),
        _ => false,
    };
    let known = trees.map(|tree| imported(&tree, name)).any(|path| path.is_some()) || scope.children().any(has);
    // `use super::*` brings the names of the module around it.
    let outer = || {
        scope.ancestors().skip(1).find(|node| [SyntaxKind::ITEM_LIST, SyntaxKind::SOURCE_FILE].contains(&node.kind()))
    };
    let takes_all =
        || items(scope).iter().any(|item| item.use_tree().is_some_and(|tree| tree.syntax().text() == "super::*"));
    known || takes_all() && outer().is_some_and(|outer| is_known(&outer, name))
}

/// Adds a name at its place in `{a, b}`.
fn into_list(text: &str, style: &Style, list: &ast::UseTreeList, name: &str) -> Vec<Splice> {
    let trees: Vec<(String, Span)> =
        list.use_trees().map(|tree| (tree.syntax().text().to_string(), span(tree.syntax().text_range()))).collect();
    let whole = span(list.syntax().text_range());
    let Some((_, last)) = trees.last() else { return vec![Splice::insert(whole.start + 1, name)] };
    let next = trees.iter().find(|(tree, _)| tree.as_str() > name);
    let splice = match next {
        Some((_, next)) => Splice::insert(next.start, format!("{name}, ")),
        None => Splice::insert(last.end, format!(", {name}")),
    };
    let line = &text[line_start(text, splice.span.start)..line_end(text, splice.span.start)];
    let simple = !whole.of(text).contains(['/', '{']) || !whole.of(text)[1..].contains(['/', '{']);
    if line.chars().count() + name.chars().count() + 2 <= style.width || !simple {
        return vec![splice];
    }
    let mut names: Vec<String> = trees.into_iter().map(|(tree, _)| tree).collect();
    let place = names.iter().position(|tree| tree.as_str() > name).unwrap_or(names.len());
    names.insert(place, name.to_owned());
    vec![Splice::new(whole, filled(style, &names))]
}

/// `{`, lines as long as they may be, `}`
fn filled(style: &Style, names: &[String]) -> String {
    let mut result = String::from("{");
    let mut length = usize::MAX;
    for name in names {
        let added = name.chars().count() + 2;
        if length.saturating_add(added) > style.width + 1 {
            result.push_str(style.newline);
            result.push_str("    ");
            length = 4;
        } else {
            result.push(' ');
        }
        result.push_str(name);
        result.push(',');
        length += added;
    }
    result + style.newline + "}"
}

/// Adds a `use` line where it belongs among the others.
pub(super) fn line(text: &str, style: &Style, scope: &SyntaxNode, new: &str) -> Splice {
    let (newline, all) = (style.newline, items(scope));
    let place = |item: &ast::Use| span(item.syntax().text_range());
    let of = |item: &ast::Use| place(item).of(text).to_owned();
    let first_word = |line: &str| line.trim_start_matches("use ").split("::").next().unwrap_or_default().to_owned();
    let same = |key: &dyn Fn(&str) -> String| all.iter().filter(|item| key(&of(item)) == key(new)).collect::<Vec<_>>();
    // The lines of the same crate, else those of the same kind.
    let group = Some(same(&first_word)).filter(|group| !group.is_empty());
    let group = group.unwrap_or_else(|| same(&|line| kind(&first_word(line)).to_owned()));
    if let Some(next) = group.iter().find(|item| of(item).as_str() > new && starts_line(text, place(item).start)) {
        let at = place(next).start;
        return Splice::insert(at, format!("{new}{newline}{}", indentation(text, at)));
    }
    if let Some(last) = group.last().copied().or(all.last()) {
        let lines = if group.is_empty() { newline.repeat(2) } else { newline.to_owned() };
        let Span { start, end } = place(last);
        return Splice::insert(end, format!("{lines}{}{new}", indentation(text, start)));
    }
    let at = first_item(scope);
    let behind = if text[at..].starts_with(['\n', '\r']) { String::new() } else { newline.repeat(2) };
    let indent = if behind.is_empty() { "" } else { indentation(text, at) };
    Splice::insert(at, format!("{new}{behind}{indent}"))
}

/// Kind of a `use` line by its first word. Each kind is a paragraph.
fn kind(first_word: &str) -> &'static str {
    match first_word {
        "std" | "core" | "alloc" => "library",
        "crate" | "self" | "super" => "own",
        _ => "other",
    }
}

/// Offset of the first item, after the docs and attributes of the module.
fn first_item(scope: &SyntaxNode) -> usize {
    let item = scope.children().find(|node| node.kind() != SyntaxKind::ATTR);
    item.map_or(span(scope.text_range()).end, |node| span(node.text_range()).start)
}

/// Removes an import that only the link at `place` needed.
pub(super) fn remove(context: &Context<'_>, child: &str, place: Span) -> Vec<Splice> {
    let Some(name) = name_of(child) else { return Vec::new() };
    let text = context.text;
    let Some(scope) = scope(text, place.start) else { return Vec::new() };
    let all = items(&scope);
    let spans: Vec<Span> = all.iter().map(|item| span(item.syntax().text_range())).collect();
    let elsewhere = |at: Span| !place.contains(at) && !spans.iter().any(|item| item.contains(at));
    if tokens(&scope).iter().any(|token| token.name.text == name && elsewhere(token.name.span)) {
        return Vec::new();
    }
    for item in all.iter().filter(|item| is_plain(item)) {
        let Some(tree) = item.use_tree() else { continue };
        if let Some(list) = tree.use_tree_list() {
            let trees: Vec<_> = list.use_trees().collect();
            let Some(index) = trees.iter().position(|tree| tree.syntax().text() == name) else { continue };
            let at = |index: usize| span(trees[index].syntax().text_range());
            return match (index + 1 < trees.len(), index) {
                (true, _) => vec![Splice::remove(Span::new(at(index).start, at(index + 1).start))],
                (false, 0) => vec![whole_line(text, span(item.syntax().text_range()))],
                (false, _) => vec![Splice::remove(Span::new(at(index - 1).end, at(index).end))],
            };
        }
        let last = tree.path().and_then(|path| path.segment()).is_some_and(|last| last.syntax().text() == name);
        if last && tree.rename().is_none() && tree.star_token().is_none() {
            return vec![whole_line(text, span(item.syntax().text_range()))];
        }
    }
    Vec::new()
}

fn whole_line(text: &str, item: Span) -> Splice {
    let end = line_end(text, item.end);
    if !starts_line(text, item.start) || !text[item.end..end].trim().is_empty() {
        return Splice::remove(item);
    }
    let next = text[end..].find('\n').map_or(text.len(), |newline| end + newline + 1);
    Splice::remove(Span::new(line_start(text, item.start), next))
}
