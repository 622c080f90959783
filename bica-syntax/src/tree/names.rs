//! `left = Leg<0>`: the name that a tree gives to a component.

use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::parse::discouraged::Speculative;
use syn::{Lit, PathArguments, Token, Type};

use crate::types::plain;
use crate::{text, wording};

/// Reads a name and its `=`, if there is one: a type of the list begins with a capital letter or has a path.
pub(super) fn name(input: ParseStream) -> syn::Result<Option<Ident>> {
    let follows = |sign: bool| sign && !input.peek2(Token![::]);
    let (equals, colon) = (follows(input.peek2(Token![=])), follows(input.peek2(Token![:])));
    if input.peek(Lit) && equals {
        return Err(input.error(wording::COMPONENT_NAME));
    }
    if !input.peek(Ident::peek_any) {
        return Ok(None);
    }
    let ahead = input.fork();
    let found = ahead.call(Ident::parse_any)?;
    if text::name(&found).starts_with(char::is_uppercase) {
        return Ok(None);
    }
    if equals {
        let is_keyword = !input.peek(syn::Ident);
        input.advance_to(&ahead);
        input.parse::<Token![=]>()?;
        return if is_keyword { Err(syn::Error::new(found.span(), wording::COMPONENT_NAME)) } else { Ok(Some(found)) };
    }
    if input.peek2(Token![-]) || input.peek2(Token![.]) {
        return Err(input.error(wording::COMPONENT_NAME));
    }
    if colon {
        input.advance_to(&ahead);
        return Err(input.error(wording::NAME_SIGN));
    }
    Ok(None)
}

/// Refuses what was read as a type, but is a name: what follows its `=` is another type with arguments.
pub(super) fn is_type(input: ParseStream, kind: &Type) -> syn::Result<()> {
    let (ahead, Type::Path(path)) = (input.fork(), plain(kind)) else { return Ok(()) };
    let (Some(name), Ok(_), Ok(Type::Path(of))) =
        (path.path.get_ident(), ahead.parse::<Token![=]>(), ahead.parse::<Type>())
    else {
        return Ok(());
    };
    let arguments = of.path.segments.last().map(|last| &last.arguments);
    let has_arguments = matches!(arguments, Some(PathArguments::AngleBracketed(list)) if list.colon2_token.is_none());
    let ends = ahead.is_empty() || ahead.peek(Token![,]) || ahead.peek(Token![=]);
    if has_arguments && ends {
        let small = wording::small_name(&in_small_letters(&text::name(name)), &text::written(&of));
        return Err(syn::Error::new_spanned(kind, small));
    }
    Ok(())
}

/// `LeftLeg` as `left_leg`.
fn in_small_letters(name: &str) -> String {
    let mut small = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !small.is_empty() {
            small.push('_');
        }
        small.extend(letter.to_lowercase());
    }
    small
}
