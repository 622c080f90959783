//! The hooks of a component that becomes active or latent.

use proc_macro2::TokenStream;
use quote::quote;

use super::call;
use super::tuning::Tuning;
use crate::expand::quoting::runtime;
use bica_syntax::component::model::{Component, Function};

pub(super) fn expand(component: &Component, tuning: &Tuning) -> TokenStream {
    let p = runtime();
    let start = hook(&p, &quote!(start), &component.starts, tuning);
    let stop = hook(&p, &quote!(stop), &component.stops, tuning);
    quote!(#start #stop)
}

fn hook(p: &TokenStream, name: &TokenStream, functions: &[Function], tuning: &Tuning) -> Option<TokenStream> {
    let calls = functions.iter().map(|function| call::expand(p, function, tuning));
    (!functions.is_empty()).then(|| {
        quote! {
            fn #name<__P: #p::Probe>(cycle: &mut #p::Cycle<'_, __T, __P>) {
                #(#calls)*
            }
        }
    })
}
