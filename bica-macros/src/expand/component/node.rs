//! `NODE`: the component in a tree, as tools read it.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{quote, quote_spanned};
use syn::Type;

use super::role;
use super::tuning::Tuning;
use super::visits::Visits;
use crate::expand::quoting::{at, option, placed, runtime};
use bica_syntax::component::model::{Argument, Behaviour, Component, Edge, End, Function, Timer, When};
use bica_syntax::component::role_of;
use bica_syntax::text;

pub(super) fn expand(component: &Component, behaviour: &Behaviour, visits: &Visits, tuning: &Tuning) -> TokenStream {
    let p = runtime();
    let transitions: Vec<_> = match behaviour {
        Behaviour::Step(_) => Vec::new(),
        Behaviour::Machine(machine) => machine.edges.iter().map(|edge| transition(&p, edge, tuning)).collect(),
    };
    let queries = component.functions().flat_map(|function| &function.arguments).filter_map(|one| query(&p, one));
    let distinct: TokenStream = component.functions().map(distinct).collect();
    let (written, count) = (visits.written(), visits.len());
    quote! {
        const WRITTEN: &'static [#p::WrittenLink] = #written;
        const NODE: #p::Node = {
            #distinct
            #p::Node {
                name: <Self as #p::Component>::NAME,
                kind: ::core::option::Option::None,
                doc: <Self as #p::Component>::DOC,
                hz: <Self as #p::Component>::HZ,
                budget_us: <Self as #p::Component>::BUDGET_US,
                resume: <Self as #p::Component>::RESUME,
                writers: <Self as #p::Component>::WRITERS,
                links: const {
                    &#p::DistinctLinks::<#count>::of(<Self as #p::MemberOf<__T>>::WRITTEN, <__T as #p::Has<Self>>::INDEX)
                }.as_slice(),
                states: <Self as #p::Component>::STATES,
                transitions: &[#(#transitions),*],
                queries: #p::Queries::new(&[#(#queries),*]),
                params: <Self as #p::Component>::PARAMS,
                outputs: <Self as #p::Component>::OUTPUTS,
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
        Argument::OwnRate
        | Argument::Time(_)
        | Argument::Age(_)
        | Argument::Outcome(_)
        | Argument::Tuned(_)
        | Argument::Found(_)
        | Argument::Work(_) => None,
    }
}

/// The query of an argument that asks for an age or an outcome.
fn query(p: &TokenStream, argument: &Argument) -> Option<TokenStream> {
    let (of, kind) = match argument {
        Argument::Age(of) => {
            let of = role::child(p, of);
            (quote!(<__T as #p::Has<#of>>::INDEX), quote!(Age))
        }
        Argument::Outcome(of) => (with_end(p, of, &quote!(::core::option::Option::None)), quote!(Outcome)),
        _ => return None,
    };
    Some(quote!(#p::Query { of: #of, kind: #p::QueryKind::#kind }))
}

fn transition(p: &TokenStream, edge: &Edge, tuning: &Tuning) -> TokenStream {
    let (name, from, to) = (edge.name(), edge.from, edge.to);
    let doc = if edge.guard.bare { "" } else { &edge.condition.doc };
    let (after, after_ms) = match &edge.guard.timer {
        None => (None, None),
        Some(Timer::Ms(ms)) => (None, Some(quote!(#ms))),
        Some(Timer::Parameter(timer)) => {
            let described = tuning.described(timer);
            (Some(quote!(#described.0)), Some(quote!(#described.1)))
        }
    };
    let (after, after_ms, times) =
        (option(after.as_ref()), option(after_ms.as_ref()), option(edge.guard.times.as_ref()));
    let when = option(edge.guard.when.as_ref().map(|when| result(p, when)).as_ref());
    let carries = option(edge.condition.carries.as_ref().map(text::written).as_ref());
    quote! {
        #p::Transition {
            name: #name, doc: #p::Doc::new(#doc), from: #from, to: #to, after_ms: #after_ms, after: #after, when: #when,
            times: #times, carries: #carries,
        }
    }
}

/// The result of a child that a transition waits for, once it is known to have it.
fn result(p: &TokenStream, when: &When) -> TokenStream {
    let (child, end) = (&when.child.0, end(when.end));
    let checked = placed(p, at(child));
    let index = with_end(p, child, &quote!(::core::option::Option::Some(#checked::End::#end)));
    quote!(#p::When { child: #index as ::core::primitive::u8, end: #p::End::#end })
}

/// The index of a child, once it is known to be a machine that ends in that way.
fn with_end(p: &TokenStream, child: &Type, end: &TokenStream) -> TokenStream {
    let (child, name) = (role::child(p, child), text::written(child));
    let place = at(&child);
    let checked = placed(p, place);
    let check = quote_spanned!(place => #checked::assert_end::<__T, #child>(#end, #name));
    quote!({ #check; <__T as #p::Has<#child>>::INDEX })
}

/// The variant of a result.
pub(super) fn end(end: End) -> Ident {
    let name = if end == End::Done { "Done" } else { "Failed" };
    Ident::new(name, Span::call_site())
}
