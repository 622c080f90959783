//! Uses of a function of a component.

use serde::Serialize;
use syn::Item;

use super::types::Types;
use crate::model::{Component, Span};
use crate::read::{Node, Outline, Token, parse};

/// A place that uses a function of a component, or may use it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Use {
    /// The name.
    pub span: Span,
    /// Whether the type before the name is the component. If not, the text of the file does not decide it.
    pub certain: bool,
}

/// The component whose functions are looked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Target {
    /// Names of its type: its own, and aliases in its file.
    pub(super) names: Vec<String>,
    /// Modules of its file that contain it.
    pub(super) module: String,
    /// Whether other files have a component of that name, so that a path to it decides nothing.
    pub(super) has_namesakes: bool,
}

impl Target {
    /// A component of a file; `has_namesakes` if another file has a component of that name.
    #[must_use]
    pub fn new(text: &str, component: &Component, has_namesakes: bool) -> Self {
        let name = component.name.text.split('<').next().unwrap_or_default();
        let name = name.rsplit("::").next().unwrap_or_default().trim().to_owned();
        let mut target = Self { names: vec![name], module: component.module.clone(), has_namesakes };
        // Without the word nothing has to be parsed.
        let Some(source) = text.contains("type ").then(|| parse(text)).flatten() else { return target };
        let outline = Outline::of(&source);
        let types = Types::new(&outline, &target, true);
        let names = outline.regions.iter().filter_map(|region| match region.node {
            Node::Item(Item::Type(alias)) if types.of(&alias.ty) == Some(true) => Some(alias.ident.to_string()),
            _ => None,
        });
        let names: Vec<String> = names.collect();
        target.names.extend(names);
        target
    }
}

/// Uses of the function `name` of a component in a text, its definition left out; `is_home` if the text has the component.
#[must_use]
pub fn uses(text: &str, target: &Target, name: &str, is_home: bool) -> Vec<Use> {
    of_each(text, target, &[name], is_home).into_iter().map(|(_, one)| one).collect()
}

/// Uses of each of some functions, as [`uses`] finds them.
pub(super) fn of_each<'a>(text: &str, target: &Target, names: &[&'a str], is_home: bool) -> Vec<(&'a str, Use)> {
    let Some(source) = parse(text) else { return Vec::new() };
    let outline = Outline::of(&source);
    let types = Types::new(&outline, target, is_home);
    let comments = source.tokens.iter().filter(|token| token.is_doc());
    let texts = types.code.windows(3).filter(|three| three[0].is("doc") && three[1].text == "=").map(|three| &three[2]);
    let docs = comments.chain(texts).flat_map(|token| names.iter().flat_map(|name| in_docs(&types, token, name)));
    let mut uses: Vec<(&str, Use)> = docs.collect();
    for (index, token) in types.code.iter().enumerate() {
        let Some(name) = names.iter().find(|name| token.is(name)) else { continue };
        let certain = verdict(&types, index);
        if certain != Some(false) {
            uses.push((name, Use { span: token.span, certain: certain.is_some() }));
        }
    }
    uses.sort_by_key(|(_, one)| one.span);
    uses
}

/// Whether a name stands for the function; `None` if the text does not decide it.
fn verdict(types: &Types<'_>, token: usize) -> Option<bool> {
    if let Some(of) = types.before_separator(token) {
        return types.before_colons(of);
    }
    let is_call = types.code[token + 1..].first().is_some_and(|next| matches!(next.text, "(" | ":"));
    types.before_dot(token).filter(|_| is_call).map_or(Some(false), |of| types.of_receiver(of))
}

/// Paths to the function in a doc comment: `Self::name`, `Player::name`.
fn in_docs<'a>(types: &Types<'_>, comment: &Token<'_>, name: &'a str) -> Vec<(&'a str, Use)> {
    let (text, start) = (comment.text, comment.span.start);
    let is_word = |one: char| one.is_alphanumeric() || one == '_';
    let found = text.match_indices(name).filter(|(at, _)| {
        let path = text[..*at].strip_suffix("::");
        let path = path.and_then(|path| path.rsplit(|one: char| !is_word(one) && one != ':').next());
        let ends = !text[at + name.len()..].starts_with(is_word);
        ends && path.is_some_and(|path| types.of_path(&path.split("::").collect::<Vec<_>>(), start) == Some(true))
    });
    found.map(|(at, _)| (name, Use { span: Span::new(start + at, start + at + name.len()), certain: true })).collect()
}
