//! `root: ..., cycle_hz: ..., budget_ms: ..., tunable, roles: {...}, components: [...]`

use proc_macro2::{Ident, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Attribute, Expr, Path, Token, Type, braced, bracketed, token};

use super::model::{Draft, Entry, RoleEntry};
use super::names;
use crate::code::Code;
use crate::comma::comma;
use crate::report::{Mistake, Report};
use crate::types::{plain, unsized_argument};
use crate::{number, text, wording};

/// The fields that messages name; `crate` is for the crates of the framework.
const KEYS: [&str; 6] = ["root", "cycle_hz", "budget_ms", "tunable", "roles", "components"];
const KNOWN: &str = "`root`, `cycle_hz`, `budget_ms`, `tunable`, `roles` and `components`";

/// Names that a user may try, and the field that was meant.
const SYNONYMS: [(&str, &str); 12] = [
    ("hz", "cycle_hz"),
    ("rate", "cycle_hz"),
    ("frequency", "cycle_hz"),
    ("budget", "budget_ms"),
    ("budget_us", "budget_ms"),
    ("nodes", "components"),
    ("children", "components"),
    ("list", "components"),
    ("providers", "roles"),
    ("tuned", "tunable"),
    ("tuneable", "tunable"),
    ("adjustable", "tunable"),
];

/// Reads the fields of a tree; continues after one that is wrong.
pub(super) fn parse(input: ParseStream, draft: &mut Draft, report: &mut Report) -> syn::Result<()> {
    let mut seen: Vec<Ident> = Vec::new();
    let mut semicolons = false;
    while !input.is_empty() {
        let mut read = one(input, &mut seen, draft, report);
        if read.is_ok() && input.peek(Token![;]) {
            let semicolon: Token![;] = input.parse()?;
            if !std::mem::replace(&mut semicolons, true) {
                report.add(semicolon, wording::SEMICOLON);
            }
            continue;
        }
        read = read.and_then(|()| Ok(comma(input)?));
        if let Err(error) = read {
            report.push(error);
            skip(input)?;
        }
    }
    Ok(())
}

/// Skips to the next name of a field.
fn skip(input: ParseStream) -> syn::Result<()> {
    while !input.is_empty() && !at_a_field(input) {
        input.parse::<TokenTree>()?;
    }
    Ok(())
}

fn at_a_field(input: ParseStream) -> bool {
    let separated = (input.peek2(Token![:]) && !input.peek2(Token![::])) || input.peek2(Token![=]);
    input.peek(syn::Ident) && separated
}

fn one(input: ParseStream, seen: &mut Vec<Ident>, draft: &mut Draft, report: &mut Report) -> Result<(), Mistake> {
    no_attribute(input)?;
    let key = input.call(Ident::parse_any).map_err(|found| syn::Error::new(found.span(), wording::FIELD_NAME))?;
    let name = key.to_string();
    if seen.contains(&key) {
        report.add(&key, wording::TWICE);
    }
    if name != "crate" && !KEYS.contains(&name.as_str()) {
        return Err(unknown(&key, &name));
    }
    seen.push(key);
    if name == "tunable" {
        draft.tunable = true;
        let ends = input.is_empty() || input.peek(Token![,]) || input.peek(Token![;]);
        return if ends { Ok(()) } else { Err(input.error(wording::TUNABLE_VALUE).into()) };
    }
    input.parse::<Token![:]>().map_err(|found| syn::Error::new(found.span(), wording::colon(&name)))?;
    match name.as_str() {
        "root" => draft.root = Some(component(input)?),
        "cycle_hz" => draft.cycle_hz = number::positive(&value(input, &name)?, &name, report),
        "budget_ms" => draft.budget_ms = number::positive(&value(input, &name)?, &name, report),
        "components" => components(input, draft, report)?,
        "roles" => roles(input, draft, report)?,
        _ => {
            let form = |found: syn::Error| syn::Error::new(found.span(), wording::crate_form("crate: bica_core"));
            draft.krate = input.call(Path::parse_mod_style).map_err(form)?;
        }
    }
    Ok(())
}

fn value(input: ParseStream, key: &str) -> syn::Result<Expr> {
    input.parse().map_err(|found: syn::Error| syn::Error::new(found.span(), wording::no_number(key)))
}

