//! The struct that holds the components.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};

use super::{fields, kinds, runtime, stored};
use crate::expand::quoting::{at, placed};
use bica_syntax::tree::model::Tree;

pub(super) fn expand(tree: &Tree) -> TokenStream {
    let p = runtime(tree);
    let fields = fields(tree);
    let kinds = kinds(tree).into_iter().map(|kind| {
        let (p, stored) = (placed(&p, at(&kind)), stored(tree, &kind));
        quote_spanned!(at(&kind) => #p::Slot<#kind, #stored, <#kind as #p::Component>::Work>)
    });
    quote! {
        pub struct __Slots {
            #(#fields: #kinds,)*
            /// Whether the struct has a size does not depend on a listed type.
            end: (),
        }
    }
}
