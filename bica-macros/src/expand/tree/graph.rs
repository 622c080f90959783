//! `GRAPH`, and its check.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};

use super::runtime;
use crate::expand::quoting::{at, option, placed};
use crate::language::text;
use crate::language::tree::model::Tree;

pub(super) fn expand(tree: &Tree, sound: bool) -> TokenStream {
    let p = runtime(tree);
    let (name, root, cycle_hz) = (&tree.name, tree.root, tree.cycle_hz);
    let label = name.to_string();
    let doc = text::doc(&tree.attributes);
    let budget_ms = option(tree.budget_ms.as_ref());
    let nodes = tree.components.iter().map(|entry| {
        let (kind, label) = (&entry.kind, text::written(&entry.kind));
        quote!(#p::node::<#name, #kind>(#label))
    });
    let check = sound.then(|| {
        let p = placed(&p, at(name));
        quote_spanned!(at(name) => const _: () = #p::check(&<#name as #p::Tree>::GRAPH);)
    });
    quote! {
        #[automatically_derived]
        impl #p::Tree for #name {
            const GRAPH: #p::Graph = #p::Graph {
                name: #label,
                doc: #p::doc(#doc),
                cycle_hz: #cycle_hz,
                budget_ms: #budget_ms,
                root: #root,
                nodes: &[#(#nodes),*],
            };
        }

        #check
    }
}
