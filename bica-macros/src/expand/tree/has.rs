//! `impl Has`: where each component is.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};

use super::{fields, runtime};
use crate::expand::quoting::at;
use crate::language::tree::model::Tree;

pub(super) fn expand(tree: &Tree) -> TokenStream {
    let p = runtime(tree);
    let name = &tree.name;
    let each = tree.components.iter().zip(fields(tree)).enumerate().map(|(index, (entry, field))| {
        let kind = &entry.kind;
        let member = quote_spanned!(at(kind) => type Member = #kind;);
        quote! {
            #[doc(hidden)]
            #[automatically_derived]
            impl #p::Has<#kind> for #name {
                #member
                const INDEX: usize = #index;

                #[inline]
                fn slot(slots: &Self::Slots) -> &#p::Slot<#kind> {
                    &slots.#field
                }

                #p::visit_functions!(#kind);
            }
        }
    });
    quote!(#(#each)*)
}
