//! The visit of a state machine.
//!
//! One round through the loop is one state. A transition ends its round early and the next begins in the new state, so
//! that the state that is not left costs one `match`.

use proc_macro2::TokenStream;
use quote::quote;

use super::call;
use super::tuning::Tuning;
use super::visits::Visits;
use bica_syntax::component::model::{Edge, Function, Machine};

/// The functions of `MemberOf` that run a state machine.
pub(super) fn expand(p: &TokenStream, machine: &Machine, visits: &Visits, tuning: &Tuning) -> TokenStream {
    let rounds = arms(machine, |state| round(p, (machine, state), visits, tuning, false));
    let steady = visits.exist().then(|| {
        let rounds = arms(machine, |state| round(p, (machine, state), visits, tuning, true));
        quote! {
            fn pass_steady<__P: #p::Probe, const __PLAN: ::core::primitive::usize>(cycle: &mut #p::Cycle<'_, __T, __P>, is_due: ::core::primitive::bool) {
                let visit = #p::Visit { due: is_due, entering: false };
                let machine = cycle.machine::<Self>(visit);
                match machine.state {
                    #rounds
                }
            }
        }
    });
    quote! {
        #[inline]
        fn pass<__P: #p::Probe>(cycle: &mut #p::Cycle<'_, __T, __P>, visit: #p::Visit) {
            let machine = cycle.machine::<Self>(visit);
            <Self as #p::MemberOf<__T>>::proceed(cycle, visit, machine);
        }

        #steady

        #[inline]
        fn proceed<__P: #p::Probe>(
            cycle: &mut #p::Cycle<'_, __T, __P>,
            visit: #p::Visit,
            mut machine: #p::Machine,
        ) {
            loop {
                match machine.state {
                    #rounds
                }
            }
        }
    }
}

fn arms(machine: &Machine, round: impl Fn(usize) -> TokenStream) -> TokenStream {
    let last = machine.states.len() - 1;
    let arms = (0..=last).map(|state| {
        let round = round(state);
        if state == last { quote!(_ => #round) } else { quote!(#state => #round) }
    });
    quote!(#(#arms)*)
}

fn round(
    p: &TokenStream,
    (machine, index): (&Machine, usize),
    visits: &Visits,
    tuning: &Tuning,
    steady: bool,
) -> TokenStream {
    let state = &machine.states[index];
    let (before, after) = if steady {
        let plan = quote!(#index);
        (visits.before_steady(index, &plan), visits.after_steady(index, &plan))
    } else {
        (visits.before(index), visits.after(index))
    };
    let entries = calls(p, &state.entries, tuning);
    let entering = (!state.entries.is_empty() && !steady).then(|| quote!(if machine.entering { #entries }));
    let body = call::expand(p, &state.body, tuning);
    let exits = calls(p, &state.exits, tuning);
    let edges = machine.edges.iter().enumerate().filter(|(_, edge)| edge.from == index);
    let transitions: Vec<_> = edges.map(|(number, edge)| leave(p, (number, edge), &exits, tuning, steady)).collect();
    let leaving = (!transitions.is_empty()).then(|| quote!(if !machine.moved { #(#transitions)* }));
    quote! {{
        #before
        if visit.due {
            cycle.begin_state::<Self>(machine);
            #entering
            #leaving
            #body
            cycle.end_code::<Self>();
        }
        #after
        return;
    }}
}

fn calls(p: &TokenStream, functions: &[Function], tuning: &Tuning) -> TokenStream {
    let calls = functions.iter().map(|function| call::expand(p, function, tuning));
    quote!(#(#calls)*)
}

/// Leaves the state if the condition of an edge holds. `number` is the index of the edge in the node's transitions.
fn leave(
    p: &TokenStream,
    (number, edge): (usize, &Edge),
    exits: &TokenStream,
    tuning: &Tuning,
    steady: bool,
) -> TokenStream {
    let (from, to) = (edge.from, edge.to);
    let condition = call::expand(p, &edge.condition, tuning);
    let entered = quote!(cycle.transition::<Self>(#from, #to));
    let next = if steady {
        quote!(let machine = #entered; return <Self as #p::MemberOf<__T>>::proceed(cycle, visit, machine);)
    } else {
        quote!(machine = #entered; continue;)
    };
    let timer = edge.after_ms.map(|ms| quote!(cycle.has_been_in_state::<Self>(#ms) &&));
    quote! {
        if #timer { let holds = #condition; cycle.condition::<Self>(#number, holds) } {
            #exits
            #next
        }
    }
}
