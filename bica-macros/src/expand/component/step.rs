//! The visit of a component without states.

use proc_macro2::TokenStream;
use quote::quote;

use super::call;
use super::tuning::Tuning;
use super::visits::Visits;
use bica_syntax::component::model::Function;

/// The code of `pass` and that of `pass_steady`.
pub(super) fn expand(
    p: &TokenStream,
    step: Option<&Function>,
    visits: &Visits,
    tuning: &Tuning,
) -> (TokenStream, TokenStream) {
    let (before, after) = (visits.before(0), visits.after(0));
    let call = step.map(|step| call::expand(p, step, tuning));
    let (before_steady, after_steady) = (visits.before_steady(), visits.after_steady());
    let run = quote! {
        cycle.begin_run::<Self>();
        #call
        cycle.end_code::<Self>();
    };
    let pass = quote! {
        #before
        if visit.due {
            #run
        }
        #after
    };
    let pass_steady = quote! {
        #before_steady
        if is_due {
            #run
        }
        #after_steady
    };
    (pass, pass_steady)
}
