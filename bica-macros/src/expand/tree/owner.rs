//! The struct that the user names, and how it is made.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote, quote_spanned};

use super::{fields, kinds, runtime};
use crate::expand::quoting::{at, placed};
use bica_syntax::tree::model::Tree;

/// The struct, and the name of the crate for all other code: a wrong path gives one message.
pub(super) fn expand(tree: &Tree) -> TokenStream {
    let (attributes, visibility, name, krate, p) =
        (&tree.attributes, &tree.visibility, &tree.name, &tree.krate, runtime(tree));
    let owner = placed(&quote!(struct #name { engine: #p::Engine<#name> }), at(name));
    quote! {
        #(#attributes)*
        #visibility #owner

        #[doc(hidden)]
        use #krate::__private as #p;
    }
}

/// The constructors.
pub(super) fn new(tree: &Tree) -> TokenStream {
    let (visibility, name, p) = (&tree.visibility, &tree.name, runtime(tree));
    let values = tree.components.iter().zip(kinds(tree)).map(|(entry, kind)| {
        let kind = &kind;
        let new = || quote_spanned!(at(kind) => <#kind>::new());
        let value = entry.value.as_ref().map_or_else(new, |value| quote!(#value));
        if tree.tunable {
            let (p, name) = (placed(&p, at(kind)), placed(&name.to_token_stream(), at(kind)));
            let params = quote_spanned!(at(kind) => <#kind as #p::Component>::DEFAULT_PARAMS);
            let work = quote_spanned!(at(kind) => <#kind as #p::Component>::Work);
            quote_spanned!(at(kind) => #p::Slot::<#kind, _, #work>::with::<#name>(#value, #params))
        } else {
            quote!(#p::Slot::<#kind, (), _>::with::<#name>(#value, ()))
        }
    });
    let fields = fields(tree);
    quote! {
        impl #name {
            /// The tree at rest: every component new, none active yet.
            #[must_use]
            #visibility const fn new() -> Self {
                Self { engine: #p::Engine::new(__Slots { #(#fields: #values,)* end: () }) }
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
