//! The code of a tree with mistakes: a tree that accepts every component, so that one mistake gives one message.

use proc_macro2::TokenStream;
use quote::quote;

use bica_syntax::report::Report;
use bica_syntax::tree::model::Draft;

/// The struct that the user names, the mistakes, and traits without content.
pub(crate) fn stub(draft: &Draft, report: &Report) -> TokenStream {
    let Draft { attributes, visibility, name, krate, .. } = draft;
    let (p, errors) = (quote!(#krate::__private), report.to_compile_errors());
    let traits = traits(draft, &p);
    quote! {
        #(#attributes)*
        #visibility struct #name {
            engine: #p::Engine<#name>,
        }

        impl #name {
            #visibility const fn new() -> Self {
                Self { engine: #p::Engine::new(()) }
            }
        }

        #[automatically_derived]
        impl ::core::default::Default for #name {
            fn default() -> Self {
                Self::new()
            }
        }

        const _: () = {
            #traits
        };

        #errors
    }
}

fn traits(draft: &Draft, p: &TokenStream) -> TokenStream {
    let name = &draft.name;
    let layout = layout(draft, p);
    quote! {
        #layout

        impl #p::Tree for #name {
            const GRAPH: #p::Graph = #p::Graph {
                name: "", doc: "", cycle_hz: 1.0, budget_ms: ::core::option::Option::None, tunable: false, root: 0, nodes: &[], roles: &[],
                version: ::core::option::Option::None, commit: ::core::option::Option::None,
            };
        }

        /// Any component.
        pub struct Any;

        impl #p::Component for Any {
            type Itself = Self;
            type Block = ();
            const NAME: &'static ::core::primitive::str = "";
            const DOC: &'static ::core::primitive::str = "";
            const HZ: ::core::option::Option<::core::primitive::f32> = ::core::option::Option::None;
            const BUDGET_US: ::core::option::Option<::core::primitive::f32> = ::core::option::Option::None;
            const RESUME: ::core::primitive::bool = false;
            const STATES: &'static [#p::State] = &[];
            type Params = ();
            const DEFAULT_PARAMS: () = ();
            const CONSTANT_PARAMS: &'static () = &();
            type Work = ();
        }

        impl #p::MemberOf<#name> for Any {
            const WRITTEN: &'static [#p::WrittenLink] = &[];
            const NODE: #p::Node = ::core::unreachable!();
            const TIMED: ::core::primitive::bool = false;
            fn pass<__P: #p::Probe>(_: &mut #p::Cycle<'_, #name, __P>, _: #p::Visit) {}
        }

        impl<__C: 'static> #p::Has<__C> for #name {
            type Member = Any;
            type Stored = ();
            const INDEX: ::core::primitive::usize = 0;
            fn slot(_: &Self::Slots) -> &#p::Slot<__C> {
                ::core::unreachable!()
            }
            fn visit<__P: #p::Probe>(_: &mut #p::Cycle<'_, Self, __P>) {}
            fn visit_shared<__P: #p::Probe>(_: &mut #p::Cycle<'_, Self, __P>) {}
            fn visit_once<__P: #p::Probe>(_: &mut #p::Cycle<'_, Self, __P>) {}
        }
    }
}

fn layout(draft: &Draft, p: &TokenStream) -> TokenStream {
    let name = &draft.name;
    quote! {
        impl #p::Layout for #name {
            type Slots = ();
            const CYCLE_HZ: ::core::primitive::f32 = 1.0;
            const ACTIVATORS: &'static [::core::primitive::usize] = &[];
            const ORDER: &'static [::core::primitive::u16] = &[];
            fn engine(&self) -> &#p::Engine<Self> {
                &self.engine
            }
            fn engine_mut(&mut self) -> &mut #p::Engine<Self> {
                &mut self.engine
            }
            fn visit_root<__P: #p::Probe>(_: &mut #p::Cycle<'_, Self, __P>) {}
            fn visit<__P: #p::Probe>(_: &mut #p::Cycle<'_, Self, __P>, _: ::core::primitive::usize) {}
            fn stop<__P: #p::Probe>(_: &mut #p::Cycle<'_, Self, __P>, _: ::core::primitive::usize) {}
            fn component_state(_: &Self::Slots, _: ::core::primitive::usize) -> ::core::option::Option<&#p::ComponentState> {
                ::core::option::Option::None
            }
            fn member<__M: #p::Member<Self>>(_: ::core::primitive::usize, _: __M) -> ::core::option::Option<__M::Output> {
                ::core::option::Option::None
            }
            fn hz(&self, _: ::core::primitive::usize) -> ::core::option::Option<::core::primitive::f32> {
                ::core::option::Option::None
            }
            fn set_hz(&mut self, _: ::core::primitive::usize, _: ::core::option::Option<::core::primitive::f32>) {}
        }
    }
}
