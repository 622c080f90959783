//! `#[output]` and `#[derive(ComponentDoc)]`: parse → expand.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use bica_syntax::plain_item;
use bica_syntax::report::Report;

/// Expands `#[output(options)] item`.
pub(crate) fn output(options: TokenStream, item: &TokenStream) -> TokenStream {
    let mut report = Report::default();
    let krate = plain_item::output(options, item, &mut report);
    if !report.is_empty() {
        let errors = report.to_compile_errors();
        return quote!(#item #errors);
    }
    // Serde reads its path from a text.
    let serde = format!("{}::__private::serde", krate.to_token_stream()).replace(' ', "");
    quote! {
        #krate::__private::output! {
            { #[serde(crate = #serde)] #[postcard(crate = #krate::__private::postcard_schema)] }
            #item
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
            pub const __DOC: &'static str = #doc;
        }
        #errors
    }
}
