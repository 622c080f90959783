//! `#[role]`: parse → expand.

use proc_macro2::TokenStream;
use quote::quote;

use crate::expand::quoting::{enclosed, runtime};
use bica_syntax::report::Report;
use bica_syntax::{role, text};

/// Expands `#[role(options)] item`: the trait, and that its type `dyn Trait` is a role of all that implement it.
pub(crate) fn run(options: TokenStream, item: &TokenStream) -> TokenStream {
    let mut report = Report::default();
    let Some(role) = role::parse(options, item, &mut report) else {
        let errors = report.to_compile_errors();
        return quote!(#item #errors);
    };
    let (item, p, errors) = (&role.item, runtime(), report.to_compile_errors());
    let (name, text) = (&item.ident, text::name(&item.ident));
    let traits = enclosed(
        &role.krate,
        &quote! {
            #[automatically_derived]
            impl #p::Role for dyn #name {
                const NAME: #p::RoleName = #p::RoleName { module: ::core::module_path!(), name: #text };
            }

            #[automatically_derived]
            impl<__P: #name> #p::ProvidedBy<__P> for dyn #name {}
        },
    );
    quote!(#item #traits #errors)
}
