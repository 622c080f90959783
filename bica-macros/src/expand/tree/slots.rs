//! The struct that holds the components.

use proc_macro2::TokenStream;
use quote::quote;

use super::{fields, runtime, slots, stored};
use bica_syntax::tree::model::Tree;

pub(super) fn expand(tree: &Tree) -> TokenStream {
    let p = runtime(tree);
    let (visibility, slots, fields) = (&tree.visibility, slots(tree), fields(tree));
    let kinds = tree.components.iter().map(|entry| {
        let (kind, stored) = (&entry.kind, stored(tree, &entry.kind));
        quote!(#p::Slot<#kind, #stored>)
    });
    quote! {
        #[doc(hidden)]
        #visibility struct #slots {
            #(#fields: #kinds),*
        }
    }
}
