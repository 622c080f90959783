//! `activation_tree!`: parse → check → expand.

use std::hash::{DefaultHasher, Hash, Hasher};

use proc_macro2::TokenStream;

use crate::expand::tree as expand;
use bica_syntax::report::Report;
use bica_syntax::tree::{check, parse};

/// Expands `activation_tree! { input }`, which stands at this line and column.
pub(crate) fn run(input: TokenStream, place: (usize, usize)) -> TokenStream {
    let mut report = Report::default();
    // A `macro_rules` macro may write several trees at one place.
    let mut number = DefaultHasher::new();
    (place, input.to_string()).hash(&mut number);
    let Some(draft) = parse::parse(input, &mut report) else {
        return report.to_compile_errors();
    };
    match check::check(&draft, &mut report) {
        Some(tree) => expand::expand(&tree, number.finish()),
        None if draft.names_a_component() => report.to_compile_errors(),
        None => expand::stub(&draft, &report),
    }
}
