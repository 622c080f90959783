//! `hz = 30, budget_us = 40, resume, crate = ::bica`

use proc_macro2::{Ident, TokenStream};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Path, Token, parse_quote};

use super::model::Options;
use crate::language::report::Report;
use crate::language::{number, text, wording};

const KEYS: [&str; 4] = ["hz", "budget_us", "resume", "crate"];

/// Reads the options; what cannot be read keeps its default.
pub(crate) fn parse(tokens: TokenStream, report: &mut Report) -> Options {
    let mut options = Options { hz: None, budget_us: None, resume: None, krate: parse_quote!(::bica) };
    let mut seen = Vec::new();
    let parser = |input: ParseStream| {
        while !input.is_empty() {
            one(input, &mut options, &mut seen, report)?;
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        Ok(())
    };
    let parsed = parser.parse2(tokens);
    report.take(parsed);
    options
}

fn one(input: ParseStream, options: &mut Options, seen: &mut Vec<Ident>, report: &mut Report) -> syn::Result<()> {
    let key = input.call(Ident::parse_any)?;
    if seen.contains(&key) {
        report.add(&key, wording::TWICE);
    }
    match key.to_string().as_str() {
        "hz" => options.hz = positive(input, "hz", report)?,
        "budget_us" => options.budget_us = positive(input, "budget_us", report)?,
        "resume" => options.resume = Some(key.clone()),
        "crate" => {
            input.parse::<Token![=]>()?;
            options.krate = input.call(Path::parse_mod_style)?;
        }
        other => {
            let nearest = text::nearest(other, KEYS.into_iter());
            return Err(syn::Error::new(
                key.span(),
                wording::unknown_key(other, nearest, "`hz`, `budget_us` and `resume`"),
            ));
        }
    }
    seen.push(key);
    Ok(())
}

fn positive(input: ParseStream, key: &str, report: &mut Report) -> syn::Result<Option<f32>> {
    input.parse::<Token![=]>()?;
    Ok(number::positive(&input.parse()?, key, report))
}
