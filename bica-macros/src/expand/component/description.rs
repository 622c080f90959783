//! `impl Component`: what is true of the component in every tree.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::{GenericParam, Generics, Type, parse_quote};

use super::tuning::Tuning;
use super::{node, operator, role, work};
use crate::expand::quoting::{option, runtime};
use bica_syntax::component::model::{Behaviour, Component, Machine, MachineState, Writers};
use bica_syntax::text;

pub(super) fn expand(component: &Component, behaviour: &Behaviour) -> TokenStream {
    let p = runtime();
    let own = component.own();
    let generics = owned(&component.block.header.generics);
    let (parameters, _, bounds) = generics.split_for_impl();
    let name = name(own);
    let doc = doc(&p, component);
    let hz = option(component.options.hz.as_ref());
    let budget_us = option(component.options.budget_us.as_ref());
    let resume = component.options.resume.is_some();
    let writers = component.options.writers.map(|writers| {
        let word = Ident::new(if writers == Writers::First { "First" } else { "Last" }, Span::call_site());
        quote!(const WRITERS: ::core::option::Option<#p::InForce> = ::core::option::Option::Some(#p::InForce::#word);)
    });
    let states = states(behaviour);
    let tuning = Tuning::of(component).items();
    let operator = operator::descriptions(component);
    let work = work::description(component);
    let roles = role::names(component);
    quote! {
        #[automatically_derived]
        impl #parameters #p::Component for #own #bounds {
            type Itself = Self;
            type Block = __Block;
            const NAME: &'static ::core::primitive::str = #name;
            const DOC: &'static ::core::primitive::str = #doc;
            const HZ: ::core::option::Option<::core::primitive::f32> = #hz;
            const BUDGET_US: ::core::option::Option<::core::primitive::f32> = #budget_us;
            const RESUME: ::core::primitive::bool = #resume;
            #writers
            #states
            #tuning
            #operator
            #work
            #roles
        }
    }
}

/// The doc comment of the block, or else of the type, or else of the step.
fn doc(p: &TokenStream, component: &Component) -> TokenStream {
    let block = text::doc(&component.block.header.attrs);
    if !block.is_empty() {
        return quote!(#p::doc(#block));
    }
    let step = component.step.as_ref().map(|step| step.doc.as_str()).unwrap_or_default();
    quote!({
        use #p::ComponentDoc as _;
        #p::doc_of(Self::__DOC, #step)
    })
}

/// The generics of the impl block, its types bound to outlive everything as a component must.
pub(super) fn owned(generics: &Generics) -> Generics {
    let mut generics = generics.clone();
    for parameter in &mut generics.params {
        if let GenericParam::Type(parameter) = parameter {
            parameter.bounds.push(parse_quote!('static));
        }
    }
    generics
}

/// The type's name, without its path.
pub(super) fn name(own: &Type) -> String {
    match own {
        Type::Path(path) => path.path.segments.last().map(|segment| text::name(&segment.ident)).unwrap_or_default(),
        _ => String::new(),
    }
}

fn states(behaviour: &Behaviour) -> TokenStream {
    let p = runtime();
    let Behaviour::Machine(machine) = behaviour else {
        return quote!(const STATES: &'static [#p::State] = &[];);
    };
    let initial = machine.initial;
    let states = machine.states.iter().enumerate().map(|(index, one)| state(&p, machine, index, one));
    quote! {
        const STATES: &'static [#p::State] = &[#(#states),*];
        const INITIAL: ::core::primitive::usize = #initial;
    }
}

fn state(p: &TokenStream, machine: &Machine, index: usize, state: &MachineState) -> TokenStream {
    let name = text::name(&state.body.name);
    let (doc, last, initial) = (&state.body.doc, state.last, machine.initial == index);
    let before = option(state.before.as_ref().map(|before| text::name(&before.name)).as_ref());
    let end = option(state.end.map(node::end).map(|end| quote!(#p::End::#end)).as_ref());
    quote!(#p::State { name: #name, doc: #p::doc(#doc), initial: #initial, last: #last, end: #end, before: #before })
}
