//! The code of a tree: one file for each thing that is generated.

mod graph;
mod has;
mod layout;
mod owner;
mod slots;
mod stub;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use syn::Type;

use crate::expand::quoting::{at, placed};
use bica_syntax::tree::model::Tree;

pub(crate) use stub::stub;

/// Everything of a tree.
pub(crate) fn expand(tree: &Tree) -> TokenStream {
    let owner = owner::expand(tree);
    let slots = slots::expand(tree);
    let layout = layout::expand(tree);
    let graph = graph::expand(tree);
    let has = has::expand(tree);
    quote!(#owner #slots #layout #graph #has)
}

/// The path to what generated code uses.
fn runtime(tree: &Tree) -> TokenStream {
    let krate = &tree.krate;
    quote!(#krate::__private)
}

/// What the slot of a component stores of its parameters.
fn stored(tree: &Tree, kind: &Type) -> TokenStream {
    let p = placed(&runtime(tree), at(kind));
    if tree.tunable { quote_spanned!(at(kind) => <#kind as #p::Component>::Params) } else { quote!(()) }
}

/// The struct of the slots.
fn slots(tree: &Tree) -> Ident {
    format_ident!("__{}Slots", tree.name)
}

/// The fields of that struct, one for each component: its name in small letters and its place.
fn fields(tree: &Tree) -> Vec<Ident> {
    let field = |(place, entry): (usize, &bica_syntax::tree::model::Entry)| {
        let name: String = quote::ToTokens::to_token_stream(&entry.kind)
            .into_iter()
            .filter_map(|token| if let proc_macro2::TokenTree::Ident(word) = token { Some(word) } else { None })
            .last()
            .map(|word| word.to_string().to_lowercase())
            .unwrap_or_default();
        format_ident!("{name}_{place}")
    };
    tree.components.iter().enumerate().map(field).collect()
}
