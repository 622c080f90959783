//! `impl MemberOf`: the component as a part of any tree that holds its children.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Type, WherePredicate, parse_quote, parse_quote_spanned};

use super::{description, hooks, machine, node, runtime, step};
use crate::expand::quoting::{at, placed};
use crate::language::component::links::Links;
use crate::language::component::model::{Argument, Behaviour, Component};
use crate::language::text;

pub(super) fn expand(component: &Component, behaviour: &Behaviour) -> TokenStream {
    let p = runtime(component);
    let own = &component.item.self_ty;
    let mut generics = description::owned(&component.item.generics);
    generics.params.push(parse_quote!(__T));
    let bounds = generics.make_where_clause();
    bounds.predicates.push(parse_quote!(__T: #p::Has<#own>));
    for child in children(component, behaviour) {
        bounds.predicates.push(holds(&p, &child));
    }
    let (parameters, _, bounds) = generics.split_for_impl();
    let timed = timed(component);
    let node = node::expand(component, behaviour);
    let pass = match behaviour {
        Behaviour::Step(function) => step::expand(&p, function.as_ref()),
        Behaviour::Machine(machine) => machine::expand(&p, machine),
        Behaviour::Unclear => TokenStream::new(),
    };
    let hooks = (!matches!(behaviour, Behaviour::Unclear)).then(|| hooks::expand(component));
    quote! {
        #[automatically_derived]
        impl #parameters #p::MemberOf<__T> for #own #bounds {
            #node
            const TIMED: bool = #timed;

            #[inline]
            fn pass<__P: #p::Probe>(cycle: &mut #p::Cycle<'_, __T, __P>, visit: #p::Visit) {
                #pass
            }

            #hooks
        }
    }
}

/// `__T: Has<child>`, with the child's place in a signature for the compiler to point at.
fn holds(p: &TokenStream, child: &Type) -> WherePredicate {
    let p = placed(p, at(child));
    parse_quote_spanned!(at(child) => __T: #p::Has<#child>)
}

/// The visits of some children.
pub(super) fn visits(p: &TokenStream, children: &[Type]) -> TokenStream {
    quote!(#(<__T as #p::Has<#children>>::visit(cycle);)*)
}

fn timed(component: &Component) -> bool {
    component.functions().flat_map(|function| &function.arguments).any(|argument| matches!(argument, Argument::Time))
}

/// All children, each once.
fn children(component: &Component, behaviour: &Behaviour) -> Vec<Type> {
    let links: Vec<Links> = match behaviour {
        Behaviour::Machine(machine) => (0..machine.states.len()).map(|at| Links::of_state(machine, at)).collect(),
        Behaviour::Step(_) | Behaviour::Unclear => vec![Links::of(component.functions())],
    };
    let mut seen = BTreeSet::new();
    links.iter().flat_map(Links::children).filter(|child| seen.insert(text::written(child))).cloned().collect()
}
