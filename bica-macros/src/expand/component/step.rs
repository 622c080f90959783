//! The visit of a component without states.

use proc_macro2::TokenStream;
use quote::quote;

use super::call;
use super::tuning::Tuning;
use super::visits::Visits;
use bica_syntax::component::model::Function;

pub(super) fn expand(p: &TokenStream, step: Option<&Function>, visits: &Visits, tuning: &Tuning) -> TokenStream {
    let (before, after) = (visits.before(0), visits.after(0));
    let call = step.map(|step| call::expand(p, step, tuning));
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
