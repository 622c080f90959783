//! The visits of children, and the list of links that decides which of them take place.

use proc_macro2::TokenStream;
use quote::quote;
use syn::Type;

use super::role;
use crate::expand::quoting::option;
use bica_syntax::component::links::{Kind, Links};
use bica_syntax::component::model::{Behaviour, Machine};

/// The links of a component: one list for each state, or one for its step.
pub(super) struct Visits {
    runtime: TokenStream,
    states: Vec<Links>,
    machine: bool,
}

impl Visits {
    pub(super) fn of(runtime: &TokenStream, behaviour: &Behaviour) -> Self {
        let (states, machine) = match behaviour {
            Behaviour::Step(step) => (vec![Links::of(step.iter())], false),
            Behaviour::Machine(machine) => (of_states(machine), true),
        };
        Self { runtime: runtime.clone(), states, machine }
    }

    pub(super) fn children(&self) -> impl Iterator<Item = &Type> {
        self.states.iter().flat_map(Links::iter).map(|(_, child)| child)
    }

    /// Number of links as written.
    pub(super) fn len(&self) -> usize {
        self.children().count()
    }

    /// The links as written, those of one state after those of the other.
    pub(super) fn written(&self) -> TokenStream {
        let p = &self.runtime;
        let links = self.states.iter().enumerate().flat_map(|(index, links)| {
            let state = option(self.machine.then_some(index).as_ref());
            links.iter().map(move |(kind, child)| {
                let kind = match kind {
                    Kind::Read => quote!(Read),
                    Kind::Write => quote!(Write),
                    Kind::Rate => quote!(Rate),
                };
                let (to, role) = (role::child(p, child), role::index(p, child));
                quote! {
                    #p::WrittenLink {
                        to: <__T as #p::Has<#to>>::INDEX, kind: #p::WrittenKind::#kind, state: #state, role: #role
                    }
                }
            })
        });
        quote!(&[#(#links),*])
    }

    /// The visits before the component's own code in a state.
    pub(super) fn before(&self, state: usize) -> TokenStream {
        self.some(state, None, |kind| kind == Kind::Read)
    }

    /// The visits after it.
    pub(super) fn after(&self, state: usize) -> TokenStream {
        self.some(state, None, |kind| kind != Kind::Read)
    }

    /// The visits before the own code in a steady tick, of those children to which no earlier visit leads.
    pub(super) fn before_steady(&self, state: usize, plan: &TokenStream) -> TokenStream {
        self.some(state, Some(plan), |kind| kind == Kind::Read)
    }

    /// The visits after it.
    pub(super) fn after_steady(&self, state: usize, plan: &TokenStream) -> TokenStream {
        self.some(state, Some(plan), |kind| kind != Kind::Read)
    }

    /// Whether there are links.
    pub(super) fn exist(&self) -> bool {
        self.children().next().is_some()
    }

    fn some(&self, state: usize, plan: Option<&TokenStream>, wanted: impl Fn(Kind) -> bool) -> TokenStream {
        let p = &self.runtime;
        let first: usize = self.states[..state].iter().map(|links| links.iter().count()).sum();
        let links = &self.states[state];
        let visits = links.iter().enumerate().filter(|(_, (kind, _))| wanted(*kind)).map(|(place, (_, child))| {
            let index = first + place;
            let child = role::child(p, child);
            let counts = links.may_coincide.then(
                || quote!(#p::counts(<Self as #p::MemberOf<__T>>::WRITTEN, #index, <__T as #p::Has<Self>>::INDEX)),
            );
            let is_first = plan.map(|plan| quote!(#p::visits_first::<__T, Self, #child>(#plan)));
            let visit = if let Some(plan) = plan {
                quote!(<__T as #p::Has<#child>>::visit_steady::<__P, #plan>(cycle);)
            } else {
                quote!(<__T as #p::Has<#child>>::visit(cycle);)
            };
            let conditions: Vec<_> = is_first.into_iter().chain(counts).collect();
            if conditions.is_empty() { visit } else { quote!(if const { #(#conditions)&&* } { #visit }) }
        });
        quote!(#(#visits)*)
    }
}

fn of_states(machine: &Machine) -> Vec<Links> {
    (0..machine.states.len()).map(|index| Links::of_state(machine, index)).collect()
}
