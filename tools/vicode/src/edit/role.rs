//! Renaming of roles: complete, or refused with the place that cannot be decided.

use syn::Item;

use super::context::Context;
use super::create::module_of;
use super::request::Refusal;
use super::splice::Splice;
use super::style::line_number;
use crate::model::Span;
use crate::read::{Kind, Node, Outline, Source, Token, parse};

/// Words after which a name is that of another item.
const DEFINES: [&str; 9] = ["struct", "enum", "union", "type", "fn", "const", "static", "mod", "let"];

/// Renames a role: its trait, its uses in signatures, trees, imports and implementations, and links to it in doc comments.
pub(super) fn rename(context: &Context<'_>, role: &str, to: &str) -> Result<Vec<Splice>, Refusal> {
    if role == to {
        return Ok(Vec::new());
    }
    module_of(to)?;
    let source = parse(context.text).ok_or_else(|| Refusal::new("this file is nested too deeply"))?;
    let code: Vec<&Token<'_>> = source.tokens.iter().filter(|token| !token.is_trivia()).collect();
    let at =
        |what: &str, span: Span| Refusal::at(span, format!("line {}: {what}", line_number(context.text, span.start)));
    if let Some(taken) = code.iter().find(|token| token.is(to)) {
        return Err(at(&format!("this file has a `{to}` already: choose another name"), taken.span));
    }
    let places: Vec<usize> = (0..code.len()).filter(|index| code[*index].is(role)).collect();
    let is_role = |index: &usize| {
        let before = index.checked_sub(1).map_or("", |before| code[before].text);
        before == "trait" && is_marked(&code, *index) || before == "impl"
    };
    let in_trees = crate::read::trees(context.text).into_iter().any(|tree| tree.roles.iter().any(|one| one == role));
    if !in_trees && !places.iter().any(is_role) {
        return Err(Refusal::new(format!("this file has no role `{role}`")));
    }
    if let Some(span) = undecided(&source, &code, &places, role) {
        return Err(at(&format!("this `{role}` may be no role: rename it in the code"), span));
    }
    let links = source.tokens.iter().filter(|token| token.is_doc()).flat_map(|token| links(token, role));
    let names = places.iter().map(|index| code[*index].span);
    Ok(names.chain(links).map(|span| Splice::new(span, to)).collect())
}

/// Returns whether `#[role]` stands before a trait, with other attributes and a visibility between.
fn is_marked(code: &[&Token<'_>], name: usize) -> bool {
    let before = code[..name].iter().rev().take_while(|token| !matches!(token.text, "}" | ";" | "{"));
    before.into_iter().any(|token| token.is("role"))
}

/// Returns the first place at which the name may be that of something else.
fn undecided(source: &Source<'_>, code: &[&Token<'_>], places: &[usize], role: &str) -> Option<Span> {
    let outline = Outline::of(source);
    let variants = outline.regions.iter().filter_map(|region| match region.node {
        Node::Item(Item::Enum(item)) => Some(&item.variants),
        _ => None,
    });
    let variant = variants.flatten().find(|variant| variant.ident == role).map(|variant| source.of(&variant.ident));
    let parameter = outline.parameters.iter().find(|(one, _)| one.ident == role).map(|(one, _)| source.of(&one.ident));
    // The path before the name, which all its uses share.
    let mut path: Option<&str> = None;
    let mut traits = 0;
    let other = places.iter().find(|&&index| {
        let before = |back: usize| index.checked_sub(back).map_or("", |at| code[at].text);
        traits += usize::from(before(1) == "trait");
        let is_other = traits > 1 || before(1) == "." || DEFINES.contains(&before(1));
        let of = if before(1) == ":" && before(2) == ":" { before(3) } else { "" };
        let is_path = !matches!(of, "" | "{" | "crate" | "self" | "super");
        is_other || is_path && *path.get_or_insert(of) != of
    });
    variant.or(parameter).or_else(|| other.map(|index| code[*index].span))
}

/// Returns the links to a role in a doc comment: ``[`Ball`]``, ``[`Ball::position`]``, `[Ball]`.
fn links(comment: &Token<'_>, role: &str) -> Vec<Span> {
    if comment.kind != Kind::Comment {
        return Vec::new();
    }
    let found = comment.text.match_indices(role).filter(|(at, _)| {
        let (before, behind) = (&comment.text[..*at], &comment.text[at + role.len()..]);
        let is_link = before.ends_with("[`") || before.ends_with('[') || before.ends_with("::");
        let is_path = before.rsplit('[').next().is_some_and(|path| !path.contains([' ', ']']));
        is_link
            && is_path
            && before.contains('[')
            && !behind.starts_with(|one: char| one.is_alphanumeric() || one == '_')
    });
    found.map(|(at, _)| Span::new(comment.span.start + at, comment.span.start + at + role.len())).collect()
}
