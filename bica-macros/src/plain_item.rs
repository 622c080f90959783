//! `#[data]` and `#[derive(ComponentDoc)]`: parse → expand.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use bica_syntax::plain_item;
use bica_syntax::report::Report;

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
    let marked = plain_item::data(item, &krate);
    quote! {
        #krate::__private::data! {
            { #[serde(crate = #serde)] #[postcard(crate = #krate::__private::postcard_schema)] }
            { #marked }
            { #item }
        }
    }
}

/// Refuses an attribute of earlier programs, and does what its successor does, so that nothing else is reported.
pub(crate) fn earlier(attribute: &str, options: TokenStream, item: &TokenStream) -> TokenStream {
    let error = plain_item::earlier(attribute, item).to_compile_error();
    if syn::parse2::<syn::DeriveInput>(item.clone()).is_err() {
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
