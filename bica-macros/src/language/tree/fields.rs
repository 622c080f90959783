//! `root: ..., cycle_hz: ..., budget_ms: ..., components: [...]`

use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Path, Token, bracketed};

use super::model::{Draft, Entry};
use crate::language::report::Report;
use crate::language::{number, text, wording};

const KEYS: [&str; 5] = ["root", "cycle_hz", "budget_ms", "components", "crate"];

/// Reads the fields of a tree.
pub(super) fn parse(input: ParseStream, draft: &mut Draft, report: &mut Report) -> syn::Result<()> {
    let mut seen: Vec<Ident> = Vec::new();
    while !input.is_empty() {
        let key = input.call(Ident::parse_any)?;
        if seen.contains(&key) {
            report.add(&key, wording::TWICE);
        }
        input.parse::<Token![:]>()?;
        field(input, &key, draft, report)?;
        seen.push(key);
        if !input.is_empty() {
            input.parse::<Token![,]>()?;
        }
    }
    Ok(())
}

fn field(input: ParseStream, key: &Ident, draft: &mut Draft, report: &mut Report) -> syn::Result<()> {
    match key.to_string().as_str() {
        "root" => draft.root = Some(input.parse()?),
        // A rate that is no number is one mistake; that the tree then has no rate is not another.
        "cycle_hz" => draft.cycle_hz = number::positive(&input.parse()?, "cycle_hz", report).or(Some(f32::MAX)),
        "budget_ms" => draft.budget_ms = number::positive(&input.parse()?, "budget_ms", report),
        "components" => {
            let content;
            bracketed!(content in input);
            let entries = Punctuated::<Entry, Token![,]>::parse_terminated(&content)?;
            draft.components = Some(entries.into_iter().collect());
        }
        "crate" => draft.krate = input.call(Path::parse_mod_style)?,
        other => {
            let nearest = text::nearest(other, KEYS.into_iter());
            let known = "`root`, `cycle_hz`, `budget_ms` and `components`";
            return Err(syn::Error::new(key.span(), wording::unknown_key(other, nearest, known)));
        }
    }
    Ok(())
}

impl syn::parse::Parse for Entry {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let kind = input.parse()?;
        let value = if input.parse::<Option<Token![=]>>()?.is_some() { Some(input.parse()?) } else { None };
        Ok(Self { kind, value })
    }
}
