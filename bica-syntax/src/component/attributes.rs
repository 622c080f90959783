//! `#[state]`, `#[transition]`, `#[entry]`, `#[exit]`, `#[before]`, `#[start]`, `#[stop]`, `#[modulation]`

use proc_macro2::{Ident, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Attribute, Meta, Token};

use super::guard;
use super::model::{Arrow, End, Sources};
use super::roles::ROLES;
use crate::code::Code;
use crate::report::{Mistake, coded};
use crate::{text, wording};

/// Names from other frameworks for our attributes.
const SYNONYMS: [(&str, &str); 20] = [
    ("enter", "entry"),
    ("on_entry", "entry"),
    ("on_enter", "entry"),
    ("on_exit", "exit"),
    ("on_start", "start"),
    ("on_stop", "stop"),
    ("guard", "transition"),
    ("info", "output"),
    ("information", "output"),
    ("modulate", "modulation"),
    ("action", "modulation"),
    ("initial", "state(initial)"),
    ("last", "state(last)"),
    ("done", "state(done)"),
    ("success", "state(done)"),
    ("failed", "state(failed)"),
    ("failure", "state(failed)"),
    ("job", "work"),
    ("task", "work"),
    ("background", "work"),
];

/// The words of a state, and how a message lists them.
const STATE_WORDS: [&str; 4] = ["initial", "last", "done", "failed"];
const KNOWN_STATE_WORDS: &str = "`initial`, `last`, `done` and `failed`";

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

/// The words of `#[state]`.
#[derive(Default)]
pub struct StateWords {
    /// The word `initial`.
    pub initial: Option<Ident>,
    /// Whether no transition leaves the state: `last`, `done` or `failed`.
    pub last: bool,
    /// The result with which the machine ends there.
    pub end: Option<End>,
}

/// The words of `#[state(initial, last)]`.
///
/// # Errors
/// If it has other words, one twice, or several ends.
pub fn state(attribute: &Attribute) -> Result<StateWords, Mistake> {
    let mut words = StateWords::default();
    let list = match &attribute.meta {
        Meta::Path(_) => return Ok(words),
        Meta::List(list) => list,
        Meta::NameValue(pair) => return Err(syn::Error::new_spanned(&pair.value, wording::STATE_WORDS).into()),
    };
    let written = list.parse_args_with(Punctuated::<Ident, Token![,]>::parse_terminated);
    let mut seen: Vec<Ident> = Vec::new();
    for word in written.map_err(|found| syn::Error::new(found.span(), wording::STATE_WORDS))? {
        if seen.contains(&word) {
            return Err(syn::Error::new(word.span(), wording::TWICE).into());
        }
        let end = match word.to_string().as_str() {
            "initial" => {
                words.initial = Some(word.clone());
                seen.push(word);
                continue;
            }
            "last" => None,
            "done" => Some(End::Done),
            "failed" => Some(End::Failed),
            other => {
                let nearest = End::meant(other).or_else(|| text::nearest(other, STATE_WORDS.into_iter()));
                return Err(Mistake::new(&word, Code::unknown_key(other, nearest, KNOWN_STATE_WORDS)));
            }
        };
        if words.last {
            return Err(syn::Error::new(word.span(), wording::TWO_ENDS).into());
        }
        (words.last, words.end) = (true, end);
        seen.push(word);
    }
    Ok(words)
}

/// Words that mean a stop elsewhere.
const STOPS: [&str; 5] = ["halt", "emergency", "emergency_stop", "estop", "e_stop"];

/// The words of a modulation.
const MODULATION_WORDS: [&str; 2] = ["stop", "drives"];

/// The word of `#[modulation(stop)]` or `#[modulation(drives)]`.
///
/// # Errors
/// If it has another form, another word, or two.
pub(super) fn modulation(attribute: &Attribute) -> Result<Option<&'static str>, Mistake> {
    let list = match &attribute.meta {
        Meta::Path(_) => return Ok(None),
        Meta::List(list) if !list.tokens.is_empty() => list,
        _ => return Err(syn::Error::new_spanned(attribute, wording::MODULATION_FORM).into()),
    };
    let words = list.parse_args_with(Punctuated::<Ident, Token![,]>::parse_terminated);
    let mut seen = None;
    for word in words.map_err(|_| syn::Error::new_spanned(&list.tokens, wording::MODULATION_FORM))? {
        let written = text::name(&word);
        let Some(known) = MODULATION_WORDS.into_iter().find(|known| *known == written) else {
            let nearest = if STOPS.contains(&written.as_str()) {
                Some("stop")
            } else {
                text::nearest(&written, MODULATION_WORDS.into_iter())
            };
            return Err(Mistake::new(word, Code::unknown_key(written, nearest, "`stop` and `drives`")));
        };
        if let Some(before) = seen.replace(known) {
            let message = if before == known { wording::TWICE } else { wording::STOP_OR_DRIVES };
            return Err(syn::Error::new(word.span(), message).into());
        }
    }
    Ok(seen)
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
            Ok(Arrow { from, to, guard: guard::parse(input).map_err(uncoded)? })
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
