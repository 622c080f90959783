//! Attributes of a struct or an enum that is no impl block: `#[output]` and `#[derive(ComponentDoc)]`.

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::{DeriveInput, Path, Token, parse_quote};

use crate::report::Report;
use crate::{text, wording};

/// The crate that `#[output(crate = path)]` names, with mistakes reported.
pub fn output(options: TokenStream, item: &TokenStream, report: &mut Report) -> Path {
    if syn::parse2::<DeriveInput>(item.clone()).is_err() {
        report.add(item, wording::OUTPUT_ITEM);
    }
    let parser = |input: syn::parse::ParseStream| {
        if input.is_empty() {
            return Ok(parse_quote!(::bica));
        }
        let form = |found: syn::Error| syn::Error::new(found.span(), wording::OUTPUT_FORM);
        input.parse::<Token![crate]>().map_err(form)?;
        input.parse::<Token![=]>().map_err(form)?;
        input.call(Path::parse_mod_style).map_err(form)
    };
    let krate = syn::parse::Parser::parse2(parser, options);
    report.take(krate).unwrap_or_else(|| parse_quote!(::bica))
}

/// The item with `#[derive(ComponentDoc)]`, and its doc comment.
pub fn component_doc(item: TokenStream, report: &mut Report) -> Option<(DeriveInput, String)> {
    let input: DeriveInput = report.take(syn::parse2(item))?;
    let doc = text::doc(&input.attrs);
    if doc.is_empty() {
        report.add(input.ident.to_token_stream(), wording::component_doc(&text::name(&input.ident)));
    }
    Some((input, doc))
}
