//! From tokens to a tree as written.

use proc_macro2::{Ident, TokenStream};
use quote::ToTokens;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Generics, Meta, Path, Token, Visibility, braced, parse_quote, token};

use super::fields;
use super::model::Draft;
use crate::report::Report;
use crate::{text, wording};

/// Traits that the standard library derives.
const DERIVED: [&str; 9] = ["Clone", "Copy", "Debug", "Default", "Eq", "Hash", "Ord", "PartialEq", "PartialOrd"];

/// Reads the tree; `None` if it has no name.
pub fn parse(input: TokenStream, report: &mut Report) -> Option<Draft> {
    let mut draft = None;
    let parser = |input: ParseStream| {
        let draft = draft.insert(head(input, report)?);
        if !input.peek(token::Brace) {
            let at = if input.is_empty() { draft.name.span() } else { input.span() };
            return Err(syn::Error::new(at, wording::TREE_FIELDS));
        }
        let content;
        braced!(content in input);
        input.parse::<Option<Token![;]>>()?;
        if !input.is_empty() {
            report.add(input.parse::<TokenStream>()?, wording::AFTER_TREE);
        }
        fields::parse(&content, draft, report)
    };
    let parsed = parser.parse2(input);
    report.take(parsed);
    draft
}

/// `/// docs` `pub struct Name`
fn head(input: ParseStream, report: &mut Report) -> syn::Result<Draft> {
    let mut attributes = input.call(Attribute::parse_outer)?;
    attributes.retain(|attribute| is_possible(attribute, report));
    let visibility: Visibility = input.parse()?;
    let form = |error: syn::Error| syn::Error::new(error.span(), wording::TREE_FORM);
    if input.peek(Token![enum]) || input.peek2(token::Brace) {
        // The name is there, so uses of the tree are no further mistakes.
        report.push(input.error(wording::TREE_FORM));
        input.parse::<Option<Token![enum]>>()?;
    } else {
        input.parse::<Token![struct]>().map_err(form)?;
    }
    let mut name: Ident = input.parse().map_err(form)?;
    if let Some(word) = input.parse::<Option<Token![as]>>()? {
        name = input.parse()?;
        report.add(word, wording::tree_renamed(&text::name(&name)));
    }
    let generics: Generics = input.parse()?;
    if !generics.params.is_empty() {
        report.add(&generics, wording::TREE_GENERIC);
    }
    let krate = parse_quote!(::bica);
    Ok(Draft {
        attributes,
        visibility,
        name,
        root: None,
        cycle_hz: None,
        budget_ms: None,
        tunable: false,
        components: None,
        roles: Vec::new(),
        krate,
    })
}

/// Whether a tree can have the attribute; if not, reports it.
fn is_possible(attribute: &Attribute, report: &mut Report) -> bool {
    if attribute.path().is_ident("cfg") {
        report.add(attribute, wording::TREE_CONDITION);
        return false;
    }
    let Meta::List(list) = &attribute.meta else { return true };
    if !attribute.path().is_ident("derive") {
        return true;
    }
    let mut possible = true;
    let parsed = list.parse_nested_meta(|meta| {
        if let Some(name) = derived(&meta.path) {
            possible = false;
            report.add(meta.path.to_token_stream(), wording::derived(&name));
        }
        Ok(())
    });
    possible && parsed.is_ok()
}

fn derived(path: &Path) -> Option<String> {
    let name = text::name(&path.segments.last()?.ident);
    DERIVED.contains(&name.as_str()).then_some(name)
}
