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

pub(super) fn expand(p: &TokenStream, machine: &Machine, visits: &Visits, tuning: &Tuning) -> TokenStream {
    let last = machine.states.len() - 1;
    let arms = (0..=last).map(|state| {
        let round = round(p, machine, state, visits, tuning);
        if state == last { quote!(_ => #round) } else { quote!(#state => #round) }
    });
    quote! {
        let mut machine = cycle.machine::<Self>(visit);
        loop {
            match machine.state {
                #(#arms)*
            }
        }
    }
}

fn round(p: &TokenStream, machine: &Machine, index: usize, visits: &Visits, tuning: &Tuning) -> TokenStream {
    let state = &machine.states[index];
    let (before, after) = (visits.before(index), visits.after(index));
    let entries = calls(p, &state.entries, tuning);
    let entering = (!state.entries.is_empty()).then(|| quote!(if machine.entering { #entries }));
    let body = call::expand(p, &state.body, tuning);
    let exits = calls(p, &state.exits, tuning);
    let transitions: Vec<_> = machine.edges_from(index).map(|edge| leave(p, edge, &exits, tuning)).collect();
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

fn leave(p: &TokenStream, edge: &Edge, exits: &TokenStream, tuning: &Tuning) -> TokenStream {
    let (from, to) = (edge.from, edge.to);
    let condition = call::expand(p, &edge.condition, tuning);
    let timer = edge.after_ms.map(|ms| quote!(cycle.has_been_in_state::<Self>(#ms) &&));
    quote! {
        if #timer #condition {
            #exits
            machine = cycle.transition::<Self>(#from, #to);
            continue;
        }
    }
}
