//! The visit of a component without states.

use proc_macro2::TokenStream;
use quote::quote;

use super::{call, wired};
use crate::language::component::links::Links;
use crate::language::component::model::Function;

pub(super) fn expand(p: &TokenStream, step: Option<&Function>) -> TokenStream {
    let links = Links::of(step.into_iter());
    let before = wired::visits(p, &links.requirements);
    let after = wired::visits(p, &links.modulations);
    let call = step.map(|step| call::expand(p, step));
    quote! {
        #before
        if visit.due {
            cycle.begin_run::<Self>();
            #call
            cycle.end_code::<Self>();
        }
        #after
    }
}
