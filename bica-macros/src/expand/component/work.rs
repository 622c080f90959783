//! The function that runs beside the loop: its description, and the type whose `begin` takes its arguments.

use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};
use syn::Type;

use super::description;
use crate::expand::quoting::{at, option, runtime};
use bica_syntax::component::model::{Component, Work};
use bica_syntax::text;

/// The items of `impl Component`.
pub(super) fn description(component: &Component) -> TokenStream {
    let p = runtime();
    let Some(work) = &component.work else {
        return quote!(
            type Work = ();
        );
    };
    let (name, doc, takes_ms, slices) = (text::name(&work.name), &work.doc, work.takes_ms, work.slices);
    let result = text::written(&work.output);
    let function = quote! {
        &#p::WorkFunction { name: #name, doc: #p::doc(#doc), takes_ms: #takes_ms, slices: #slices, result: #result }
    };
    let function = option(Some(&function));
    quote! {
        const WORK: ::core::option::Option<&'static #p::WorkFunction> = #function;
        type Work = #p::WorkCell<Self>;
    }
}

/// `impl Working`, and the type with `begin`.
pub(super) fn expand(component: &Component) -> Option<TokenStream> {
    let work = component.work.as_ref()?;
    let (p, own) = (runtime(), component.own());
    let generics = description::owned(&component.block.header.generics);
    let (parameters, arguments, bounds) = generics.split_for_impl();
    let (names, kinds): (Vec<&Ident>, Vec<&Type>) = work.inputs.iter().map(|(name, kind)| (name, kind)).unzip();
    let (state, given, slice) = parts(work, &names, &kinds);
    let (takes_ms, output) = (work.takes_ms, &work.output);
    let output = quote_spanned!(at(output) => type Output = #output;);
    let doc = format!("Begins a job of `{}`, in place of one in progress or a result that nobody took.", work.name);
    Some(quote! {
        #[automatically_derived]
        impl #parameters #p::Working for #own #bounds {
            #state
            #output
            type Begin = __Begin #arguments;
            const BEGIN: Self::Begin = __Begin(#p::Jobs::new());
            const TAKES_MS: ::core::primitive::u32 = #takes_ms;

            fn slice(state: &mut Self::State) -> ::core::option::Option<Self::Output> {
                #slice
            }
        }

        /// The jobs of the component.
        pub struct __Begin #parameters (#p::Jobs<#own>) #bounds;

        impl #parameters __Begin #arguments #bounds {
            #[doc = #doc]
            fn begin(&mut self #(, #names: #kinds)*) {
                self.0.begin(#given);
            }
        }

        impl #parameters ::core::convert::AsRef<#p::Jobs<#own>> for __Begin #arguments #bounds {
            fn as_ref(&self) -> &#p::Jobs<#own> {
                &self.0
            }
        }

        impl #parameters ::core::convert::AsMut<#p::Jobs<#own>> for __Begin #arguments #bounds {
            fn as_mut(&mut self) -> &mut #p::Jobs<#own> {
                &mut self.0
            }
        }
    })
}

/// The type of the state, its value from the arguments of `begin`, and the code of a slice: of work that has none, the only one takes the
/// arguments out.
fn parts(work: &Work, names: &[&Ident], kinds: &[&Type]) -> (TokenStream, TokenStream, TokenStream) {
    let function = &work.name;
    let place = at(kinds.first().map_or_else(|| &work.output, |kind| *kind));
    if work.slices {
        return (
            quote_spanned!(place => type State = #(#kinds)*;),
            quote!(#(#names)*),
            quote_spanned!(at(function) => Self::#function(state)),
        );
    }
    (
        quote_spanned!(place => type State = ::core::option::Option<(#(#kinds,)*)>;),
        quote!(::core::option::Option::Some((#(#names,)*))),
        quote_spanned! {at(function) =>
            let (#(#names,)*) = state.take()?;
            ::core::option::Option::Some(Self::#function(#(#names),*))
        },
    )
}
