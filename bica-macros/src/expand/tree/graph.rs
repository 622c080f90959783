//! `GRAPH`, and its check.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};

use super::{kinds, root, runtime};
use crate::expand::quoting::{at, option, placed};
use bica_syntax::text;
use bica_syntax::tree::model::Tree;

pub(super) fn expand(tree: &Tree) -> TokenStream {
    let p = runtime(tree);
    let (name, root, cycle_hz) = (&tree.name, root(tree), tree.cycle_hz);
    let root = quote_spanned!(at(&root) => <Self as #p::Has<#root>>::INDEX);
    let label = text::name(name);
    let doc = text::doc(&tree.attributes);
    let budget_ms = option(tree.budget_ms.as_ref());
    let nodes = tree.components.iter().zip(kinds(tree)).map(|(entry, kind)| {
        let (label, written) = (entry.label(), text::written(&entry.kind));
        let written = option(entry.name.as_ref().map(|_| written).as_ref());
        quote!(#p::node::<#name, #kind>(#label, #written))
    });
    let roles = tree.roles.iter().map(super::roles::name);
    let check = check(tree, &p);
    let tunable = tree.tunable;
    quote! {
        #[automatically_derived]
        impl #p::Tree for #name {
            const GRAPH: #p::Graph = #p::Graph {
                name: #label,
                doc: #p::doc(#doc),
                cycle_hz: #cycle_hz,
                budget_ms: #budget_ms,
                tunable: #tunable,
                version: ::core::option_env!("CARGO_PKG_VERSION"),
                commit: ::core::option_env!("GIT_COMMIT"),
                root: #root,
                nodes: &[#(#nodes),*],
                roles: &[#(#roles),*],
            };
        }

        #check
    }
}

/// The rules for the tree as a whole, unless a component has mistakes of its own.
fn check(tree: &Tree, p: &TokenStream) -> TokenStream {
    let name = &tree.name;
    let kinds = kinds(tree);
    let stubs = quote!(#(#p::is_stub::<#name, #kinds>()),*);
    let p = placed(p, at(name));
    quote_spanned!(at(name) => const _: () = #p::check_complete(&<#name as #p::Tree>::GRAPH, &[#stubs]);)
}
