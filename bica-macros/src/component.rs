//! `#[component]`: parse → check → expand.

use proc_macro2::TokenStream;

use crate::expand::component as expand;
use bica_syntax::component::check;
use bica_syntax::component::parse::{Parsed, parse};
use bica_syntax::report::Report;

/// Expands `#[component(options)] item`.
pub(crate) fn run(options: TokenStream, item: &TokenStream) -> TokenStream {
    let mut report = Report::default();
    let component = match parse(options, item, &mut report) {
        Parsed::Component(component) => component,
        Parsed::Misplaced { item, of } => return expand::misplaced(&item, of.as_deref(), &report),
    };
    match check::check(&component, &mut report) {
        Some(behaviour) if report.is_empty() => expand::expand(&component, &behaviour),
        _ => expand::stub(&component, &report),
    }
}
