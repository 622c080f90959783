//! Activation trees of a text.

use bica_syntax::number::hertz;
use bica_syntax::report::Report;
use bica_syntax::text::written;
use bica_syntax::tree::model::{Draft, RoleEntry};
use bica_syntax::tree::parse;
use syn::Macro;
use syn::ext::IdentExt;

use super::{Kind, Outline, Token, lexed};
use crate::model::{Member, Provided, Tree};

/// A tree as its `activation_tree!` declares it, also within another macro.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeSource {
    /// Name of the struct.
    pub name: String,
    /// Cycles per second; 100 if unknown.
    pub cycle_hz: f64,
    /// Names in the list of components.
    pub components: Vec<String>,
    /// Names in the list of roles, each followed by its provider.
    pub roles: Vec<String>,
}

/// Returns the trees of a text.
#[must_use]
pub fn trees(text: &str) -> Vec<TreeSource> {
    let code: Vec<Token<'_>> = lexed(text).into_iter().filter(|token| !token.is_trivia()).collect();
    let begins = |three: &[Token<'_>]| three[0].is("activation_tree") && three[1].text == "!" && three[2].text == "{";
    let calls = code.windows(3).enumerate().filter(|(_, three)| begins(three));
    calls.filter_map(|(at, _)| tree(within(&code[at + 3..]))).collect()
}

fn tree(code: &[Token<'_>]) -> Option<TreeSource> {
    let after = |word: &str| Some(&code[code.iter().position(|token| token.is(word))? + 1..]);
    let name = after("struct")?.first()?.text.to_owned();
    let hz = after("cycle_hz").and_then(|rest| {
        let value = rest.get(1..)?.split(|token| token.text == ",").next()?;
        hertz(&value.iter().map(|token| token.text).collect::<String>())
    });
    let names = |word| {
        let list = after(word).and_then(|rest| rest.get(2..)).unwrap_or_default();
        within(list).iter().filter(|token| token.kind == Kind::Word).map(|token| token.text.to_owned()).collect()
    };
    let cycle_hz = hz.map_or(100.0, f64::from);
    Some(TreeSource { name, cycle_hz, components: names("components"), roles: names("roles") })
}

/// Whether a macro declares a tree.
pub(super) fn is_tree(call: &Macro) -> bool {
    call.path.segments.last().is_some_and(|last| last.ident == "activation_tree")
}

/// Returns the trees of a file outside of other macros, as far as their macro reads them.
pub(crate) fn drafts(outline: &Outline<'_>) -> Vec<Draft> {
    let calls = outline.macros.iter().filter(|call| is_tree(call));
    calls.filter_map(|call| parse::parse(call.tokens.clone(), &mut Report::default())).collect()
}

/// Describes a tree.
pub(super) fn model(draft: &Draft) -> Tree {
    let members = draft.components.iter().flatten().map(|entry| Member {
        name: entry.name.as_ref().map(|name| name.unraw().to_string()),
        ty: written(&entry.kind),
    });
    let provided = |entry: &RoleEntry| Provided { role: written(&entry.role), provider: written(&entry.provider) };
    Tree { name: draft.name.to_string(), members: members.collect(), roles: draft.roles.iter().map(provided).collect() }
}

/// Returns the tokens before the closing bracket.
pub(crate) fn within<'a>(code: &'a [Token<'a>]) -> &'a [Token<'a>] {
    let mut depth = 0_usize;
    let end = code.iter().position(|token| {
        let is_closed = depth == 0 && matches!(token.text, "}" | "]" | ")");
        match token.text {
            "{" | "[" | "(" => depth += 1,
            "}" | "]" | ")" => depth = depth.saturating_sub(1),
            _ => {}
        }
        is_closed
    });
    &code[..end.unwrap_or(code.len())]
}
