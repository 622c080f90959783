//! The impl block of a world with `#[world_actions]`.

use proc_macro2::{Ident, TokenStream};
use syn::parse::ParseStream;
use syn::{Attribute, LitStr, Meta, Path, Token};

use super::block::{Block, Function, Item};
use super::model::Modulation;
use super::operator;
use crate::code::Code;
use crate::report::Report;
use crate::{plain_item, text, wording};

/// An impl block with actions.
pub struct WorldActions {
    /// The block without our attributes.
    pub block: Block,
    /// The actions.
    pub actions: Vec<Action>,
    /// The crate that generated code uses.
    pub krate: Path,
}

/// A method with `#[action]`.
pub struct Action {
    /// Name, doc comment and arguments.
    pub call: Modulation,
    /// Item of the true state that it moves.
    pub moves: Option<String>,
}

/// Reads the item; `None` with the mistake reported if it is no impl block of a type.
pub fn parse(options: TokenStream, item: &TokenStream, report: &mut Report) -> Option<WorldActions> {
    let krate = plain_item::krate("world_actions", options, report);
    let Some(mut block) = Block::read(item) else {
        report.add(item, wording::WORLD_ACTIONS);
        return None;
    };
    if let Some((of, ..)) = &block.header.trait_ {
        report.add(of, wording::WORLD_ACTIONS);
    }
    let own = (*block.header.self_ty).clone();
    let mut actions = Vec::new();
    for item in &mut block.items {
        let Item::Function(function) = item else { continue };
        if block.header.trait_.is_some() {
            take(function, &mut Report::default());
            continue;
        }
        let Some(attribute) = take(function, report) else { continue };
        let call = operator::call(function, "action", &own, report);
        let moves = report.take(moves(&attribute));
        actions.extend(call.zip(moves).map(|(call, moves)| Action { call, moves }));
    }
    if actions.is_empty() && report.is_empty() {
        report.add(&own, wording::NO_ACTION);
    }
    Some(WorldActions { block, actions, krate })
}

/// Takes the attribute `#[action]` off a function, and those that were meant to be it.
fn take(function: &mut Function, report: &mut Report) -> Option<Attribute> {
    let mut ours = function.attributes.extract_if(.., |one| one.path().get_ident().is_some_and(is_meant));
    let found = ours.next();
    if let Some(second) = ours.next() {
        report.add(second, wording::TWICE);
    }
    let name = text::written(found.as_ref()?.path());
    if name != "action" {
        let code = Code::MisspeltAttribute { found: name, meant: "action".to_owned() };
        report.add_code(found?.path(), code);
        return None;
    }
    found
}

/// Whether an attribute is `#[action]`, or was meant to be: a word that is spelt much like it, or one for components.
fn is_meant(name: &Ident) -> bool {
    let name = name.to_string();
    text::distance(&name.to_lowercase(), "action") <= 2
        || ["modulation", "output", "act", "operator"].contains(&name.as_str())
}

/// `#[action]`, `#[action(moves = "cup")]`
fn moves(attribute: &Attribute) -> syn::Result<Option<String>> {
    let list = match &attribute.meta {
        Meta::Path(_) => return Ok(None),
        Meta::List(list) => list,
        Meta::NameValue(_) => return Err(syn::Error::new_spanned(attribute, wording::ACTION_FORM)),
    };
    let item = |input: ParseStream| {
        let form = |found: syn::Error| syn::Error::new(found.span(), wording::ACTION_FORM);
        let key: Ident = input.parse().map_err(form)?;
        if key != "moves" {
            return Err(syn::Error::new(key.span(), wording::ACTION_FORM));
        }
        input.parse::<Token![=]>().map_err(form)?;
        input.parse::<LitStr>().map_err(form).map(|item| item.value())
    };
    list.parse_args_with(item).map(Some)
}
