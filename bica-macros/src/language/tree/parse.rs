//! From tokens to a tree as written.

use proc_macro2::{Ident, TokenStream};
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Token, Visibility, braced, parse_quote};

use super::fields;
use super::model::Draft;
use crate::language::report::Report;
use crate::language::wording;

/// Reads the tree; `None` if it has not even a name.
pub(crate) fn parse(input: TokenStream, report: &mut Report) -> Option<Draft> {
    let mut draft = None;
    let parser = |input: ParseStream| {
        let draft = draft.insert(head(input)?);
        let content;
        braced!(content in input);
        input.parse::<Option<Token![;]>>()?;
        fields::parse(&content, draft, report)
    };
    let parsed = parser.parse2(input);
    report.take(parsed);
    draft
}

/// `/// docs` `pub struct Name`
fn head(input: ParseStream) -> syn::Result<Draft> {
    let attributes = input.call(Attribute::parse_outer)?;
    let visibility: Visibility = input.parse()?;
    let form = |error: syn::Error| syn::Error::new(error.span(), wording::TREE_FORM);
    input.parse::<Token![struct]>().map_err(form)?;
    let name: Ident = input.parse().map_err(form)?;
    let krate = parse_quote!(::bica);
    Ok(Draft { attributes, visibility, name, root: None, cycle_hz: None, budget_ms: None, components: None, krate })
}
