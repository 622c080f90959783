//! The visit of a component without states.

use proc_macro2::TokenStream;
use quote::quote;

use super::call;
use super::tuning::Tuning;
use super::visits::Visits;
use bica_syntax::component::model::Function;

/// The functions of `MemberOf` that run the component.
pub(super) fn expand(p: &TokenStream, step: Option<&Function>, visits: &Visits, tuning: &Tuning) -> TokenStream {
    let (before, after) = (visits.before(0), visits.after(0));
    let plan = quote!(__PLAN);
    let (before_steady, after_steady) = (visits.before_steady(0, &plan), visits.after_steady(0, &plan));
    let call = step.map(|step| call::expand(p, step, tuning));
    let run = quote! {
        cycle.begin_run::<Self>();
        #call
        cycle.end_run::<Self>();
    };
    quote! {
        #[inline]
        fn pass<__P: #p::Probe>(cycle: &mut #p::Cycle<'_, __T, __P>, visit: #p::Visit) {
            #before
            if visit.due {
                #run
            }
            #after
        }

        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn pass_steady<__P: #p::Probe, const __PLAN: ::core::primitive::usize>(cycle: &mut #p::Cycle<'_, __T, __P>, is_due: ::core::primitive::bool) {
            #before_steady
            if is_due {
                #run
            }
            #after_steady
        }
    }
}
