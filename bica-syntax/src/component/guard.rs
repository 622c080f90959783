//! What a transition waits for beside its condition: `after_ms = 500`, `after = Approach::patience`, `when = done(Reach)`, `times = 3`.

use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Expr, ExprPath, PathArguments, Token, Type, TypePath, parenthesized};

use super::model::{End, Guard, Parameter, Timer, TypeText, When};
use crate::code::Code;
use crate::report::Mistake;
use crate::{number, text, wording};

/// The keys that can follow the arrow.
const KEYS: [&str; 4] = ["after_ms", "after", "when", "times"];

/// Names that a user may try, and the key that was meant.
const SYNONYMS: [(&str, &str); 10] = [
    ("timeout", "after_ms"),
    ("timeout_ms", "after_ms"),
    ("after_s", "after_ms"),
    ("if", "when"),
    ("on", "when"),
    ("result", "when"),
    ("retries", "times"),
    ("attempts", "times"),
    ("max", "times"),
    ("count", "times"),
];

/// Largest number of `times`: it shares 16 bits with the index of the state.
const MOST_TIMES: u8 = 126;

/// Reads what follows the arrow, from its text: `, after_ms = 500`.
///
/// # Errors
/// If it has another form.
pub fn read(text: &str) -> syn::Result<Guard> {
    let parser = |input: ParseStream| parse(input).map_err(|mistake| mistake.error);
    parser.parse_str(text)
}

/// Reads what follows the arrow.
pub(super) fn parse(input: ParseStream) -> Result<Guard, Mistake> {
    let (mut guard, mut seen): (Guard, Vec<Ident>) = (Guard::default(), Vec::new());
    while !input.is_empty() {
        if !input.peek(Token![,]) {
            return Err(input.error(wording::ARROW).into());
        }
        input.parse::<Token![,]>()?;
        if input.is_empty() {
            break;
        }
        let key: Ident = Ident::parse_any(input).map_err(|found| syn::Error::new(found.span(), wording::TIMER))?;
        if seen.contains(&key) {
            let problem = if key == "when" { wording::ONE_RESULT } else { wording::TWICE };
            return Err(syn::Error::new(key.span(), problem).into());
        }
        one(input, &key, &mut guard)?;
        seen.push(key);
    }
    let times = seen.iter().find(|key| *key == "times").filter(|_| guard.when.is_none());
    times.map_or(Ok(guard), |key| Err(syn::Error::new(key.span(), wording::TIMES_WITHOUT_WHEN).into()))
}

fn one(input: ParseStream, key: &Ident, guard: &mut Guard) -> Result<(), Mistake> {
    let written = key.to_string();
    match written.as_str() {
        "after_ms" | "after" if guard.timer.is_some() => {
            return Err(syn::Error::new(key.span(), wording::TWO_TIMERS).into());
        }
        "after_ms" => guard.timer = Some(Timer::Ms(milliseconds(input)?)),
        "after" => guard.timer = Some(Timer::Parameter(Box::new(parameter(input, key)?))),
        "when" => guard.when = Some(when(input, key)?),
        "times" => guard.times = Some(times(input, key)?),
        _ => {
            let synonym = SYNONYMS.iter().find(|(other, _)| *other == written).map(|(_, ours)| *ours);
            let nearest = synonym.or_else(|| text::nearest(&written, KEYS.into_iter()));
            return Err(Mistake::new(
                key,
                Code::unknown_key(written, nearest, "`after_ms`, `after`, `when` and `times`"),
            ));
        }
    }
    Ok(())
}

/// `= N`
fn milliseconds(input: ParseStream) -> syn::Result<u32> {
    let value = value(input, &wording::not_whole("after_ms"))?;
    number::milliseconds(&value, "after_ms").map_err(|problem| syn::Error::new_spanned(&value, problem))
}

/// `= Approach::patience`
fn parameter(input: ParseStream, key: &Ident) -> syn::Result<Parameter> {
    let value = value(input, wording::AFTER_FORM).map_err(|found| at_key(found, input, key))?;
    let form = || syn::Error::new_spanned(&value, wording::AFTER_FORM);
    let Expr::Path(ExprPath { attrs, qself: None, path }) = &value else { return Err(form()) };
    let mut path = path.clone();
    let field = path.segments.pop().filter(|_| attrs.is_empty() && !path.segments.is_empty()).ok_or_else(form)?;
    path.segments.pop_punct();
    if !matches!(field.arguments, PathArguments::None) {
        return Err(form());
    }
    Ok(Parameter { of: TypeText(Type::Path(TypePath { attrs: Vec::new(), qself: None, path })), field: field.ident })
}

/// `= done(Reach)`
fn when(input: ParseStream, key: &Ident) -> Result<When, Mistake> {
    let form = |found: syn::Error| at_key(syn::Error::new(found.span(), wording::WHEN_FORM), input, key);
    input.parse::<Token![=]>().map_err(form)?;
    let end: Ident = Ident::parse_any(input).map_err(form)?;
    let read = match end.to_string().as_str() {
        "done" => End::Done,
        "failed" => End::Failed,
        other => {
            if !input.peek(syn::token::Paren) {
                return Err(syn::Error::new(end.span(), wording::WHEN_FORM).into());
            }
            let nearest = End::meant(other).or_else(|| text::nearest(other, ["done", "failed"].into_iter()));
            return Err(Mistake::new(&end, Code::unknown_key(other, nearest, "`done` and `failed`")));
        }
    };
    let child = child(input, form)?;
    match &child {
        Type::Path(_) => Ok(When { end: read, child: TypeText(child) }),
        _ => Err(syn::Error::new_spanned(child, wording::WHEN_FORM).into()),
    }
}

/// `(Reach)`, and nothing that would join another result
fn child(input: ParseStream, form: impl Fn(syn::Error) -> syn::Error) -> syn::Result<Type> {
    let parser = |input: ParseStream| {
        let content;
        parenthesized!(content in input);
        let child = content.parse()?;
        Ok((child, (!content.is_empty()).then(|| content.error(wording::ONE_RESULT))))
    };
    let (child, second) = parser(input).map_err(form)?;
    match second {
        Some(second) => Err(second),
        None if input.peek(Token![|]) || input.peek(Token![&]) => Err(input.error(wording::ONE_RESULT)),
        None => Ok(child),
    }
}

/// `= 3`
fn times(input: ParseStream, key: &Ident) -> syn::Result<u8> {
    let form = wording::times_form(MOST_TIMES);
    let value = value(input, &form).map_err(|found| at_key(found, input, key))?;
    let number = number::whole(&value).and_then(|number| u8::try_from(number).ok());
    number
        .filter(|number| (1..=MOST_TIMES).contains(number))
        .ok_or_else(|| syn::Error::new_spanned(&value, wording::times_form(MOST_TIMES)))
}

fn value(input: ParseStream, form: &str) -> syn::Result<Expr> {
    let missing = |found: syn::Error| syn::Error::new(found.span(), form);
    input.parse::<Token![=]>().map_err(missing)?;
    input.parse().map_err(missing)
}

/// The error, at the key if nothing is left to point at.
fn at_key(found: syn::Error, input: ParseStream, key: &Ident) -> syn::Error {
    if input.is_empty() { syn::Error::new(key.span(), found) } else { found }
}