fn no_attribute(input: ParseStream) -> syn::Result<()> {
    let attributes = input.call(Attribute::parse_outer)?;
    attributes.first().map_or(Ok(()), |first| Err(syn::Error::new_spanned(first, wording::FIELD_ATTRIBUTE)))
}

fn component(input: ParseStream) -> syn::Result<Type> {
    no_attribute(input)?;
    if input.peek(Token![,]) {
        return Err(input.error(wording::EXTRA_COMMA));
    }
    let kind: Type =
        input.parse().map_err(|found: syn::Error| syn::Error::new(found.span(), wording::COMPONENT_TYPE))?;
    if !matches!(plain(&kind), Type::Path(_)) {
        return Err(syn::Error::new_spanned(&kind, wording::COMPONENT_TYPE));
    }
    if let Some(of) = unsized_argument(&kind) {
        return Err(syn::Error::new_spanned(of, wording::no_size(&text::written(of))));
    }
    if input.peek(token::Paren) || input.peek(token::Brace) {
        return Err(syn::Error::new_spanned(&kind, wording::COMPONENT_VALUE));
    }
    Ok(kind)
}

/// Reads the roles; continues after an entry that is wrong.
fn roles(input: ParseStream, draft: &mut Draft, report: &mut Report) -> syn::Result<()> {
    if !input.peek(token::Brace) {
        return Err(input.error(wording::ROLE_LIST));
    }
    let content;
    braced!(content in input);
    while !content.is_empty() {
        match role(&content) {
            Ok(entry) => draft.roles.push(entry),
            Err(error) => {
                report.push(error);
                skip_entry(&content)?;
            }
        }
    }
    Ok(())
}

fn role(input: ParseStream) -> syn::Result<RoleEntry> {
    no_attribute(input)?;
    if input.peek(Token![,]) {
        return Err(input.error(wording::EXTRA_COMMA));
    }
    let role = input.call(Path::parse_mod_style).map_err(|found| syn::Error::new(found.span(), wording::ROLE_LIST))?;
    input.parse::<Token![:]>().map_err(|found| syn::Error::new(found.span(), wording::ROLE_LIST))?;
    if input.peek(token::Bracket) {
        return Err(input.error(wording::ONE_PROVIDER));
    }
    let provider = component(input)?;
    comma(input)?;
    Ok(RoleEntry { role, provider })
}

/// Skips the rest of an entry and its comma.
fn skip_entry(content: ParseStream) -> syn::Result<()> {
    while !content.is_empty() && content.parse::<Option<Token![,]>>()?.is_none() {
        content.parse::<TokenTree>()?;
    }
    Ok(())
}

/// Reads the list; continues after an entry that is wrong.
fn components(input: ParseStream, draft: &mut Draft, report: &mut Report) -> syn::Result<()> {
    if !input.peek(token::Bracket) {
        return Err(input.error(wording::COMPONENT_LIST));
    }
    let content;
    bracketed!(content in input);
    let entries = draft.components.insert(Vec::new());
    while !content.is_empty() {
        match entry(&content) {
            Ok(entry) => entries.push(entry),
            Err(error) => {
                report.push(error);
                skip_entry(&content)?;
            }
        }
    }
    Ok(())
}

fn entry(input: ParseStream) -> syn::Result<Entry> {
    let name = names::name(input)?;
    let kind = component(input).map_err(|error| match &name {
        Some(name) => syn::Error::new(error.span(), wording::named_component(&text::name(name))),
        None => error,
    })?;
    if input.peek(Token![:]) {
        return Err(input.error(wording::VALUE_SIGN));
    }
    if name.is_none() {
        names::is_type(input, &kind)?;
    }
    let value = if input.parse::<Option<Token![=]>>()?.is_some() { Some(input.parse()?) } else { None };
    comma(input)?;
    Ok(Entry { name, kind, value })
}

fn unknown(key: &Ident, written: &str) -> Mistake {
    let synonym = SYNONYMS.iter().find(|(other, _)| *other == written).map(|(_, field)| *field);
    let nearest = synonym.or_else(|| text::nearest(written, KEYS.into_iter()));
    Mistake::new(key, Code::unknown_key(written, nearest, KNOWN))
}
