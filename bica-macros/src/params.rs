//! `#[derive(Params)]` and `#[derive(ParamEnum)]`: parse → expand.

use proc_macro2::TokenStream;

use crate::expand::params as expand;
use bica_syntax::params::parse;
use bica_syntax::report::Report;

/// Expands `#[derive(Params)] item`.
pub(crate) fn params(item: TokenStream) -> TokenStream {
    let mut report = Report::default();
    match parse::params(item, &mut report) {
        Some(params) if report.is_empty() => expand::params(&params),
        Some(params) => expand::stub(&params, &report),
        None => report.to_compile_errors(),
    }
}

/// Expands `#[derive(ParamEnum)] item`.
pub(crate) fn choice(item: TokenStream) -> TokenStream {
    let mut report = Report::default();
    match parse::choice(item, &mut report) {
        Some(choice) if report.is_empty() => expand::choice(&choice),
        Some(choice) => expand::choice_stub(&choice, &report),
        None => report.to_compile_errors(),
    }
}
