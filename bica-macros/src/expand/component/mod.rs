//! The code of a component: one file for each thing that is generated.

mod call;
mod description;
mod hooks;
mod machine;
mod member;
mod node;
pub(crate) mod operator;
mod role;
mod slots;
mod step;
mod stub;
mod tuning;
mod visits;
mod work;

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use syn::FnArg;

use self::tuning::Tuning;
use crate::expand::quoting::{at, enclosed, placed, runtime};
use bica_syntax::component::block::Function;
use bica_syntax::component::model::{Behaviour, Component};
use bica_syntax::text;

pub(crate) use stub::{misplaced, stub};

/// The impl block as written and what makes a component of it.
pub(crate) fn expand(component: &Component, behaviour: &Behaviour) -> TokenStream {
    let block = &component.block;
    let description = description::expand(component, behaviour);
    let member = member::expand(component, behaviour);
    let work = work::expand(component);
    let is_free = component.block.functions().all(|function| text::name(&function.signature.ident) != "step");
    let no_step = (is_free && is_whole(component)).then(|| no_step(component));
    let own_fields = component.block.header.generics.params.is_empty().then(|| no_params(component));
    let timers = Tuning::checks(component);
    let items = quote!(pub struct __Block; #description #member #work #own_fields #timers);
    let traits = enclosed(&component.options.krate, &items);
    quote!(#block #traits #no_step)
}

/// Whether the block is the one that makes the component, rather than one of helpers with an attribute too much: it has
/// a constructor, or functions that the tree calls.
fn is_whole(component: &Component) -> bool {
    let constructs = |function: &Function| !matches!(function.signature.inputs.first(), Some(FnArg::Receiver(_)));
    component.functions().next().is_some() || component.block.functions().any(constructs)
}

/// An assertion that the component's type, which has no generics as all parameters, is no struct of parameters.
fn no_params(component: &Component) -> TokenStream {
    let (p, own) = (runtime(), component.own());
    let called = placed(&quote!(#p::assert_no_params), at(own));
    quote_spanned! {at(own) =>
        const _: () = {
            use #p::Parameters as _;
            #called(<#own>::__PARAMS)
        };
    }
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
