//! The hooks of a component that becomes active or latent.

use proc_macro2::TokenStream;
use quote::quote;

use super::runtime;
use crate::language::component::model::{Component, Function};

pub(super) fn expand(component: &Component) -> TokenStream {
    let p = runtime(component);
    let start = hook(&p, &quote!(start), &component.starts);
    let stop = hook(&p, &quote!(stop), &component.stops);
    quote!(#start #stop)
}

fn hook(p: &TokenStream, name: &TokenStream, functions: &[Function]) -> Option<TokenStream> {
    let calls = functions.iter().map(|function| &function.name);
    (!functions.is_empty()).then(|| {
        quote! {
            fn #name<__P: #p::Probe>(cycle: &mut #p::Cycle<'_, __T, __P>) {
                let (this, ()) = cycle.borrow::<Self, ()>();
                #(Self::#calls(this);)*
            }
        }
    })
}
