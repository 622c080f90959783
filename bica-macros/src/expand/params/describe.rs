//! The description of one parameter, and the checks of its declaration.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};

use crate::expand::quoting::{at, option, placed};
use bica_syntax::params::field::variant;
use bica_syntax::params::model::{Field, Kind, Number, NumberKind, Place};
use bica_syntax::text;

/// `Param { ... }`; `default` is the default value in Rust, if there is one.
pub(crate) fn param(p: &TokenStream, field: &Field, default: Option<&TokenStream>) -> TokenStream {
    let (name, doc, unit) = (text::name(&field.name), &field.doc, option(field.unit.as_ref()));
    let (kind, default) = (kind(p, field), value(p, field, default));
    let hint = hint(p, field.place.as_ref());
    quote! {{
        let kind = #kind;
        #p::Param { name: #name, doc: #p::Doc::new(#doc), unit: #unit, kind, default: #default, hint: #hint }
    }}
}

fn hint(p: &TokenStream, place: Option<&Place>) -> TokenStream {
    let Some(Place { frame, axis }) = place else { return quote!(#p::Hint::NONE) };
    let axis = format_ident!("{axis}");
    quote!(#p::Hint::new(#frame, #p::Axis::#axis))
}

fn kind(p: &TokenStream, field: &Field) -> TokenStream {
    match &field.kind {
        Kind::Number(number) => {
            let Number { of, min, max, step } = &**number;
            let (variant, step) = (variant_of(*of), option(step.as_ref()));
            quote!(#p::Kind::#variant { min: #min, max: #max, step: #step })
        }
        Kind::Bool => quote!(#p::Kind::Bool),
        Kind::Choice => {
            let variants = variants(p, field);
            quote!(#p::Kind::Choice { variants: #variants })
        }
    }
}

/// `<Mode as ParamEnum>::VARIANTS`
fn variants(p: &TokenStream, field: &Field) -> TokenStream {
    let (ty, p) = (&field.ty, placed(p, at(&field.ty)));
    quote_spanned!(at(ty) => <#ty as #p::ParamEnum>::VARIANTS)
}

/// The default as a `Value`.
fn value(p: &TokenStream, field: &Field, default: Option<&TokenStream>) -> TokenStream {
    match (&field.kind, default, &field.default) {
        (Kind::Number(number), Some(default), _) => {
            let variant = variant_of(number.of);
            quote!(#p::Value::#variant(#default))
        }
        (Kind::Bool, Some(default), _) => quote!(#p::Value::Bool(#default)),
        (Kind::Choice, Some(default), Some(written)) => {
            let (name, variants, p) =
                (variant(written).unwrap_or_default(), variants(p, field), placed(p, at(written)));
            // A default that is no expression of the type is one mistake: then this constant has no value.
            quote_spanned!(at(written) => { let _ = &#default; #p::Value::Choice(#p::variant(#variants, #name)) })
        }
        _ => quote!(#p::natural_default(&kind)),
    }
}

/// The constant assertions of a parameter; `described` is the constant that holds its description.
pub(crate) fn assertions(p: &TokenStream, field: &Field, described: &TokenStream) -> TokenStream {
    let each = checks(p, field, described);
    each.into_iter().map(|(place, check)| quote_spanned!(place => const _: () = #check;)).collect()
}

/// The calls that check a declaration, and the place of what each checks.
pub(crate) fn checks(p: &TokenStream, field: &Field, described: &TokenStream) -> Vec<(Span, TokenStream)> {
    let check = |name: &str, place: &dyn ToTokens| {
        let place = at(&place.to_token_stream());
        let (p, name, described) = (placed(p, place), Ident::new(name, place), placed(described, place));
        (place, quote_spanned!(place => #p::#name(&#described)))
    };
    let mut checks = Vec::new();
    if let Kind::Number(number) = &field.kind {
        let Number { min, max, step, .. } = &**number;
        checks.push(check("assert_range", &quote!(#min..=#max)));
        checks.extend(step.as_ref().map(|step| check("assert_step", step)));
    }
    checks.extend(field.default.as_ref().map(|default| check("assert_default", default)));
    checks
}

/// The field as a `Value`.
pub(crate) fn to_value(p: &TokenStream, field: &Field, read: &TokenStream) -> TokenStream {
    match &field.kind {
        Kind::Number(number) => {
            let variant = variant_of(number.of);
            quote!(#p::Value::#variant(#read))
        }
        Kind::Bool => quote!(#p::Value::Bool(#read)),
        Kind::Choice => {
            let ty = &field.ty;
            let p = placed(p, at(ty));
            quote_spanned!(at(ty) => #p::Value::Choice(<#ty as #p::ParamEnum>::index(&#read)))
        }
    }
}

/// A `Value` as an `Option` of the field's type.
pub(crate) fn from_value(p: &TokenStream, field: &Field, value: &TokenStream) -> TokenStream {
    let (variant, is): (Ident, TokenStream) = match &field.kind {
        Kind::Number(number) => (variant_of(number.of), quote!(::core::option::Option::Some(value))),
        Kind::Bool => (format_ident!("Bool"), quote!(::core::option::Option::Some(value))),
        Kind::Choice => {
            let ty = &field.ty;
            let placed = placed(p, at(ty));
            (format_ident!("Choice"), quote_spanned!(at(ty) => <#ty as #placed::ParamEnum>::at(value)))
        }
    };
    quote! {
        match #value {
            #p::Value::#variant(value) => #is,
            _ => ::core::option::Option::None,
        }
    }
}

/// The variant of `Kind` and of `Value`.
fn variant_of(number: NumberKind) -> Ident {
    format_ident!(
        "{}",
        match number {
            NumberKind::F32 => "F32",
            NumberKind::I32 => "I32",
            NumberKind::U32 => "U32",
        }
    )
}
