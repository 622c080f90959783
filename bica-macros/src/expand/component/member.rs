//! `impl MemberOf`: the component as a part of any tree that holds its children.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Type, parse_quote};

use super::slots::Slots;
use super::tuning::Tuning;
use super::visits::Visits;
use super::{description, hooks, machine, node, operator, role, step};
use crate::expand::quoting::runtime;
use bica_syntax::component::model::{Argument, Behaviour, Component, Machine};
use bica_syntax::text;

pub(super) fn expand(component: &Component, behaviour: &Behaviour) -> TokenStream {
    let p = runtime();
    let own = component.own();
    let visits = Visits::of(&p, behaviour);
    let tuning = Tuning::of(component);
    let mut generics = description::owned(&component.block.header.generics);
    generics.params.push(parse_quote!(__T));
    let bounds = generics.make_where_clause();
    // Only parameters and work need that the tree's member is the component itself: a tree with mistakes has another.
    bounds.predicates.push(if tuning.is_empty() && component.work.is_none() {
        parse_quote!(__T: #p::Has<Self>)
    } else {
        parse_quote!(__T: #p::Has<Self, Member = Self>)
    });
    for child in children(&visits).chain(asked(behaviour)).chain(aged(component)) {
        bounds.predicates.push(role::holds(&p, child));
    }
    let (parameters, _, bounds) = generics.split_for_impl();
    let timed = timed(component);
    let (rates, ages) = (rates(&p, component), ages(&p, component));
    let node = node::expand(component, behaviour, &visits, &tuning);
    let (code, carrying) = match behaviour {
        Behaviour::Step(function) => (step::expand(&p, function.as_ref(), &visits, &tuning), None),
        Behaviour::Machine(machine) => {
            let slots = Slots::of(machine);
            let parts = machine::Parts { p: &p, machine, visits: &visits, tuning: &tuning, slots };
            (parts.functions(), parts.carrying(own, &generics))
        }
    };
    let hooks = hooks::expand(component, &tuning);
    let operator = operator::functions(component);
    quote! {
        #[automatically_derived]
        impl #parameters #p::MemberOf<__T, __Block> for #own #bounds {
            #node
            const TIMED: ::core::primitive::bool = #timed;
            #rates
            #ages

            #code

            #hooks
            #operator
        }

        #carrying
    }
}

fn timed(component: &Component) -> bool {
    component.functions().flat_map(|function| &function.arguments).any(|argument| matches!(argument, Argument::Time(_)))
}

/// The components whose rates are borrowed, if there are any.
fn rates(p: &TokenStream, component: &Component) -> Option<TokenStream> {
    let arguments = component.functions().flat_map(|function| &function.arguments);
    let borrowed: Vec<_> = arguments
        .filter_map(|argument| match argument {
            Argument::Rate(child) => {
                let child = role::child(p, child);
                Some(quote!(<__T as #p::Has<#child>>::INDEX))
            }
            Argument::OwnRate => Some(quote!(<__T as #p::Has<Self>>::INDEX)),
            _ => None,
        })
        .collect();
    (!borrowed.is_empty()).then(|| quote!(const RATES: &'static [::core::primitive::usize] = &[#(#borrowed),*];))
}

/// The components whose ages the functions take.
fn aged(component: &Component) -> impl Iterator<Item = &Type> {
    component.functions().flat_map(|function| &function.arguments).filter_map(|argument| match argument {
        Argument::Age(of) => Some(of),
        _ => None,
    })
}

/// The same as indices, if there are any.
fn ages(p: &TokenStream, component: &Component) -> Option<TokenStream> {
    let ages = aged(component).map(|of| role::child(p, of)).map(|of| quote!(<__T as #p::Has<#of>>::INDEX));
    let ages: Vec<_> = ages.collect();
    (!ages.is_empty()).then(|| quote!(const AGES: &'static [::core::primitive::usize] = &[#(#ages),*];))
}

/// The children of whose results the transitions are written with other paths than their links.
fn asked(behaviour: &Behaviour) -> impl Iterator<Item = &Type> {
    let machine = if let Behaviour::Machine(machine) = behaviour { Some(machine) } else { None };
    machine.into_iter().flat_map(Machine::asked)
}

/// All children, each text once.
fn children(visits: &Visits) -> impl Iterator<Item = &Type> {
    let mut seen = BTreeSet::new();
    visits.children().filter(move |child| seen.insert(text::written(child)))
}
