//! `impl ParamEnum`.

use proc_macro2::TokenStream;
use quote::quote;

use crate::expand::quoting::{enclosed, runtime};
use bica_syntax::params::model::Choice;
use bica_syntax::report::Report;
use bica_syntax::text;

/// The trait of an enum that is a parameter.
pub(crate) fn choice(choice: &Choice) -> TokenStream {
    let (p, name) = (runtime(), &choice.name);
    let variants: Vec<_> = choice.variants.iter().map(|(variant, _)| variant).collect();
    let labels = choice.variants.iter().map(|(variant, _)| text::name(variant));
    let docs = choice.variants.iter().map(|(_, doc)| doc);
    let indices: Vec<u32> = (0..).take(variants.len()).collect();
    let items = quote! {
        #[automatically_derived]
        impl #p::ParamEnum for #name {
            const VARIANTS: &'static [#p::Variant] = &[#(#p::Variant { name: #labels, doc: #p::doc(#docs) }),*];

            fn index(&self) -> ::core::primitive::u32 {
                match self {
                    #(Self::#variants => #indices,)*
                }
            }

            fn at(index: ::core::primitive::u32) -> ::core::option::Option<Self> {
                match index {
                    #(#indices => ::core::option::Option::Some(Self::#variants),)*
                    _ => ::core::option::Option::None,
                }
            }
        }
    };
    enclosed(&choice.krate, &items)
}

/// The mistakes, and an enum without choices.
pub(crate) fn choice_stub(choice: &Choice, report: &Report) -> TokenStream {
    let (name, krate, errors) = (&choice.name, &choice.krate, report.to_compile_errors());
    if choice.generic {
        return errors;
    }
    let p = runtime();
    let items = quote! {
        #[automatically_derived]
        impl #p::ParamEnum for #name {
            const VARIANTS: &'static [#p::Variant] = &[];
            fn index(&self) -> ::core::primitive::u32 {
                0
            }
            fn at(_: ::core::primitive::u32) -> ::core::option::Option<Self> {
                ::core::option::Option::None
            }
        }
    };
    let items = enclosed(krate, &items);
    quote!(#items #errors)
}
