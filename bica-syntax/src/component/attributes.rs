//! `#[state]`, `#[transition]`, `#[entry]`, `#[exit]`, `#[before]`, `#[start]`, `#[stop]`, `#[modulation]`

use proc_macro2::{Ident, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Attribute, Expr, Meta, Token};

use super::model::{Arrow, Sources};
use super::roles::ROLES;
use crate::code::Code;
use crate::report::{Mistake, coded};
use crate::{number, text, wording};

/// Names from other frameworks for our attributes.
const SYNONYMS: [(&str, &str); 15] = [
    ("enter", "entry"),
    ("on_entry", "entry"),
    ("on_enter", "entry"),
    ("on_exit", "exit"),
    ("on_start", "start"),
    ("on_stop", "stop"),
    ("guard", "transition"),
    ("information", "info"),
    ("modulate", "modulation"),
    ("action", "modulation"),
    ("initial", "state(initial)"),
    ("last", "state(last)"),
    ("job", "work"),
    ("task", "work"),
    ("background", "work"),
];

/// Attributes of the language that are spelt much like one of ours.
const BUILT_IN: [&str; 6] = ["test", "expect", "ignore", "inline", "cold", "must_use"];

/// The mistake of an attribute that was meant to be one of ours.
pub(crate) fn misspelt(attribute: &Attribute) -> Option<Mistake> {
    let path = attribute.path();
    let last = text::name(&path.segments.last()?.ident);
    if path.segments.len() == 2 && path.segments[0].ident == "bica" && ROLES.contains(&last.as_str()) {
        return Some(syn::Error::new_spanned(path, wording::bare_attribute(&last)).into());
    }
    path.get_ident()?;
    if last == "step" {
        return Some(syn::Error::new_spanned(path, wording::STEP_ATTRIBUTE).into());
    }
    let synonym = SYNONYMS.iter().find(|(other, _)| *other == last).map(|(_, ours)| *ours);
    let near = || (!BUILT_IN.contains(&last.as_str())).then(|| text::nearest(&last, ROLES.into_iter())).flatten();
    let meant = synonym.or_else(near).filter(|ours| *ours != last)?.to_owned();
    Some(Mistake::new(path, Code::MisspeltAttribute { found: last, meant }))
}

/// Whether it is `#[component]`, by any path.
#[must_use]
pub fn is_component(attribute: &Attribute) -> bool {
    attribute.path().segments.last().is_some_and(|last| last.ident == "component")
}

/// Whether a `cfg_attr` may add one of our attributes.
pub(crate) fn conditional_role(attribute: &Attribute) -> bool {
    adds(attribute, &ROLES)
}

/// Whether the item may be left out of a build.
pub(crate) fn is_condition(attribute: &Attribute) -> bool {
    attribute.path().is_ident("cfg") || adds(attribute, &["cfg"])
}

/// Whether a `cfg_attr` may add an attribute of one of these names.
fn adds(attribute: &Attribute, names: &[&str]) -> bool {
    let is_named = |token| matches!(token, TokenTree::Ident(word) if names.iter().any(|name| word == name));
    match &attribute.meta {
        Meta::List(list) => list.path.is_ident("cfg_attr") && list.tokens.clone().into_iter().any(is_named),
        _ => false,
    }
}

/// `#[start]`, `#[stop]`: they take nothing.
pub(crate) fn bare(attribute: &Attribute, role: &str) -> syn::Result<()> {
    match &attribute.meta {
        Meta::Path(_) => Ok(()),
        Meta::List(list) => Err(error(&list.tokens, attribute, wording::no_arguments(role))),
        Meta::NameValue(pair) => Err(syn::Error::new_spanned(&pair.value, wording::no_arguments(role))),
    }
}

/// The words of `#[state(initial, last)]`.
///
/// # Errors
/// If it has other words, or one twice.
pub fn state(attribute: &Attribute) -> Result<(Option<Ident>, bool), Mistake> {
    let (mut initial, mut last) = (None, false);
    let list = match &attribute.meta {
        Meta::Path(_) => return Ok((initial, last)),
        Meta::List(list) => list,
        Meta::NameValue(pair) => return Err(syn::Error::new_spanned(&pair.value, wording::STATE_WORDS).into()),
    };
    let words = list.parse_args_with(Punctuated::<Ident, Token![,]>::parse_terminated);
    for word in words.map_err(|found| syn::Error::new(found.span(), wording::STATE_WORDS))? {
        match word.to_string().as_str() {
            "initial" if initial.is_none() => initial = Some(word),
            "last" if !last => last = true,
            "initial" | "last" => return Err(syn::Error::new(word.span(), wording::TWICE).into()),
            other => {
                let nearest = text::nearest(other, ["initial", "last"].into_iter());
                return Err(Mistake::new(&word, Code::unknown_key(other, nearest, "`initial` and `last`")));
            }
        }
    }
    Ok((initial, last))
}

/// Words that mean a stop elsewhere.
const STOPS: [&str; 5] = ["halt", "emergency", "emergency_stop", "estop", "e_stop"];

