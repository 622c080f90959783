//! `use` lines.

use syn::{Item, ItemUse, UseGroup, UseTree, Visibility};

use super::context::Context;
use super::fragment;
use super::request::Refusal;
use super::splice::Splice;
use super::style::{Style, indentation, line_end, line_start, starts_line};
use crate::model::Span;
use crate::read::{Outline, Source, parse};

/// Returns `Eye` for `Eye<320, 240>`, `Ball` for `impl Ball`; `None` for a path.
fn name_of(child: &str) -> Option<&str> {
    let child = child.strip_prefix("impl ").unwrap_or(child);
    let name = child.split('<').next().unwrap_or(child).trim();
    (!name.contains("::")).then_some(name)
}

/// Filters the `use` items.
pub(super) fn uses<'a>(items: impl Iterator<Item = &'a Item>) -> impl Iterator<Item = &'a ItemUse> {
    items.filter_map(|item| if let Item::Use(item) = item { Some(item) } else { None })
}

/// Returns the `use` items of a module.
fn of_module<'a>(outline: &Outline<'a>, module: usize) -> Vec<&'a ItemUse> {
    uses(outline.items(module).unwrap_or_default().iter().copied()).collect()
}

/// An imported name.
pub(super) struct Import {
    /// Segments of its path.
    pub(super) path: Vec<String>,
    /// Name in this scope; `None` for a glob.
    pub(super) name: Option<String>,
}

/// Returns the names that a tree of `use` imports below `path`.
pub(super) fn imports(tree: &UseTree, mut path: Vec<String>) -> Vec<Import> {
    let name = match tree {
        UseTree::Path(tree) => {
            path.push(tree.ident.to_string());
            return imports(&tree.tree, path);
        }
        UseTree::Group(group) => return group.items.iter().flat_map(|tree| imports(tree, path.clone())).collect(),
        UseTree::Glob(_) => None,
        UseTree::Name(tree) => {
            path.push(tree.ident.to_string());
            path.last().cloned()
        }
        UseTree::Rename(tree) => {
            path.push(tree.ident.to_string());
            Some(tree.rename.to_string())
        }
    };
    vec![Import { path, name }]
}

/// Splits a tree of `use` into the path of a module, as `one::two`, and its names.
fn split(tree: &UseTree) -> (String, &UseTree) {
    let (mut path, mut rest) = (Vec::new(), tree);
    while let UseTree::Path(tree) = rest {
        path.push(tree.ident.to_string());
        rest = &tree.tree;
    }
    (path.join("::"), rest)
}

/// Returns whether an item imports for this module only, in every build: without `pub` and `cfg`.
fn is_plain(item: &ItemUse) -> bool {
    matches!(item.vis, Visibility::Inherited) && !item.attrs.iter().any(|one| one.path().is_ident("cfg"))
}

/// Imports a child, unless its name is in scope in the module around the offset `at`.
pub(super) fn add(context: &Context<'_>, at: usize, path: &str, child: &str) -> Vec<Splice> {
    let (Some(name), Some(source)) = (name_of(child), parse(context.text)) else { return Vec::new() };
    let outline = Outline::of(&source);
    let module = outline.module(at);
    if is_known(&outline, module, name) {
        return Vec::new();
    }
    let style = Style::of(context.text, None, context.width);
    for item in of_module(&outline, module).into_iter().filter(|item| is_plain(item)) {
        match split(&item.tree) {
            (of, UseTree::Group(list)) if of == path => return into_list(&source, &style, list, name),
            (of, last @ (UseTree::Name(_) | UseTree::Rename(_))) if of == path => {
                let mut names = [source.of(last).of(context.text), name];
                names.sort_unstable();
                return vec![Splice::new(source.of(&item.tree), format!("{path}::{{{}}}", names.join(", ")))];
            }
            _ => {}
        }
    }
    vec![line(&outline, &style, module, &format!("use {path}::{name};"))]
}

/// Imports a name from a module.
///
/// # Errors
/// If path or name are invalid, or the name is in scope already.
pub(super) fn name(context: &Context<'_>, path: &str, name: &str) -> Result<Vec<Splice>, Refusal> {
    fragment::path(path)?;
    fragment::name(name)?;
    if parse(context.text).is_some_and(|source| is_known(&Outline::of(&source), 0, name)) {
        return Err(Refusal::new(format!("`{name}` is known in this file already: it needs no import")));
    }
    Ok(add(context, 0, path, name))
}

