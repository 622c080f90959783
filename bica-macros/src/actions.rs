//! `#[world_actions]`: parse → expand.

use proc_macro2::TokenStream;
use quote::quote;

use crate::expand::actions as expand;
use bica_syntax::component::actions::parse;
use bica_syntax::report::Report;

/// Expands `#[world_actions(options)] item`.
pub(crate) fn run(options: TokenStream, item: &TokenStream) -> TokenStream {
    let mut report = Report::default();
    if let Some(world) = parse(options, item, &mut report) {
        return expand::expand(&world, &report);
    }
    let errors = report.to_compile_errors();
    quote!(#item #errors)
}
