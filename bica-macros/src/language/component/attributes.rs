//! `#[state]`, `#[transition]`, `#[entry]`, `#[exit]`, `#[start]`, `#[stop]`

use proc_macro2::Ident;
use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Attribute, LitInt, Meta, Token};

use super::model::From;
use crate::language::{text, wording};

/// The attributes that make a function the tree's.
pub(crate) const ROLES: [&str; 6] = ["state", "transition", "entry", "exit", "start", "stop"];

/// The role that an attribute gives, if it is one of ours.
pub(crate) fn role(attribute: &Attribute) -> Option<&'static str> {
    ROLES.into_iter().find(|role| attribute.path().is_ident(role))
}

/// The words of `#[state(initial, last)]`.
pub(crate) fn state(attribute: &Attribute) -> syn::Result<(Option<Ident>, bool)> {
    let (mut initial, mut last) = (None, false);
    if matches!(attribute.meta, Meta::Path(_)) {
        return Ok((initial, last));
    }
    for word in attribute.parse_args_with(Punctuated::<Ident, Token![,]>::parse_terminated)? {
        match word.to_string().as_str() {
            "initial" => initial = Some(word),
            "last" => last = true,
            other => {
                let nearest = text::nearest(other, ["initial", "last"].into_iter());
                return Err(syn::Error::new(word.span(), wording::unknown_key(other, nearest, "`initial` and `last`")));
            }
        }
    }
    Ok((initial, last))
}

/// What `#[transition(a | b -> c, after_ms = N)]` says.
pub(crate) struct Arrow {
    pub(crate) from: From,
    pub(crate) to: Ident,
    pub(crate) after_ms: Option<u32>,
}

/// Reads a transition.
pub(crate) fn transition(attribute: &Attribute) -> syn::Result<Arrow> {
    if !matches!(attribute.meta, Meta::List(_)) {
        return Err(syn::Error::new_spanned(attribute, wording::ARROW));
    }
    attribute.parse_args_with(|input: ParseStream| {
        let from = from(input)?;
        if !input.peek(Token![->]) {
            return Err(input.error(wording::ARROW));
        }
        input.parse::<Token![->]>()?;
        let to = input.parse().map_err(|error| syn::Error::new(error.span(), wording::ARROW))?;
        Ok(Arrow { from, to, after_ms: after_ms(input)? })
    })
}

fn from(input: ParseStream) -> syn::Result<From> {
    if input.peek(Token![*]) {
        input.parse::<Token![*]>()?;
        return Ok(From::Any);
    }
    names(input).map(From::These).map_err(|error| syn::Error::new(error.span(), wording::ARROW))
}

/// `a | b`
fn names(input: ParseStream) -> syn::Result<Vec<Ident>> {
    Ok(Punctuated::<Ident, Token![|]>::parse_separated_nonempty(input)?.into_iter().collect())
}

fn after_ms(input: ParseStream) -> syn::Result<Option<u32>> {
    if input.is_empty() {
        return Ok(None);
    }
    input.parse::<Token![,]>()?;
    if input.is_empty() {
        return Ok(None);
    }
    let key: Ident = input.parse()?;
    if key != "after_ms" {
        let key_text = key.to_string();
        let nearest = text::nearest(&key_text, ["after_ms"].into_iter());
        return Err(syn::Error::new(key.span(), wording::unknown_key(&key_text, nearest, "`after_ms`")));
    }
    input.parse::<Token![=]>()?;
    let number = input.parse::<LitInt>().map_err(|error| syn::Error::new(error.span(), wording::MS))?;
    input.parse::<Option<Token![,]>>()?;
    number.base10_parse().map(Some).map_err(|_| syn::Error::new(number.span(), wording::MS))
}

/// The states of `#[entry(a | b)]`.
pub(crate) fn hook(attribute: &Attribute) -> syn::Result<Vec<Ident>> {
    attribute.parse_args_with(names)
}
