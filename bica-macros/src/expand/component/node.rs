//! `NODE`: the component in a tree, as tools see it.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use syn::Type;

use super::{call, runtime};
use crate::expand::quoting::{at, option, placed};
use crate::language::component::links::Links;
use crate::language::component::model::{Behaviour, Component, Way};

pub(super) fn expand(component: &Component, behaviour: &Behaviour) -> TokenStream {
    let p = runtime(component);
    let (links, transitions): (Vec<_>, Vec<_>) = match behaviour {
        Behaviour::Step(step) => (links(&p, &Links::of(step.iter()), None), Vec::new()),
        Behaviour::Machine(machine) => (
            (0..machine.states.len()).flat_map(|at| links(&p, &Links::of_state(machine, at), Some(at))).collect(),
            machine.ways.iter().map(|way| transition(&p, way)).collect(),
        ),
        Behaviour::Unclear => (links(&p, &Links::of(component.functions()), None), Vec::new()),
    };
    let distinct = distinct(component, behaviour);
    quote! {
        const NODE: #p::Node = {
            #distinct
            #p::Node {
                name: <Self as #p::Component>::NAME,
                doc: <Self as #p::Component>::DOC,
                hz: <Self as #p::Component>::HZ,
                budget_us: <Self as #p::Component>::BUDGET_US,
                resume: <Self as #p::Component>::RESUME,
                links: &[#(#links),*],
                states: <Self as #p::Component>::STATES,
                transitions: &[#(#transitions),*],
            }
        };
    }
}

/// Two names of one type are two links to one component: the macro sees names, the constant sees types.
fn distinct(component: &Component, behaviour: &Behaviour) -> TokenStream {
    if matches!(behaviour, Behaviour::Unclear) {
        return TokenStream::new();
    }
    let borrowing = component.functions().filter(|function| !function.arguments.is_empty());
    let each = borrowing.map(|function| {
        let p = placed(&runtime(component), at(&function.name));
        let set = call::borrow_set(&p, function);
        quote_spanned!(at(&function.name) => #p::assert_distinct::<__T, (#p::Write<Self>, #set)>();)
    });
    quote!(#(#each)*)
}

fn links(p: &TokenStream, links: &Links, state: Option<usize>) -> Vec<TokenStream> {
    let state = option(state.as_ref());
    let link = |to: &Type, kind: TokenStream| quote!(#p::Link { to: <__T as #p::Has<#to>>::INDEX, kind: #p::LinkKind::#kind, state: #state });
    let requirements = links.requirements.iter().map(|to| link(to, quote!(Requirement)));
    let modulations = links.modulations.iter().map(|to| link(to, quote!(Modulation)));
    requirements.chain(modulations).collect()
}

fn transition(p: &TokenStream, way: &Way) -> TokenStream {
    let name = way.condition.name.to_string();
    let (doc, from, to, after_ms) = (&way.condition.doc, way.from, way.to, option(way.after_ms.as_ref()));
    quote!(#p::Transition { name: #name, doc: #p::doc(#doc), from: #from, to: #to, after_ms: #after_ms })
}
