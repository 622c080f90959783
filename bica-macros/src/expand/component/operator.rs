//! Outputs and calls for an operator: `#[output]` and `#[modulation]`.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote, quote_spanned};

use crate::expand::params::describe;
use crate::expand::quoting::{at, option, placed, runtime};
use bica_syntax::component::model::{Component, Modulation, Output, Placement};
use bica_syntax::text;

/// The descriptions, for `impl Component`.
pub(super) fn descriptions(component: &Component) -> TokenStream {
    let p = runtime();
    let outputs = component.outputs.iter().map(|output| {
        let (name, doc, unit, ty) =
            (text::name(&output.name), &output.doc, option(output.unit.as_ref()), text::written(&output.ty));
        let placement = option(output.placement.as_ref().map(|placement| placed_at(output, placement)).as_ref());
        quote!(#p::Output { name: #name, doc: #p::Doc::new(#doc), unit: #unit, ty: #ty, placement: #placement })
    });
    let outputs =
        (!component.outputs.is_empty()).then(|| quote!(const OUTPUTS: &'static [#p::Output] = &[#(#outputs),*];));
    let modulations = (!component.modulations.is_empty()).then(|| modulations(&p, &component.modulations));
    quote!(#outputs #modulations)
}

/// The placement of an output. The compiler points at its type if it is not visual.
fn placed_at(output: &Output, Placement { frame, child }: &Placement) -> TokenStream {
    let (ty, place) = (&output.ty, at(&output.ty));
    let p = placed(&runtime(), place);
    match child {
        None => quote_spanned!(place => const { &#p::placed::<#ty>(#frame) }),
        Some(child) => quote_spanned!(place => const { &#p::placed_frame::<#ty>(#frame, #child) }),
    }
}

fn modulations(p: &TokenStream, all: &[Modulation]) -> TokenStream {
    let each = all.iter().map(|modulation| description(p, modulation));
    let checks = all.iter().enumerate().flat_map(|(index, modulation)| checks(p, modulation, &quote!(list[#index])));
    quote! {
        const MODULATIONS: &'static [#p::Modulation] = {
            let list: &'static [#p::Modulation] = const { &[#(#each),*] };
            #(#checks;)*
            list
        };
    }
}

/// `Modulation { ... }`
pub(crate) fn description(p: &TokenStream, modulation: &Modulation) -> TokenStream {
    let (name, doc) = (text::name(&modulation.name), &modulation.doc);
    let (stops, drives) = (modulation.stops, modulation.drives);
    let arguments = modulation.arguments.iter().map(|field| {
        let default = field.default.as_ref().map(|default| quote!(#default));
        describe::param(p, field, default.as_ref())
    });
    quote! {
        #p::Modulation {
            name: #name, doc: #p::doc(#doc), stops: #stops, drives: #drives, arguments: &[#(#arguments),*]
        }
    }
}

/// The checks of the arguments that `described` describes.
pub(crate) fn checks(p: &TokenStream, modulation: &Modulation, described: &TokenStream) -> Vec<TokenStream> {
    let each = modulation.arguments.iter().enumerate().flat_map(|(place, field)| {
        describe::checks(p, field, &quote!(#described.arguments[#place])).into_iter().map(|(_, check)| check)
    });
    let place = at(&modulation.name);
    let (p, described) = (placed(p, place), placed(described, place));
    each.chain([quote_spanned!(place => #p::assert_arguments(&#described))]).collect()
}

/// The functions of `impl MemberOf`.
pub(super) fn functions(component: &Component) -> TokenStream {
    let p = runtime();
    let read = (!component.outputs.is_empty()).then(|| read(&p, &component.outputs));
    let call = (!component.modulations.is_empty()).then(|| call(&p, &component.modulations));
    quote!(#read #call)
}

fn read(p: &TokenStream, outputs: &[Output]) -> TokenStream {
    let arms = outputs.iter().enumerate().map(|(index, output)| {
        let (name, place) = (&output.name, at(&output.ty));
        let p = placed(p, place);
        let take = quote_spanned!(place => {
            use #p::Unfit as _;
            #p::Of(&value).give(sink)
        });
        quote!(#index => { let value = this.#name(); #take; })
    });
    quote! {
        fn read_output<__S: #p::OutputSink>(tree: &__T, index: ::core::primitive::usize, sink: &mut __S) -> ::core::primitive::bool {
            let this = #p::component::<__T, Self>(tree);
            match index {
                #(#arms)*
                _ => return false,
            }
            true
        }
    }
}

fn call(p: &TokenStream, modulations: &[Modulation]) -> TokenStream {
    let arms = modulations.iter().enumerate().map(|(index, modulation)| {
        let called = |name: &Ident, values: &[Ident]| quote!(this.#name(#(#values),*););
        arm(p, index, modulation, &quote!(return), called)
    });
    quote! {
        fn modulate(tree: &mut __T, index: ::core::primitive::usize, arguments: &[#p::Value]) {
            let this = #p::component_mut::<__T, Self>(tree);
            match (index, arguments) {
                #(#arms)*
                _ => {}
            }
        }
    }
}

/// The arm of a match over index and values that calls a method: `called` writes the call. `refused` leaves the function for a value
/// of another kind, which does not come.
pub(crate) fn arm(
    p: &TokenStream,
    index: usize,
    modulation: &Modulation,
    refused: &TokenStream,
    called: impl FnOnce(&Ident, &[Ident]) -> TokenStream,
) -> TokenStream {
    let names: Vec<Ident> = (0..modulation.arguments.len()).map(|place| format_ident!("a{place}")).collect();
    let pairs = modulation.arguments.iter().zip(&names);
    let values = pairs.map(|(field, name)| describe::from_value(p, field, &quote!(*#name)));
    let call = called(&modulation.name, &names);
    quote! {
        (#index, [#(#names),*]) => {
            #(
                let #names = #values;
                let ::core::option::Option::Some(#names) = #names else { #refused };
            )*
            #call
        }
    }
}
