//! The visit of a state machine.
//!
//! One round through the loop is one state. A transition ends its round early and the next begins in the new state, so
//! that the state that is not left costs one `match`.

use proc_macro2::TokenStream;
use quote::quote;

use super::{call, wired};
use crate::language::component::links::Links;
use crate::language::component::model::{Function, Machine, Way};

pub(super) fn expand(p: &TokenStream, machine: &Machine) -> TokenStream {
    let last = machine.states.len() - 1;
    let arms = (0..=last).map(|state| {
        let round = round(p, machine, state);
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

fn round(p: &TokenStream, machine: &Machine, state: usize) -> TokenStream {
    let place = &machine.states[state];
    let links = Links::of_state(machine, state);
    let before = wired::visits(p, &links.requirements);
    let after = wired::visits(p, &links.modulations);
    let entries = calls(p, &place.entries);
    let entering = (!place.entries.is_empty()).then(|| quote!(if machine.entering { #entries }));
    let body = call::expand(p, &place.body);
    let exits = calls(p, &place.exits);
    let ways: Vec<_> = machine.ways_from(state).map(|way| leave(p, way, &exits)).collect();
    let leaving = (!ways.is_empty()).then(|| quote!(if !machine.moved { #(#ways)* }));
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

fn calls(p: &TokenStream, functions: &[Function]) -> TokenStream {
    let calls = functions.iter().map(|function| call::expand(p, function));
    quote!(#(#calls)*)
}

fn leave(p: &TokenStream, way: &Way, exits: &TokenStream) -> TokenStream {
    let (from, to) = (way.from, way.to);
    let condition = call::expand(p, &way.condition);
    let timer = way.after_ms.map(|ms| quote!(cycle.has_been_in_state::<Self>(#ms) &&));
    quote! {
        if #timer #condition {
            #exits
            machine = cycle.transition::<Self>(#from, #to);
            continue;
        }
    }
}
