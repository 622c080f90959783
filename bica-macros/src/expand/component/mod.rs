//! The code of a component: one file for each thing that is generated.

mod call;
mod description;
mod hooks;
mod machine;
mod member;
mod node;
mod operator;
mod step;
mod stub;
mod tuning;
mod visits;

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use syn::{FnArg, Path};

use crate::expand::quoting::at;
use bica_syntax::component::block::Function;
use bica_syntax::component::model::{Behaviour, Component};

pub(crate) use stub::{misplaced, stub};

/// The impl block as written and what makes a component of it.
pub(crate) fn expand(component: &Component, behaviour: &Behaviour) -> TokenStream {
    let block = &component.block;
    let description = description::expand(component, behaviour);
    let member = member::expand(component, behaviour);
    let no_step = (component.step.is_none() && is_whole(component)).then(|| no_step(component));
    quote!(#block #description #member #no_step)
}

/// Whether the block is the one that makes the component, rather than one of helpers with an attribute too much: it has
/// a constructor, or functions that the tree calls.
fn is_whole(component: &Component) -> bool {
    let constructs = |function: &Function| !matches!(function.signature.inputs.first(), Some(FnArg::Receiver(_)));
    component.functions().next().is_some() || component.block.functions().any(constructs)
}

/// A constant that collides with a function `step` in another impl block, which no tree would ever call.
fn no_step(component: &Component) -> TokenStream {
    let own = component.own();
    let (parameters, _, bounds) = component.block.header.generics.split_for_impl();
    quote_spanned! {at(own) =>
        #[doc(hidden)]
        #[allow(dead_code, non_upper_case_globals, reason = "its name is taken, it has no value")]
        impl #parameters #own #bounds {
            const step: () = ();
        }
    }
}

/// The path to what generated code uses.
fn runtime(component: &Component) -> TokenStream {
    private(&component.options.krate)
}

fn private(krate: &Path) -> TokenStream {
    quote!(#krate::__private)
}
