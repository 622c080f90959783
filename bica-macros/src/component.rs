//! `#[component]`: parse → check → expand.

use proc_macro2::TokenStream;
use quote::quote;

use crate::expand::component as expand;
use crate::language::component::{check, parse};
use crate::language::report::Report;

/// Expands `#[component(options)] item`.
pub(crate) fn run(options: TokenStream, item: &TokenStream) -> TokenStream {
    let mut report = Report::default();
    let Some(component) = parse::parse(options, item, &mut report) else {
        let errors = report.to_compile_errors();
        return quote!(#item #errors);
    };
    let behaviour = check::check(&component, &mut report);
    match behaviour {
        Some(behaviour) if report.is_empty() => expand::expand(&component, &behaviour),
        _ => expand::stand_in(&component, &report),
    }
}
