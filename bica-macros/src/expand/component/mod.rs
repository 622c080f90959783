//! The code of a component: one file for each thing that is generated.

mod call;
mod description;
mod hooks;
mod machine;
mod node;
mod step;
mod wired;

use proc_macro2::TokenStream;
use quote::quote;

use crate::language::component::model::{Behaviour, Component};
use crate::language::report::Report;

/// The impl block as written and what makes a component of it.
pub(crate) fn expand(component: &Component, behaviour: &Behaviour) -> TokenStream {
    let item = &component.item;
    let description = description::expand(component, behaviour);
    let wired = wired::expand(component, behaviour);
    quote!(#item #description #wired)
}

/// The impl block as written, the mistakes, and a component that does nothing, so that trees that list it hold.
///
/// A type that borrows can be no component at all: another message about that would only repeat ours.
pub(crate) fn stand_in(component: &Component, report: &Report) -> TokenStream {
    let errors = report.to_compile_errors();
    if component.item.generics.lifetimes().next().is_some() {
        let item = &component.item;
        return quote!(#item #errors);
    }
    let nothing = expand(component, &Behaviour::Unclear);
    quote!(#nothing #errors)
}

/// The path to what generated code uses.
fn runtime(component: &Component) -> TokenStream {
    let krate = &component.options.krate;
    quote!(#krate::__private)
}
