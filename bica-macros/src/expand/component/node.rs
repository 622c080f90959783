//! `NODE`: the component in a tree, as tools read it.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use syn::Type;

use super::role;
use super::visits::Visits;
use crate::expand::quoting::{at, option, placed, runtime};
use bica_syntax::component::model::{Argument, Behaviour, Component, Edge, Function};
use bica_syntax::component::role_of;
use bica_syntax::text;

pub(super) fn expand(component: &Component, behaviour: &Behaviour, visits: &Visits) -> TokenStream {
    let p = runtime();
    let transitions: Vec<_> = match behaviour {
        Behaviour::Step(_) => Vec::new(),
        Behaviour::Machine(machine) => machine.edges.iter().map(|edge| transition(&p, edge)).collect(),
    };
    let distinct: TokenStream = component.functions().map(distinct).collect();
    let (written, count) = (visits.written(), visits.len());
    quote! {
        const WRITTEN: &'static [#p::WrittenLink] = #written;
        const NODE: #p::Node = {
            #distinct
            #p::Node {
                name: <Self as #p::Component>::NAME,
                doc: <Self as #p::Component>::DOC,
                hz: <Self as #p::Component>::HZ,
                budget_us: <Self as #p::Component>::BUDGET_US,
                resume: <Self as #p::Component>::RESUME,
                links: const {
                    &#p::DistinctLinks::<#count>::of(<Self as #p::MemberOf<__T>>::WRITTEN, <__T as #p::Has<Self>>::INDEX)
                }.as_slice(),
                states: <Self as #p::Component>::STATES,
                transitions: &[#(#transitions),*],
                params: <Self as #p::Component>::PARAMS,
                info: <Self as #p::Component>::INFO,
                modulations: <Self as #p::Component>::MODULATIONS,
                work: <Self as #p::Component>::WORK,
            }
        };
    }
}

/// Two paths to one type in a signature are two links to one component, and two roles can be one component: the macro reads paths, the
/// constant types.
fn distinct(function: &Function) -> TokenStream {
    let p = runtime();
    let links: Vec<_> = function.arguments.iter().filter_map(link).collect();
    if links.len() < 2 {
        return TokenStream::new();
    }
    let targets = links.iter().map(|(kind, child)| {
        let (to, by_role, name) = (role::child(&p, child), role_of(child).is_some(), text::written(child));
        quote! {
            #p::Target { to: <__T as #p::Has<#to>>::INDEX, kind: #p::WrittenKind::#kind, by_role: #by_role, name: #name }
        }
    });
    let each = links.iter().enumerate().skip(1).map(|(index, (_, child))| {
        let p = placed(&p, at(child));
        quote_spanned!(at(child) => #p::assert_single_link(targets, #index);)
    });
    quote!({ let targets = &[#(#targets),*]; #(#each)* })
}

/// The kind of an argument that is a link, and its child.
fn link(argument: &Argument) -> Option<(TokenStream, &Type)> {
    match argument {
        Argument::Read(child) => Some((quote!(Read), child)),
        Argument::Write(child) => Some((quote!(Write), child)),
        Argument::Rate(child) => Some((quote!(Rate), child)),
        Argument::OwnRate | Argument::Time(_) | Argument::Tuned(_) | Argument::Found(_) | Argument::Work(_) => None,
    }
}

fn transition(p: &TokenStream, edge: &Edge) -> TokenStream {
    let name = text::name(&edge.condition.name);
    let (doc, from, to, after_ms) = (&edge.condition.doc, edge.from, edge.to, option(edge.after_ms.as_ref()));
    let carries = option(edge.condition.carries.as_ref().map(text::written).as_ref());
    quote!(#p::Transition { name: #name, doc: #p::doc(#doc), from: #from, to: #to, after_ms: #after_ms, carries: #carries })
}
