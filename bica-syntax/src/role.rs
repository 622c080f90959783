//! The trait of a role.

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::{
    FnArg, GenericParam, ItemTrait, Path, ReturnType, Signature, TraitItem, TraitItemFn, TraitItemType, parse_quote,
};

use crate::component::signature::borrows;
use crate::report::Report;
use crate::{plain_item, text, wording};

/// A trait with `#[role]`.
pub struct Role {
    /// The trait. Methods and types with mistakes have the bound `Self: Sized`, so that the compiler does not refuse `dyn Trait`, too.
    pub item: ItemTrait,
    /// The crate that generated code uses.
    pub krate: Path,
}

/// Reads the item; `None` with the mistake reported if it is no trait.
pub fn parse(options: TokenStream, item: &TokenStream, report: &mut Report) -> Option<Role> {
    let krate = plain_item::krate("role", options, report);
    let Ok(mut item) = syn::parse2::<ItemTrait>(item.clone()) else {
        report.add(first_line(item), wording::NO_TRAIT);
        return None;
    };
    if !item.generics.params.is_empty() {
        report.add(&item.generics, wording::ROLE_GENERIC);
        item.generics = parse_quote!();
    }
    if !item.supertraits.is_empty() {
        report.add(std::mem::take(&mut item.supertraits), wording::ROLE_SUPERTRAIT);
        item.colon_token = None;
    }
    let types: Vec<_> = item.items.iter().filter_map(associated).map(|one| text::name(&one.ident)).collect();
    item.items.retain_mut(|one| match one {
        TraitItem::Fn(method) => {
            check(method, &types, report);
            true
        }
        TraitItem::Type(of) => {
            report.add(&*of, wording::ROLE_ITEM);
            of.generics.make_where_clause().predicates.push(parse_quote!(Self: ::core::marker::Sized));
            true
        }
        other => {
            report.add(other, wording::ROLE_ITEM);
            false
        }
    });
    Some(Role { item, krate })
}

/// The tokens of an item up to its braces.
fn first_line(item: &TokenStream) -> TokenStream {
    item.clone().into_iter().take_while(|token| !matches!(token, TokenTree::Group(_))).collect()
}

fn associated(item: &TraitItem) -> Option<&TraitItemType> {
    if let TraitItem::Type(of) = item { Some(of) } else { None }
}

/// Reports what a call without knowledge of the type cannot have. `types` are those of the trait, which are reported.
fn check(method: &mut TraitItemFn, types: &[String], report: &mut Report) {
    let mut own = Report::default();
    signature(&method.sig, types, &mut own);
    if !own.is_empty() || !types.is_empty() {
        method.sig.generics.make_where_clause().predicates.push(parse_quote!(Self: ::core::marker::Sized));
    }
    own.into_mistakes().for_each(|mistake| report.push(mistake));
}

fn signature(method: &Signature, own: &[String], report: &mut Report) {
    if let Some(token) = &method.asyncness {
        report.add(token, wording::ROLE_ASYNC);
    }
    let parameters = method.generics.params.pairs();
    let types: TokenStream = parameters
        .filter(|pair| !matches!(pair.value(), GenericParam::Lifetime(_)))
        .map(ToTokens::into_token_stream)
        .collect();
    if !types.is_empty() {
        report.add(types, wording::ROLE_GENERIC);
    }
    match method.inputs.first() {
        Some(FnArg::Receiver(receiver)) if borrows(receiver) => {}
        other => {
            let problem = wording::role_receiver(&text::name(&method.ident));
            match other {
                Some(FnArg::Receiver(receiver)) => report.add(receiver, problem),
                _ => report.add(&method.ident, problem),
            }
        }
    }
    let arguments = method.inputs.iter().filter_map(|input| match input {
        FnArg::Typed(input) => Some(input.ty.to_token_stream()),
        FnArg::Receiver(_) => None,
    });
    let result = match &method.output {
        ReturnType::Type(_, kind) => Some(kind.to_token_stream()),
        ReturnType::Default => None,
    };
    let is_reported =
        |kind: &TokenStream| own.iter().any(|name| text::written(kind).contains(&format!("Self::{name}")));
    for kind in arguments.chain(result).filter(|kind| is_open(kind.clone()) && !is_reported(kind)) {
        report.add(kind, wording::ROLE_TYPE);
    }
}

/// Whether a type depends on the one that implements the trait or on the caller.
fn is_open(kind: TokenStream) -> bool {
    kind.into_iter().any(|token| match token {
        TokenTree::Ident(name) => name == "Self" || name == "impl",
        TokenTree::Group(group) => is_open(group.stream()),
        _ => false,
    })
}
