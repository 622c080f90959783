//! Uses of a function.

use ra_ap_syntax::{SyntaxKind, T};
use serde::Serialize;

use crate::model::{Component, Span};
use crate::read::{Token, parse, tokens};

/// A place outside of a component's block that may use one of its functions.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Use {
    /// The name.
    pub span: Span,
    /// Whether the component is named before it. If not, it is a method call of something whose type is not known here.
    pub certain: bool,
}

/// Uses of the function `name` of the component `component` in a text, except those within the block `own` of the component.
#[must_use]
pub fn uses(text: &str, component: &str, name: &str, own: Option<Span>) -> Vec<Use> {
    let all = all_tokens(text);
    let mut uses = Vec::new();
    for (index, token) in named(&all, name).filter(|(_, token)| own.is_none_or(|own| !own.contains(token.name.span))) {
        let certain = match before(&all[..index]) {
            Before::Path(path) if path == simple(component) => true,
            Before::Dot(_) if all.get(index + 1).is_some_and(is_call) => false,
            _ => continue,
        };
        uses.push(Use { span: token.name.span, certain });
    }
    uses
}

/// Uses within the block, and those by the component's name in all of the file.
pub(super) fn in_block(text: &str, component: &Component, name: &str) -> Vec<Span> {
    in_tokens(&all_tokens(text), component, name)
}

/// Uses of each of some functions, as [`in_block`] finds them.
pub(super) fn of_each<'a>(
    text: &str,
    component: &Component,
    names: impl Iterator<Item = &'a str>,
) -> Vec<(&'a str, Vec<Span>)> {
    let all = all_tokens(text);
    names.map(|name| (name, in_tokens(&all, component, name))).collect()
}

fn in_tokens(all: &[Token], component: &Component, name: &str) -> Vec<Span> {
    let own = simple(&component.name.text);
    let used = |(index, token): &(usize, &Token)| {
        let within = component.span.contains(token.name.span);
        match before(&all[..*index]) {
            Before::Path(path) => path == own || within && path == "Self",
            Before::Dot(value) => within && value == "self" && all.get(index + 1).is_some_and(is_call),
            Before::Other => false,
        }
    };
    named(all, name).filter(used).map(|(_, token)| token.name.span).collect()
}

/// `Eye` of `Eye<320, 240>`
fn simple(component: &str) -> &str {
    component.split('<').next().unwrap_or(component).rsplit("::").next().unwrap_or(component).trim()
}

fn all_tokens(text: &str) -> Vec<Token> {
    parse(text).map(|root| tokens(&root.tree)).unwrap_or_default()
}

fn named<'a>(all: &'a [Token], name: &'a str) -> impl Iterator<Item = (usize, &'a Token)> {
    all.iter().enumerate().filter(move |(_, token)| token.kind == SyntaxKind::IDENT && token.name.text == name)
}

/// Whether a token can follow the name of a called function: `(` or `::<`.
fn is_call(token: &Token) -> bool {
    matches!(token.kind, T!['('] | T![:] | T![::])
}

/// What stands before a name.
enum Before<'a> {
    /// `Path::`
    Path(&'a str),
    /// `value.`
    Dot(&'a str),
    Other,
}

/// What ends with these tokens. Within a macro the colons of a path are two tokens, elsewhere one.
fn before(tokens: &[Token]) -> Before<'_> {
    match tokens {
        [.., path, one, other] if one.kind == T![:] && other.kind == T![:] => Before::Path(&path.name.text),
        [.., path, colons] if colons.kind == T![::] => Before::Path(&path.name.text),
        [.., value, dot] if dot.kind == T![.] => Before::Dot(&value.name.text),
        _ => Before::Other,
    }
}
