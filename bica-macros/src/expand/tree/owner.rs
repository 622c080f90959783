//! The struct that the user names.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote, quote_spanned};

use super::{fields, kinds, runtime, slots};
use crate::expand::quoting::{at, placed};
use bica_syntax::tree::model::Tree;

pub(super) fn expand(tree: &Tree) -> TokenStream {
    let p = runtime(tree);
    let (attributes, visibility, name, slots) = (&tree.attributes, &tree.visibility, &tree.name, slots(tree));
    let values = tree.components.iter().zip(kinds(tree)).map(|(entry, kind)| {
        let kind = &kind;
        let new = || quote_spanned!(at(kind) => <#kind>::new());
        let value = entry.value.as_ref().map_or_else(new, |value| quote!(#value));
        if tree.tunable {
            let (p, name) = (placed(&p, at(kind)), placed(&name.to_token_stream(), at(kind)));
            let params = quote_spanned!(at(kind) => <#kind as #p::Component>::DEFAULT_PARAMS);
            quote_spanned!(at(kind) => #p::Slot::with::<#name>(#value, #params))
        } else {
            quote!(#p::Slot::new::<#name>(#value))
        }
    });
    let fields = fields(tree);
    quote! {
        #(#attributes)*
        #visibility struct #name {
            engine: #p::Engine<#name>,
        }

        impl #name {
            /// The tree at rest: every component new, none active yet.
            #[must_use]
            #visibility const fn new() -> Self {
                Self { engine: #p::Engine::new(#slots { #(#fields: #values,)* end: () }) }
            }
        }

        #[automatically_derived]
        impl ::core::default::Default for #name {
            fn default() -> Self {
                Self::new()
            }
        }
    }
}
