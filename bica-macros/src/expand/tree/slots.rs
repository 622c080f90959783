//! The struct that holds the components.

use proc_macro2::TokenStream;
use quote::quote;

use super::{fields, runtime, slots};
use crate::language::tree::model::Tree;

pub(super) fn expand(tree: &Tree) -> TokenStream {
    let p = runtime(tree);
    let (visibility, slots, fields) = (&tree.visibility, slots(tree), fields(tree));
    let kinds = tree.components.iter().map(|entry| &entry.kind);
    quote! {
        #[doc(hidden)]
        #visibility struct #slots {
            #(#fields: #p::Slot<#kinds>),*
        }
    }
}