/// Whether `#[modulation]` is marked as a stop: `#[modulation(stop)]`.
///
/// # Errors
/// If it has another form, another word, or the word twice.
pub(super) fn modulation(attribute: &Attribute) -> Result<bool, Mistake> {
    let list = match &attribute.meta {
        Meta::Path(_) => return Ok(false),
        Meta::List(list) if !list.tokens.is_empty() => list,
        _ => return Err(syn::Error::new_spanned(attribute, wording::MODULATION_FORM).into()),
    };
    let words = list.parse_args_with(Punctuated::<Ident, Token![,]>::parse_terminated);
    let mut stops = false;
    for word in words.map_err(|_| syn::Error::new_spanned(&list.tokens, wording::MODULATION_FORM))? {
        let written = text::name(&word);
        if written != "stop" {
            let nearest = if STOPS.contains(&written.as_str()) {
                Some("stop")
            } else {
                text::nearest(&written, ["stop"].into_iter())
            };
            return Err(Mistake::new(word, Code::unknown_key(written, nearest, "only `stop`")));
        }
        if stops {
            return Err(syn::Error::new(word.span(), wording::TWICE).into());
        }
        stops = true;
    }
    Ok(stops)
}

/// Reads a transition.
///
/// # Errors
/// If it has another form.
pub fn transition(attribute: &Attribute) -> Result<Arrow, Mistake> {
    let Meta::List(list) = &attribute.meta else {
        return Err(syn::Error::new_spanned(attribute, wording::ARROW).into());
    };
    if list.tokens.is_empty() {
        return Err(syn::Error::new_spanned(attribute, wording::ARROW).into());
    }
    coded(|uncoded| {
        list.parse_args_with(|input: ParseStream| {
            let from = sources(input)?;
            input.parse::<Token![->]>().map_err(|found| syn::Error::new(found.span(), wording::ARROW))?;
            let to = Ident::parse_any(input).map_err(|found| syn::Error::new(found.span(), wording::ARROW))?;
            if input.peek(Token![|]) {
                return Err(input.error(wording::ONE_TARGET));
            }
            Ok(Arrow { from, to, after_ms: after_ms(input).map_err(uncoded)? })
        })
    })
}

fn sources(input: ParseStream) -> syn::Result<Sources> {
    if input.peek(Token![*]) {
        input.parse::<Token![*]>()?;
        return Ok(Sources::Any);
    }
    names(input).map(Sources::These).map_err(|found| syn::Error::new(found.span(), wording::ARROW))
}

/// `a | b`
fn names(input: ParseStream) -> syn::Result<Vec<Ident>> {
    Ok(Punctuated::<Ident, Token![|]>::parse_separated_nonempty_with(input, Ident::parse_any)?.into_iter().collect())
}

/// `, after_ms = N`
fn after_ms(input: ParseStream) -> Result<Option<u32>, Mistake> {
    let mut after_ms = None;
    while !input.is_empty() {
        if !input.peek(Token![,]) {
            return Err(input.error(wording::ARROW).into());
        }
        input.parse::<Token![,]>()?;
        if input.is_empty() {
            break;
        }
        let key: Ident = Ident::parse_any(input).map_err(|found| syn::Error::new(found.span(), wording::TIMER))?;
        let written = key.to_string();
        if written != "after_ms" {
            let nearest = ["after", "timeout", "timeout_ms", "after_s"].contains(&written.as_str());
            let nearest = if nearest { Some("after_ms") } else { text::nearest(&written, ["after_ms"].into_iter()) };
            return Err(Mistake::new(key, Code::unknown_key(written, nearest, "`after_ms`")));
        }
        if after_ms.is_some() {
            return Err(syn::Error::new(key.span(), wording::TWICE).into());
        }
        after_ms = Some(milliseconds(input)?);
    }
    Ok(after_ms)
}

/// `= N`
fn milliseconds(input: ParseStream) -> syn::Result<u32> {
    let missing = |found: syn::Error| syn::Error::new(found.span(), wording::not_whole("after_ms"));
    input.parse::<Token![=]>().map_err(missing)?;
    let value: Expr = input.parse().map_err(missing)?;
    number::milliseconds(&value, "after_ms").map_err(|problem| syn::Error::new_spanned(&value, problem))
}

/// The states of `#[entry(a | b)]`.
///
/// # Errors
/// If it names none.
pub fn hook(attribute: &Attribute, role: &str) -> syn::Result<Vec<Ident>> {
    let form = wording::hook_states(role);
    match &attribute.meta {
        Meta::List(list) if !list.tokens.is_empty() => {
            list.parse_args_with(names).map_err(|found| syn::Error::new(found.span(), form))
        }
        _ => Err(syn::Error::new_spanned(attribute, form)),
    }
}

/// An error at some tokens, or at the attribute if there are none.
fn error(tokens: &TokenStream, attribute: &Attribute, message: String) -> syn::Error {
    if tokens.is_empty() {
        syn::Error::new_spanned(attribute, message)
    } else {
        syn::Error::new_spanned(tokens, message)
    }
}
