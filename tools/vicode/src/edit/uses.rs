//! Uses of a function of a component.

use ra_ap_syntax::ast::HasName;
use ra_ap_syntax::{AstNode, NodeOrToken, SyntaxKind, SyntaxToken, T, ast};
use serde::Serialize;

use super::types::{Types, before_separator, next, previous};
use crate::model::{Component, Span};
use crate::read::{parse, span};

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
        let root = text.contains("type ").then(|| parse(text)).flatten();
        let aliases = root.iter().flat_map(|root| root.tree.descendants()).filter_map(ast::TypeAlias::cast);
        let is_item = |alias: &ast::TypeAlias| {
            alias.syntax().parent().is_some_and(|parent| parent.kind() != SyntaxKind::ASSOC_ITEM_LIST)
        };
        let types = Types { target: &target, is_home: true };
        let of_target = aliases.filter(is_item).filter(|alias| alias.ty().and_then(|ty| types.of(&ty)) == Some(true));
        let names: Vec<String> =
            of_target.filter_map(|alias| alias.name()).map(|name| name.text().to_string()).collect();
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
    let Some(root) = parse(text) else { return Vec::new() };
    let types = Types { target, is_home };
    let mut uses = Vec::new();
    for token in root.tree.descendants_with_tokens().filter_map(NodeOrToken::into_token) {
        if is_doc(&token) {
            uses.extend(names.iter().flat_map(|name| in_docs(&types, &token, name)));
        } else if let (SyntaxKind::IDENT, Some(name)) =
            (token.kind(), names.iter().find(|name| **name == token.text().trim_start_matches("r#")))
        {
            match verdict(&types, &token) {
                Some(false) => {}
                decided => uses.push((*name, Use { span: span(token.text_range()), certain: decided.is_some() })),
            }
        }
    }
    uses
}

/// Whether a name stands for the function; `None` if the text does not decide it.
fn verdict(types: &Types<'_>, token: &SyntaxToken) -> Option<bool> {
    if let Some(of) = before_separator(token) {
        return types.before_colons(&of);
    }
    let is_call = next(token).is_some_and(|next| matches!(next.kind(), T!['('] | T![::] | T![:]));
    match previous(token) {
        Some(dot) if is_call && dot.kind() == T![.] => types.of_receiver(&previous(&dot)?),
        // `self.0.f()` within a macro: the number has the dot.
        Some(number) if is_call && number.kind() == SyntaxKind::FLOAT_NUMBER => None,
        _ => Some(false),
    }
}

/// Whether a token is a doc comment or the text of `#[doc = "..."]`.
fn is_doc(token: &SyntaxToken) -> bool {
    let attribute =
        || token.parent_ancestors().find_map(ast::Attr::cast)?.path()?.syntax().text().eq("doc").then_some(());
    match token.kind() {
        SyntaxKind::COMMENT => ["///", "//!", "/**", "/*!"].iter().any(|mark| token.text().starts_with(mark)),
        SyntaxKind::STRING => attribute().is_some(),
        _ => false,
    }
}

/// Paths to the function in a doc comment: `Self::name`, `Player::name`.
fn in_docs<'a>(types: &Types<'_>, comment: &SyntaxToken, name: &'a str) -> Vec<(&'a str, Use)> {
    let text = comment.text();
    let is_word = |one: char| one.is_alphanumeric() || one == '_';
    let found = text.match_indices(name).filter(|(at, _)| {
        let path = text[..*at].strip_suffix("::");
        let path = path.and_then(|path| path.rsplit(|one: char| !is_word(one) && one != ':').next());
        let ends = !text[at + name.len()..].starts_with(is_word);
        ends && path
            .is_some_and(|path| types.of_path(&path.split("::").collect::<Vec<_>>(), &comment.clone()) == Some(true))
    });
    let start = usize::from(comment.text_range().start());
    found.map(|(at, _)| (name, Use { span: Span::new(start + at, start + at + name.len()), certain: true })).collect()
}
