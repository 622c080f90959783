//! `#[data]` and `#[derive(ComponentDoc)]`: parse → expand.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote, quote_spanned};
use syn::{DeriveInput, Path};

use crate::expand::quoting::{at, placed};
use bica_syntax::plain_item::{self, Part};
use bica_syntax::report::Report;
use bica_syntax::text;

/// Expands `#[data(options)] item`: the framework's macro `data` derives what the item needs.
pub(crate) fn data(options: TokenStream, item: &TokenStream) -> TokenStream {
    let mut report = Report::default();
    let krate = plain_item::framework(options, item, &mut report);
    if !report.is_empty() {
        let errors = report.to_compile_errors();
        return quote!(#item #errors);
    }
    // Serde reads its path from a text.
    let serde = format!("{}::__private::serde", krate.to_token_stream()).replace(' ', "");
    let item_for_serde = plain_item::data(item, &krate);
    let input = syn::parse2::<DeriveInput>(item.clone()).ok();
    let parts = input.as_ref().map(plain_item::parts).unwrap_or_default();
    let (bounds, asserted) = bounds(&parts, &krate).unzip();
    let marked = input.as_ref().and_then(|input| mark(input, &krate));
    quote! {
        #krate::__private::data! {
            {
                #[serde(crate = #serde)] #[postcard(crate = #krate::__private::postcard_schema)]
                #bounds
            }
            { #item_for_serde }
            { #item }
            { #asserted #marked }
        }
    }
}

/// The bounds of the derived traits on the types of the fields, and the one place where the compiler finds that a type lacks them.
/// `for<'part>` defers the bounds, which name no parameter, to where the traits are used.
fn bounds(parts: &[Part], krate: &Path) -> Option<(TokenStream, TokenStream)> {
    let path = format!("{}::__private", krate.to_token_stream()).replace(' ', "");
    let bounds: Vec<_> = parts
        .iter()
        .map(|part| {
            let kind = if part.in_long_array { "Element" } else { "Part" };
            format!("for<'part> {}: {path}::{kind}", text::written(part.ty))
        })
        .collect();
    let bounds = bounds.join(", ");
    let asserted = parts.iter().map(|part| {
        let (ty, krate) = (part.ty, placed(&krate.to_token_stream(), at(part.ty)));
        if part.in_long_array {
            quote_spanned!(at(ty) => #krate::__private::element::<#ty>();)
        } else {
            quote_spanned!(at(ty) => <#krate::__private::Of<#ty>>::part();)
        }
    });
    (!parts.is_empty()).then(|| {
        let asserted = quote! {
            const _: fn() = || {
                use #krate::__private::Unmarked as _;
                #(#asserted)*
            };
        };
        (quote!(#[serde(bound = #bounds)] #[postcard(bound = #bounds)]), asserted)
    })
}

/// That the type has `#[data]`. What one with parameters lacks depends on its use.
fn mark(input: &DeriveInput, krate: &Path) -> Option<TokenStream> {
    let (name, (parameters, arguments, bounds)) = (&input.ident, input.generics.split_for_impl());
    input.generics.type_params().next().is_none().then(|| {
        quote! {
            #[automatically_derived]
            impl #parameters #krate::__private::Marked for #name #arguments #bounds {}
        }
    })
}

/// Refuses an attribute of earlier programs, and does what its successor does, so that nothing else is reported.
pub(crate) fn earlier(attribute: &str, options: TokenStream, item: &TokenStream) -> TokenStream {
    let error = plain_item::earlier(attribute, item).to_compile_error();
    if syn::parse2::<DeriveInput>(item.clone()).is_err() {
        return quote!(#item #error);
    }
    let expanded = data(options, item);
    quote!(#expanded #error)
}

/// Expands `#[derive(ComponentDoc)] item`.
pub(crate) fn component_doc(item: TokenStream) -> TokenStream {
    let mut report = Report::default();
    let Some((item, doc)) = plain_item::component_doc(item, &mut report) else { return report.to_compile_errors() };
    let (name, errors) = (&item.ident, report.to_compile_errors());
    let (parameters, arguments, bounds) = item.generics.split_for_impl();
    quote! {
        impl #parameters #name #arguments #bounds {
            #[doc(hidden)]
            pub const __DOC: &'static ::core::primitive::str = #doc;
        }
        #errors
    }
}
