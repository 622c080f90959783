//! `impl Layout`: how the engine gets at the components.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};

use super::{fields, kinds, root, runtime};
use crate::expand::quoting::{at, placed};
use bica_syntax::tree::model::Tree;

pub(super) fn expand(tree: &Tree) -> TokenStream {
    let p = runtime(tree);
    let (name, cycle_hz) = (&tree.name, tree.cycle_hz);
    let count = tree.components.len();
    let (root, kinds) = (&root(tree), kinds(tree));
    let visit = quote_spanned!(at(root) => <Self as #p::Has<#root>>::visit);
    let visit_steady = quote_spanned!(at(root) => <Self as #p::Has<#root>>::visit_steady);
    let (plans, access) = (plans(tree, &p), access(tree, &p));
    quote! {
        #[automatically_derived]
        impl #p::Layout for #name {
            type Slots = __Slots;
            const CYCLE_HZ: ::core::primitive::f32 = #cycle_hz;
            const ACTIVATORS: &'static [::core::primitive::usize] = &#p::activators::<#count>(<Self as #p::Tree>::GRAPH.nodes);
            const WORKS: ::core::primitive::bool = #p::has_work(<Self as #p::Tree>::GRAPH.nodes);
            const AGED: &'static [::core::primitive::bool] = &#p::aged::<#count>(&[#(#p::ages::<Self, #kinds>()),*]);
            const DEFERS: ::core::primitive::bool = #p::deferred(<Self as #p::Tree>::GRAPH.nodes);
            const ORDER: &'static [::core::primitive::u16] = &#p::order(&#p::ranks::<#count>(<Self as #p::Tree>::GRAPH.nodes));

            #[inline]
            fn engine(&self) -> &#p::Engine<Self> {
                &self.engine
            }

            #[inline]
            fn engine_mut(&mut self) -> &mut #p::Engine<Self> {
                &mut self.engine
            }

            #[inline]
            fn visit_root<__P: #p::Probe>(cycle: &mut #p::Cycle<'_, Self, __P>) {
                #visit(cycle);
            }

            #[inline]
            fn run_steady<__P: #p::Probe>(cycle: &mut #p::Cycle<'_, Self, __P>) {
                #visit_steady::<__P, 0>(cycle);
            }

            #plans
            #access
        }
    }
}

/// The plans of steady ticks.
fn plans(tree: &Tree, p: &TokenStream) -> TokenStream {
    let count = tree.components.len();
    let kinds = kinds(tree);
    quote! {
        const PLANS: #p::Plans = const {
            &#p::Planned::<#count>::of(&<Self as #p::Tree>::GRAPH, &[#(#p::borrowed_rates::<Self, #kinds>()),*])
        }.plans();
    }
}

/// The functions that reach a component by its index.
fn access(tree: &Tree, p: &TokenStream) -> TokenStream {
    let states = fields(tree).into_iter().map(|field| {
        let slots = placed(&quote!(slots), at(&field));
        quote_spanned!(at(&field) => #slots.#field.state())
    });
    let kinds = kinds(tree);
    let places: Vec<usize> = (0..kinds.len()).collect();
    quote! {
        fn visit<__P: #p::Probe>(cycle: &mut #p::Cycle<'_, Self, __P>, index: ::core::primitive::usize) {
            match index {
                #(#places => <Self as #p::Has<#kinds>>::visit(cycle),)*
                _ => {}
            }
        }

        fn visit_deferred<__P: #p::Probe>(cycle: &mut #p::Cycle<'_, Self, __P>, index: ::core::primitive::usize) {
            match index {
                #(#places => if const { #p::is_deferred::<Self, #kinds>() } {
                    <Self as #p::Has<#kinds>>::visit_shared(cycle);
                },)*
                _ => {}
            }
        }

        fn stop<__P: #p::Probe>(cycle: &mut #p::Cycle<'_, Self, __P>, index: ::core::primitive::usize) {
            match index {
                #(#places => cycle.stop::<#kinds>(),)*
                _ => {}
            }
        }

        fn component_state(slots: &Self::Slots, index: ::core::primitive::usize) -> ::core::option::Option<&#p::ComponentState> {
            match index {
                #(#places => ::core::option::Option::Some(#states),)*
                _ => ::core::option::Option::None,
            }
        }

        fn member<__M: #p::Member<Self>>(index: ::core::primitive::usize, action: __M) -> ::core::option::Option<__M::Output> {
            match index {
                #(#places => ::core::option::Option::Some(<__M as #p::Member<Self>>::visit::<#kinds>(action)),)*
                _ => ::core::option::Option::None,
            }
        }

        fn hz(&self, index: ::core::primitive::usize) -> ::core::option::Option<::core::primitive::f32> {
            match index {
                #(#places => #p::hz::<Self, #kinds>(self),)*
                _ => ::core::option::Option::None,
            }
        }

        fn set_hz(&mut self, index: ::core::primitive::usize, hz: ::core::option::Option<::core::primitive::f32>) {
            match index {
                #(#places => #p::set_hz::<Self, #kinds>(self, hz),)*
                _ => {}
            }
        }
    }
}
