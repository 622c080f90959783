//! `hz = 30, budget_us = 40, resume, writers = first, crate = ::bica`

use proc_macro2::{Ident, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Expr, Path, Token, parse_quote};

use super::model::{Options, Writers};
use crate::code::Code;
use crate::comma::comma;
use crate::report::{Mistake, Report};
use crate::{number, text, wording};

/// The options that messages name; `crate` is for the crates of the framework.
const KEYS: [&str; 4] = ["hz", "budget_us", "resume", "writers"];
const KNOWN: &str = "`hz`, `budget_us`, `resume` and `writers`";

/// Names that a user may try, and the option that was meant.
const SYNONYMS: [(&str, &str); 14] = [
    ("writer", "writers"),
    ("written", "writers"),
    ("first", "writers"),
    ("last", "writers"),
    ("rate", "hz"),
    ("rate_hz", "hz"),
    ("cycle_hz", "hz"),
    ("frequency", "hz"),
    ("freq", "hz"),
    ("period", "hz"),
    ("period_ms", "hz"),
    ("budget", "budget_us"),
    ("budget_ms", "budget_us"),
    ("budget_ns", "budget_us"),
];

/// Reads the options; an option that cannot be read keeps its default.
pub(crate) fn parse(tokens: TokenStream, report: &mut Report) -> Options {
    let mut options = Options { hz: None, budget_us: None, resume: None, writers: None, krate: parse_quote!(::bica) };
    let mut seen = Vec::new();
    let parser = |input: ParseStream| {
        while !input.is_empty() {
            let read = one(input, &mut options, &mut seen, report).and_then(|()| Ok(comma(input)?));
            if let Err(error) = read {
                report.push(error);
                skip(input)?;
            }
        }
        Ok(())
    };
    let parsed = parser.parse2(tokens);
    report.take(parsed);
    options
}

/// Skips to the token after the next comma.
fn skip(input: ParseStream) -> syn::Result<()> {
    while !input.is_empty() {
        if input.parse::<Option<Token![,]>>()?.is_some() {
            break;
        }
        input.parse::<TokenTree>()?;
    }
    Ok(())
}

fn one(input: ParseStream, options: &mut Options, seen: &mut Vec<Ident>, report: &mut Report) -> Result<(), Mistake> {
    let key = input.call(Ident::parse_any).map_err(|found| syn::Error::new(found.span(), wording::OPTION_FORM))?;
    if seen.contains(&key) {
        report.add(&key, wording::TWICE);
    }
    match key.to_string().as_str() {
        "hz" => options.hz = positive(input, &key, report)?,
        "budget_us" => options.budget_us = positive(input, &key, report)?,
        "resume" => {
            if !input.is_empty() && !input.peek(Token![,]) {
                return Err(input.error(wording::RESUME_VALUE).into());
            }
            options.resume = Some(key.clone());
        }
        "writers" => options.writers = Some(writers(input, &key)?),
        "crate" => {
            let form = |found: syn::Error| syn::Error::new(found.span(), wording::crate_form("crate = bica_core"));
            input.parse::<Token![=]>().map_err(form)?;
            options.krate = input.call(Path::parse_mod_style).map_err(form)?;
        }
        other => return Err(unknown(&key, other)),
    }
    seen.push(key);
    Ok(())
}

fn unknown(key: &Ident, written: &str) -> Mistake {
    let synonym = SYNONYMS.iter().find(|(other, _)| *other == written).map(|(_, option)| *option);
    let nearest = synonym.or_else(|| text::nearest(written, KEYS.into_iter()));
    Mistake::new(key, Code::unknown_key(written, nearest, KNOWN))
}

/// `= first` or `= last`
fn writers(input: ParseStream, key: &Ident) -> syn::Result<Writers> {
    if input.is_empty() || input.peek(Token![,]) {
        return Err(syn::Error::new(key.span(), wording::WRITERS_FORM));
    }
    let form = |found: syn::Error| syn::Error::new(found.span(), wording::WRITERS_FORM);
    input.parse::<Token![=]>().map_err(form)?;
    let word = input.call(Ident::parse_any).map_err(form)?;
    match word.to_string().as_str() {
        "first" => Ok(Writers::First),
        "last" => Ok(Writers::Last),
        _ => Err(syn::Error::new(word.span(), wording::WRITERS_FORM)),
    }
}

fn positive(input: ParseStream, key: &Ident, report: &mut Report) -> syn::Result<Option<f32>> {
    let name = key.to_string();
    if input.is_empty() || input.peek(Token![,]) {
        return Err(syn::Error::new(key.span(), wording::no_number(&name)));
    }
    if !input.peek(Token![=]) {
        return Err(input.error(wording::no_number(&name)));
    }
    input.parse::<Token![=]>()?;
    let value: Expr = input.parse().map_err(|found| syn::Error::new(found.span(), wording::no_number(&name)))?;
    Ok(number::positive(&value, &name, report))
}
