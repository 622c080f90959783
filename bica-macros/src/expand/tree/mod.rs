//! The code of a tree: one file for each thing that is generated.

mod graph;
mod has;
mod layout;
mod owner;
mod roles;
mod slots;
mod stub;

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};

use crate::expand::quoting::{at, placed, settled};
use bica_syntax::text;
use bica_syntax::tree::model::{Entry, Tree};

pub(crate) use stub::stub;

/// Everything of a tree. `number` distinguishes it from others.
pub(crate) fn expand(tree: &Tree, number: u64) -> TokenStream {
    let (owner, own, new) = (owner::expand(tree, number), owner::own(tree, number), owner::new(tree));
    let slots = slots::expand(tree);
    let layout = layout::expand(tree);
    let graph = graph::expand(tree);
    let has = has::expand(tree);
    let roles = roles::expand(tree);
    let names = names(tree);
    quote!(#owner const _: () = { #own #names #new #slots #layout #graph #has #roles };)
}

/// Names for each type that the tree lists. All other code uses these names, so that the compiler finds a path that leads
/// nowhere once.
fn names(tree: &Tree) -> TokenStream {
    let root = root(tree);
    let (names, kinds) = (kinds(tree), tree.components.iter().map(|entry| settled(&entry.kind.to_token_stream())));
    let unlisted = (!names.contains(&root)).then(|| {
        let kind = settled(&tree.root.to_token_stream());
        quote!(type #root = #kind;)
    });
    quote! {
        #(type #names = #kinds;)*
        #unlisted
    }
}

/// The names of the listed types.
fn kinds(tree: &Tree) -> Vec<Ident> {
    let name = |(place, entry): (usize, &Entry)| format_ident!("__Component{place}", span = at(&entry.kind));
    tree.components.iter().enumerate().map(name).collect()
}

/// The name of the root's type.
fn root(tree: &Tree) -> Ident {
    let root = text::written(&tree.root);
    let place = tree.components.iter().position(|entry| text::written(&entry.kind) == root);
    let place = place.map_or_else(|| "Root".to_owned(), |place| place.to_string());
    format_ident!("__Component{place}", span = at(&tree.root))
}

/// The name of the crate for generated code.
fn runtime(tree: &Tree) -> TokenStream {
    format_ident!("__{}Runtime", tree.name).into_token_stream()
}

/// What the slot of a component stores of its parameters.
fn stored(tree: &Tree, kind: &Ident) -> TokenStream {
    let p = placed(&runtime(tree), at(kind));
    if tree.tunable { quote_spanned!(at(kind) => <#kind as #p::Component>::Params) } else { quote!(()) }
}

/// The fields of the struct of the slots, one for each component: its name in small letters and its place.
fn fields(tree: &Tree) -> Vec<Ident> {
    let field = |(place, entry): (usize, &Entry)| {
        let name: String = entry
            .kind
            .to_token_stream()
            .into_iter()
            .filter_map(|token| if let proc_macro2::TokenTree::Ident(word) = token { Some(word) } else { None })
            .last()
            .map(|word| word.to_string().to_lowercase())
            .unwrap_or_default();
        format_ident!("{name}_{place}", span = at(&entry.kind))
    };
    tree.components.iter().enumerate().map(field).collect()
}
