//! `#[output]`, `#[message]` and `#[derive(ComponentDoc)]`: parse → expand.

use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote};

use bica_syntax::plain_item;
use bica_syntax::report::Report;

/// Expands `#[output(options)] item`.
pub(crate) fn output(options: TokenStream, item: &TokenStream) -> TokenStream {
    deriving("output", options, item, &quote!(#item))
}

/// Expands `#[message(options)] item`.
pub(crate) fn message(options: TokenStream, item: &TokenStream) -> TokenStream {
    // Mistakes in the options are reported below.
    let krate = plain_item::framework("message", options.clone(), item, &mut Report::default());
    let marked = plain_item::message(item, &krate);
    deriving("message", options, item, &quote!({ #marked } { #item }))
}

/// Passes `content` to the framework's macro `attribute`, which derives what an item with this attribute needs.
fn deriving(attribute: &str, options: TokenStream, item: &TokenStream, content: &TokenStream) -> TokenStream {
    let mut report = Report::default();
    let krate = plain_item::framework(attribute, options, item, &mut report);
    if !report.is_empty() {
        let errors = report.to_compile_errors();
        return quote!(#item #errors);
    }
    // Serde reads its path from a text.
    let serde = format!("{}::__private::serde", krate.to_token_stream()).replace(' ', "");
    let derive = format_ident!("{attribute}");
    quote! {
        #krate::__private::#derive! {
            { #[serde(crate = #serde)] #[postcard(crate = #krate::__private::postcard_schema)] }
            #content
        }
    }
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
