//! `impl Fills`: the component that provides each role.

use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote, quote_spanned};

use super::{kinds, runtime};
use crate::expand::quoting::{at, placed, settled};
use bica_syntax::text;
use bica_syntax::tree::model::{Entry, RoleEntry, Tree};

pub(super) fn expand(tree: &Tree) -> TokenStream {
    let name = &tree.name;
    let each = tree.roles.iter().enumerate().map(|(index, entry)| {
        let (p, role, of) = (runtime(tree), &entry.role, format_ident!("__Role{index}"));
        let (kind, checked, asked) = (provider(tree, entry), checked(tree, index), asked(tree, index));
        let place = at(&entry.provider);
        let (p, name) = (placed(&p, place), placed(&name.to_token_stream(), place));
        quote_spanned! {place =>
            /// The role. All other code uses this name, so that the compiler finds a path that leads nowhere once.
            type #of = dyn #role;

            #checked

            #[automatically_derived]
            impl #p::Fills<#of> for #name {
                type Provider = <#p::Checked<{ __checked() }> as #p::Provide<#kind>>::Component;
                const ROLE: ::core::primitive::usize = #index;
            }

            #asked
        }
    });
    let (each, filled) = (each.map(|one| quote!(const _: () = { #one };)), filled(tree));
    quote!(#(#each)* #filled)
}

/// A type that the compiler refuses, once, unless each role for which a component asks has a provider.
fn filled(tree: &Tree) -> TokenStream {
    let (p, label, kinds) = (runtime(tree), text::name(&tree.name), kinds(tree));
    let names = tree.components.iter().map(Entry::label);
    let roles = tree.roles.iter().map(|entry| {
        let (role, p) = (&entry.role, placed(&p, at(&entry.role)));
        quote_spanned!(at(role) => { use #p::Unnamed as _; <#p::Named<dyn #role>>::NAME })
    });
    let asked = kinds.iter().map(|kind| {
        let p = placed(&p, at(kind));
        quote_spanned!(at(kind) => <#kind as #p::Component>::ROLES)
    });
    let p = placed(&p, at(&tree.name));
    quote_spanned! {at(&tree.name) =>
        type __Filled = #p::Checked<{ #p::assert_filled(#label, &[#(#roles),*], &[#((#names, #asked)),*]) }>;
    }
}

/// The role's name, without its path.
pub(super) fn name(entry: &RoleEntry) -> String {
    entry.role.segments.last().map(|last| text::name(&last.ident)).unwrap_or_default()
}

/// The provider by the name that all code of the tree uses, or as written, if the list has another path to it or lacks it.
fn provider(tree: &Tree, entry: &RoleEntry) -> TokenStream {
    let written = text::written(&entry.provider);
    let listed = tree.components.iter().position(|listed| text::written(&listed.kind) == written);
    let listed =
        listed.map(|place| format_ident!("__Component{place}", span = at(&entry.provider)).into_token_stream());
    listed.unwrap_or_else(|| settled(&entry.provider.to_token_stream()))
}

/// A constant function that fails unless the component provides the role. An inherent constant with a bound precedes one of a trait.
fn checked(tree: &Tree, index: usize) -> TokenStream {
    let (entry, of) = (&tree.roles[index], format_ident!("__Role{index}"));
    let (kind, place) = (provider(tree, entry), at(&entry.provider));
    let (p, name, component) = (placed(&runtime(tree), place), name(entry), text::written(&entry.provider));
    quote_spanned! {place =>
        struct __Is<R: ?::core::marker::Sized, C>(::core::marker::PhantomData<(*const R, C)>);
        trait __IsNot {
            const ROLE: ::core::primitive::bool = false;
            const PROVIDED: ::core::primitive::bool = false;
        }
        impl<R: ?::core::marker::Sized, C> __IsNot for __Is<R, C> {}
        impl<R: ?::core::marker::Sized + #p::Role, C> __Is<R, C> {
            const ROLE: ::core::primitive::bool = true;
        }
        impl<R: ?::core::marker::Sized + #p::ProvidedBy<C>, C> __Is<R, C> {
            const PROVIDED: ::core::primitive::bool = true;
        }
        const fn __checked() -> ::core::primitive::bool {
            type __Of = __Is<#of, #kind>;
            #p::assert_provided(__Of::ROLE, __Of::PROVIDED, #name, #component)
        }
    }
}

/// The assertion that a component asks for the role.
fn asked(tree: &Tree, index: usize) -> TokenStream {
    let (name, kinds, place) = (&tree.name, kinds(tree), at(&tree.roles[index].role));
    let p = runtime(tree);
    let stubs = quote!(#(#p::is_stub::<#name, #kinds>()),*);
    let p = placed(&p, place);
    quote_spanned!(place => const _: () = #p::assert_asked(&<#name as #p::Tree>::GRAPH, #index, &[#stubs]);)
}
