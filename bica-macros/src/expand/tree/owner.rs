//! The struct that the user names, and how it is made.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::Visibility;

use super::{fields, kinds, runtime};
use crate::expand::quoting::{at, placed};
use bica_syntax::text;
use bica_syntax::tree::model::Tree;

/// The struct in a module of its own. If the user's module has another item of that name, the compiler reports that the name is taken, and
/// nothing else: all other code uses the struct in its module.
pub(super) fn expand(tree: &Tree, number: u64) -> TokenStream {
    let (attributes, visibility, name, krate) = (&tree.attributes, &tree.visibility, &tree.name, &tree.krate);
    let (module, inner) = (module(tree, number), inner(visibility, name));
    let owner = placed(&quote!(struct #name { pub(super) engine: __bica::Engine<#name> }), at(name));
    let import = placed(&quote!(use #module::#name;), at(name));
    quote! {
        mod #module {
            #[allow(unused_imports, reason = "for links of the doc comment")]
            use super::*;
            pub(super) use #krate::__private as __bica;

            #(#attributes)*
            #inner #owner
        }
        #[allow(unused_imports, reason = "a test may only define a tree")]
        #visibility #import
    }
}

/// The names of the struct and of the crate for all other code: a wrong path gives one message.
pub(super) fn own(tree: &Tree, number: u64) -> TokenStream {
    let (module, name, p) = (module(tree, number), &tree.name, runtime(tree));
    quote!(use #module::{__bica as #p, #name};)
}

/// The module of the struct.
fn module(tree: &Tree, number: u64) -> Ident {
    format_ident!("__{}_{number:016x}", text::name(&tree.name).to_lowercase())
}

/// The visibility of the tree `name`, as seen from a module in the one for which it was written.
fn inner(visibility: &Visibility, name: &Ident) -> TokenStream {
    let path = match visibility {
        Visibility::Restricted(restricted) => &restricted.path,
        Visibility::Inherited => return quote_spanned!(at(name) => pub(super)),
        Visibility::Public(_) => return visibility.to_token_stream(),
    };
    let rest = path.segments.iter().skip(1);
    match path.segments.first() {
        Some(first) if first.ident == "self" => quote!(pub(in super #(::#rest)*)),
        Some(first) if first.ident == "super" => quote!(pub(in super::super #(::#rest)*)),
        _ => visibility.to_token_stream(),
    }
}

/// The constructors.
pub(super) fn new(tree: &Tree) -> TokenStream {
    let (visibility, name, p) = (&tree.visibility, &tree.name, runtime(tree));
    let values = tree.components.iter().zip(kinds(tree)).map(|(entry, kind)| {
        let kind = &kind;
        let new = || quote_spanned!(at(kind) => <#kind>::new());
        let value = entry.value.as_ref().map_or_else(new, |value| quote!(#value));
        let (p, name) = (placed(&p, at(kind)), placed(&name.to_token_stream(), at(kind)));
        if tree.tunable {
            let params = quote_spanned!(at(kind) => <#kind as #p::Component>::DEFAULT_PARAMS);
            let work = quote_spanned!(at(kind) => <#kind as #p::Component>::Work);
            quote_spanned!(at(kind) => #p::Slot::<#kind, _, #work>::with::<#name>(#value, #params))
        } else {
            quote_spanned!(at(kind) => #p::Slot::<#kind, (), _>::with::<#name>(#value, ()))
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