/// Returns whether a name is in scope in a module, by `use` or by an item.
fn is_known(outline: &Outline<'_>, module: usize, name: &str) -> bool {
    let all: Vec<Import> =
        of_module(outline, module).into_iter().flat_map(|item| imports(&item.tree, Vec::new())).collect();
    let is_item = |item: &&Item| match item {
        Item::Struct(item) => item.ident == name,
        Item::Enum(item) => item.ident == name,
        Item::Type(item) => item.ident == name,
        _ => false,
    };
    // `use super::*` imports the names of the outer module.
    let takes_all = all.iter().any(|one| one.name.is_none() && one.path == ["super"]);
    let outer = || outline.outwards(Some(module)).skip(1).find(|region| outline.items(*region).is_some());
    all.iter().any(|one| one.name.as_deref() == Some(name))
        || outline.items(module).unwrap_or_default().iter().any(is_item)
        || takes_all && outer().is_some_and(|outer| is_known(outline, outer, name))
}

/// Inserts a name in order into `{a, b}`.
fn into_list(source: &Source<'_>, style: &Style, list: &UseGroup, name: &str) -> Vec<Splice> {
    let text = source.text;
    let places = list.items.iter().map(|tree| source.of(tree));
    let trees: Vec<(String, Span)> = places.map(|place| (place.of(text).to_owned(), place)).collect();
    let whole = source.of(&list.brace_token.span.join());
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

/// Formats a list of names in braces with filled lines.
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

/// Inserts a `use` line in order among the others of a module.
pub(super) fn line(outline: &Outline<'_>, style: &Style, module: usize, new: &str) -> Splice {
    let (source, newline, all) = (outline.source, style.newline, of_module(outline, module));
    let text = source.text;
    let of = |item: &ItemUse| source.of(item).of(text).to_owned();
    let first_word = |line: &str| line.trim_start_matches("use ").split("::").next().unwrap_or_default().to_owned();
    let same = |key: &dyn Fn(&str) -> String| all.iter().filter(|item| key(&of(item)) == key(new)).collect::<Vec<_>>();
    // The lines of the same crate, else those of the same kind.
    let group = Some(same(&first_word)).filter(|group| !group.is_empty());
    let group = group.unwrap_or_else(|| same(&|line| kind(&first_word(line)).to_owned()));
    let starts = |item: &ItemUse| starts_line(text, source.item(item).start);
    if let Some(next) = group.iter().find(|item| of(item).as_str() > new && starts(item)) {
        let at = source.item(next).start;
        return Splice::insert(at, format!("{new}{newline}{}", indentation(text, at)));
    }
    if let Some(last) = group.last().copied().or(all.last()) {
        let lines = if group.is_empty() { newline.repeat(2) } else { newline.to_owned() };
        let Span { start, end } = source.of(last);
        return Splice::insert(end, format!("{lines}{}{new}", indentation(text, start)));
    }
    // After the docs and attributes of the module.
    let first = outline.items(module).and_then(|items| items.first().map(|item| source.item(item).start));
    let at = first.unwrap_or(outline.regions[module].span.end);
    let behind = if text[at..].starts_with(['\n', '\r']) { String::new() } else { newline.repeat(2) };
    let indent = if behind.is_empty() { "" } else { indentation(text, at) };
    Splice::insert(at, format!("{new}{behind}{indent}"))
}

/// Returns the kind of a `use` line by its first segment. Each kind is a paragraph.
fn kind(first_word: &str) -> &'static str {
    match first_word {
        "std" | "core" | "alloc" => "library",
        "crate" | "self" | "super" => "own",
        _ => "other",
    }
}

/// Removes an import that only the link at `place` uses.
pub(super) fn remove(context: &Context<'_>, child: &str, place: Span) -> Vec<Splice> {
    let (Some(name), Some(source)) = (name_of(child), parse(context.text)) else { return Vec::new() };
    let outline = Outline::of(&source);
    let module = outline.module(place.start);
    let (all, around) = (of_module(&outline, module), outline.regions[module].span);
    let spans: Vec<Span> = all.iter().map(|item| source.of(*item)).collect();
    let elsewhere =
        |at: Span| around.contains(at) && !place.contains(at) && !spans.iter().any(|item| item.contains(at));
    if source.tokens.iter().any(|token| token.is(name) && elsewhere(token.span)) {
        return Vec::new();
    }
    for item in all.into_iter().filter(|item| is_plain(item)) {
        let is_name = |tree: &UseTree| matches!(tree, UseTree::Name(tree) if tree.ident == name);
        match split(&item.tree).1 {
            UseTree::Group(list) => {
                let Some(index) = list.items.iter().position(is_name) else { continue };
                let at = |index: usize| source.of(&list.items[index]);
                return match (index + 1 < list.items.len(), index) {
                    (true, _) => vec![Splice::remove(Span::new(at(index).start, at(index + 1).start))],
                    (false, 0) => vec![whole_line(context.text, source.item(item))],
                    (false, _) => vec![Splice::remove(Span::new(at(index - 1).end, at(index).end))],
                };
            }
            tree if is_name(tree) => return vec![whole_line(context.text, source.item(item))],
            _ => {}
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
