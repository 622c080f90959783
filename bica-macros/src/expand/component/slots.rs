//! What transitions carry: a slot in the visit for each state that takes something. A machine without such a state has no slots.

use proc_macro2::{Literal, TokenStream};
use quote::{quote, quote_spanned};

use super::call;
use super::tuning::Tuning;
use crate::expand::quoting::at;
use bica_syntax::component::model::{Edge, Found, Function, Machine};

/// The states that take something, by their index.
pub(super) struct Slots<'a>(Vec<(usize, &'a Found)>);

impl<'a> Slots<'a> {
    pub(super) fn of(machine: &'a Machine) -> Self {
        let states = machine.states.iter().enumerate();
        Self(states.filter_map(|(index, state)| Some((index, state.found()?))).collect())
    }

    pub(super) const fn exist(&self) -> bool {
        !self.0.is_empty()
    }

    /// The type of the slots.
    pub(super) fn kind(&self) -> TokenStream {
        let kinds = self.0.iter().map(|(_, found)| &found.of);
        quote!((#(::core::option::Option<#kinds>,)*))
    }

    /// Empty slots.
    pub(super) fn empty(&self) -> TokenStream {
        let each = self.0.iter().map(|_| quote!(::core::option::Option::None));
        quote!((#(#each,)*))
    }

    fn slot(&self, state: usize) -> Option<TokenStream> {
        let place = Literal::usize_unsuffixed(self.0.iter().position(|(index, _)| *index == state)?);
        Some(quote!(slots.#place))
    }

    /// Whether the value of a condition lets its transition be taken; what it found goes into the slot of the state.
    pub(super) fn holds(&self, edge: &Edge, condition: &TokenStream) -> TokenStream {
        let (Some(slot), Some(of)) = (self.slot(edge.to), &edge.condition.carries) else {
            return quote!(let holds = #condition;);
        };
        // If the two types differ, the compiler points at that of the condition.
        let value = quote_spanned!(at(of) => value);
        quote! {
            let value = #condition;
            #slot = #value;
            let holds = #slot.is_some();
        }
    }

    /// The call of an entry hook of a state, with what was found if it takes that.
    pub(super) fn entry(&self, p: &TokenStream, state: usize, hook: &Function, tuning: &Tuning) -> TokenStream {
        let call = call::expand(p, hook, tuning);
        let (Some(slot), Some(found)) = (self.slot(state), hook.found()) else { return call };
        if found.optional {
            quote!({ let found = ::core::option::Option::map(#slot.take(), #p::Found); #call })
        } else {
            quote!(if let ::core::option::Option::Some(found) = #slot.take() { let found = #p::Found(found); #call })
        }
    }
}
