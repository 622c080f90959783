//! `activation_tree!`: parse → check → expand.

use proc_macro2::TokenStream;
use quote::quote;

use crate::expand::tree as expand;
use crate::language::report::Report;
use crate::language::tree::{check, parse};

/// Expands `activation_tree! { input }`.
pub(crate) fn run(input: TokenStream) -> TokenStream {
    let mut report = Report::default();
    let Some(tree) = parse::parse(input, &mut report) else {
        return report.to_compile_errors();
    };
    let tree = check::check(tree, &mut report);
    let code = tree.map(|tree| expand::expand(&tree, report.is_empty()));
    let errors = report.to_compile_errors();
    quote!(#code #errors)
}
