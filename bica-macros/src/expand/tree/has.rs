//! `impl Has`: the place of each component.

use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};

use super::{fields, kinds, runtime, stored};
use crate::expand::quoting::{at, placed};
use bica_syntax::tree::model::Tree;

pub(super) fn expand(tree: &Tree) -> TokenStream {
    let p = runtime(tree);
    let name = &tree.name;
    let each = kinds(tree).into_iter().zip(fields(tree)).enumerate().map(|(index, (kind, field))| {
        let kind = &kind;
        let p = placed(&p, at(kind));
        let (listed, stored) = (listed(&p, name, index, kind), stored(tree, kind));
        let params = tree.tunable.then(|| params(&p, kind, &field));
        // In a tunable tree everything asks for `Component`, so that the compiler reports a type that is none once.
        let member =
            if tree.tunable { quote_spanned!(at(kind) => <#kind as #p::Component>::Itself) } else { quote!(#kind) };
        let member = quote_spanned!(at(kind) => <__Filled as #p::Provide<#member>>::Component);
        quote_spanned! {at(kind) =>
            #[doc(hidden)]
            #[automatically_derived]
            impl #p::Has<#kind> for #name {
                type Member = #member;
                type Stored = #stored;
                const INDEX: ::core::primitive::usize = #index;

                #[inline]
                fn slot(slots: &Self::Slots) -> &#p::Slot<#kind, Self::Stored, #p::WorkOf<Self, #kind>> {
                    &slots.#field
                }

                #params

                #p::visit_functions!(#kind);
            }

            #listed
        }
    });
    quote!(#(#each)*)
}

/// The parameters of a tunable tree.
fn params(p: &TokenStream, kind: &Ident, field: &Ident) -> TokenStream {
    quote_spanned! {at(kind) =>
        #[inline]
        fn params(slots: &Self::Slots) -> &#p::ParamsOf<Self, #kind> {
            slots.#field.params()
        }

        fn params_mut(slots: &mut Self::Slots) -> ::core::option::Option<&mut #p::ParamsOf<Self, #kind>> {
            ::core::option::Option::Some(slots.#field.params_mut())
        }
    }
}

/// A component less visible than its tree: the compiler refuses it as an associated type, and points at the list.
fn listed(p: &TokenStream, name: &Ident, index: usize, kind: &Ident) -> TokenStream {
    let p = placed(p, at(kind));
    quote_spanned! {at(kind) =>
        #[doc(hidden)]
        #[automatically_derived]
        impl #p::Lists<#index> for #name {
            type Component = #kind;
        }
    }
}
