//! `#[output(unit = "m", frame = "field", child = "robot")]`

use proc_macro2::Ident;
use syn::parse::ParseStream;
use syn::{Attribute, Expr, ExprLit, Lit, Meta, Token};

use super::model::Placement;
use crate::code::Code;
use crate::params::field;
use crate::report::{Mistake, coded};
use crate::{text, wording};

const KEYS: [&str; 3] = ["unit", "frame", "child"];

/// The unit and the frames of an output.
///
/// # Errors
/// If the attribute has another form.
pub fn parse(attribute: &Attribute) -> Result<(Option<String>, Option<Placement>), Mistake> {
    let list = match &attribute.meta {
        Meta::Path(_) => return Ok((None, None)),
        Meta::List(list) => list,
        Meta::NameValue(pair) => return Err(syn::Error::new_spanned(&pair.value, wording::OUTPUT_FORM).into()),
    };
    let [unit, frame, child] =
        coded(|uncoded| list.parse_args_with(|input: ParseStream| options(input).map_err(uncoded)))?;
    match (frame, child) {
        (None, Some(_)) => Err(syn::Error::new_spanned(attribute, wording::CHILD_WITHOUT_FRAME).into()),
        (Some(frame), Some(child)) if frame == child => {
            Err(syn::Error::new_spanned(attribute, wording::frame_in_itself(&frame)).into())
        }
        (frame, child) => Ok((unit, frame.map(|frame| Placement { frame, child }))),
    }
}

/// The values of [`KEYS`].
fn options(input: ParseStream) -> Result<[Option<String>; KEYS.len()], Mistake> {
    let form = |found: syn::Error| syn::Error::new(found.span(), wording::OUTPUT_FORM);
    let mut values = [const { None }; KEYS.len()];
    loop {
        let key: Ident = input.parse().map_err(form)?;
        let written = key.to_string();
        let Some(place) = KEYS.iter().position(|known| *known == written) else {
            let nearest = text::nearest(&written, KEYS.into_iter());
            return Err(Mistake::new(key, Code::unknown_key(written, nearest, "`unit`, `frame` and `child`")));
        };
        input.parse::<Token![=]>().map_err(form)?;
        let value: Expr = input.parse().map_err(form)?;
        let value = if place == 0 { field::unit(&value)? } else { frame(&written, &value)? };
        if values[place].replace(value).is_some() {
            return Err(syn::Error::new(key.span(), wording::TWICE).into());
        }
        if input.parse::<Option<Token![,]>>().map_err(form)?.is_none() || input.is_empty() {
            return if input.is_empty() { Ok(values) } else { Err(form(input.error("")).into()) };
        }
    }
}

/// The name of a frame.
fn frame(key: &str, value: &Expr) -> syn::Result<String> {
    match value {
        Expr::Lit(ExprLit { lit: Lit::Str(name), .. }) if !name.value().trim().is_empty() => Ok(name.value()),
        _ => Err(syn::Error::new_spanned(value, wording::frame_form(key))),
    }
}
