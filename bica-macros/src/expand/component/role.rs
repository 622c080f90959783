//! Roles in the arguments of a component: the component that a tree names for each.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::{ToTokens, quote, quote_spanned};
use syn::{Path, Type, WherePredicate, parse_quote_spanned};

use crate::expand::quoting::{at, option, placed, runtime, settled};
use bica_syntax::component::model::{Argument, Component};
use bica_syntax::component::role_of;
use bica_syntax::text;

/// The type of a child: as written, or the component that the tree `__T` names for its role.
pub(super) fn child(p: &TokenStream, kind: &Type) -> TokenStream {
    let Some(role) = role_of(kind) else { return settled(&kind.to_token_stream()) };
    let p = placed(p, at(kind));
    quote_spanned!(at(kind) => <__T as #p::Fills<dyn #role>>::Provider)
}

/// That the tree `__T` holds a child, with the child's place in a signature for the compiler to point at.
pub(super) fn holds(p: &TokenStream, kind: &Type) -> WherePredicate {
    let p = placed(p, at(kind));
    if let Some(role) = role_of(kind) {
        return parse_quote_spanned!(at(kind) => __T: #p::Fills<dyn #role, Provider: #role>);
    }
    let kind = child(&p, kind);
    parse_quote_spanned!(at(&kind) => __T: #p::Has<#kind>)
}

/// Index of the role of a child in the tree's list, if it is written by a role.
pub(super) fn index(p: &TokenStream, kind: &Type) -> TokenStream {
    option(role_of(kind).map(|role| quote!(<__T as #p::Fills<dyn #role>>::ROLE)).as_ref())
}

/// The constant with the names of the roles, if there are any. It is the one place that requires that the traits are roles.
pub(super) fn names(component: &Component) -> Option<TokenStream> {
    let p = runtime();
    let name = |role| {
        let p = placed(&p, at(role));
        quote_spanned!(at(role) => <dyn #role as #p::Role>::NAME)
    };
    let names: Vec<_> = of(component).map(name).collect();
    (!names.is_empty()).then(|| quote!(const ROLES: &'static [#p::RoleName] = &[#(#names),*];))
}

/// The traits in the arguments, each once.
fn of(component: &Component) -> impl Iterator<Item = &Path> {
    let arguments = component.functions().flat_map(|function| &function.arguments);
    let mut seen = BTreeSet::new();
    arguments
        .filter_map(|argument| match argument {
            Argument::Read(kind) | Argument::Write(kind) | Argument::Age(kind) => role_of(kind),
            _ => None,
        })
        .filter(move |role| seen.insert(text::written(role)))
}
