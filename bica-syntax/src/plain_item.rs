//! Attributes of a struct or an enum that is no impl block: `#[data]` and `#[derive(ComponentDoc)]`.

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Attribute, Data, DeriveInput, Expr, ExprLit, Field, Lit, Path, Token, Type, parse_quote};

use crate::report::Report;
use crate::types::plain;
use crate::{text, wording};

/// Largest number of elements for which arrays implement serde's traits.
const MAX_ARRAY: usize = 32;

/// The crate that `#[attribute(crate = path)]` names, with mistakes reported.
pub fn framework(options: TokenStream, item: &TokenStream, report: &mut Report) -> Path {
    let is_possible = |input: DeriveInput| !matches!(input.data, Data::Union(_));
    if !syn::parse2(item.clone()).is_ok_and(is_possible) {
        report.add(item, wording::plain_item("data"));
    }
    krate("data", options, report)
}

/// The mistake of `#[output]` or `#[message]` before an item.
#[must_use]
pub fn earlier(attribute: &str, item: &TokenStream) -> syn::Error {
    let is_type = syn::parse2::<DeriveInput>(item.clone()).is_ok();
    if attribute == "output" && !is_type {
        return syn::Error::new(Span::call_site(), wording::STRAY_OUTPUT);
    }
    syn::Error::new(Span::call_site(), wording::earlier_data(attribute))
}

/// Reads the options `crate = path`.
pub(crate) fn krate(attribute: &str, options: TokenStream, report: &mut Report) -> Path {
    let parser = |input: syn::parse::ParseStream| {
        if input.is_empty() {
            return Ok(parse_quote!(::bica));
        }
        let form = |found: syn::Error| syn::Error::new(found.span(), wording::plain_options(attribute));
        input.parse::<Token![crate]>().map_err(form)?;
        input.parse::<Token![=]>().map_err(form)?;
        input.call(Path::parse_mod_style).map_err(form)
    };
    let krate = syn::parse::Parser::parse2(parser, options);
    report.take(krate).unwrap_or_else(|| parse_quote!(::bica))
}

/// The item with `#[data]`, in which serde's attribute `borrow` precedes each field that borrows, and `with` each array that may
/// have more than `MAX_ARRAY` elements. `krate` is the framework.
#[must_use]
pub fn data(item: &TokenStream, krate: &Path) -> TokenStream {
    let Ok(mut input) = syn::parse2::<DeriveInput>(item.clone()) else { return item.clone() };
    let mark = |field: &mut Field| {
        if borrows(field.ty.to_token_stream()) {
            field.attrs.push(parse_quote!(#[serde(borrow)]));
        }
        if may_be_long(&field.ty) {
            let with = format!("{}::__private::long_array", krate.to_token_stream()).replace(' ', "");
            field.attrs.push(parse_quote!(#[serde(with = #with)]));
        }
    };
    match &mut input.data {
        Data::Struct(data) => data.fields.iter_mut().for_each(mark),
        Data::Enum(data) => data.variants.iter_mut().flat_map(|variant| &mut variant.fields).for_each(mark),
        Data::Union(_) => {}
    }
    input.into_token_stream()
}

/// A type of fields, without their arrays, that has to travel itself.
pub struct Part<'a> {
    /// The type.
    pub ty: &'a Type,
    /// Whether a field is an array of it that may have more than `MAX_ARRAY` elements.
    pub in_long_array: bool,
}

/// The types of fields that have to travel themselves, each once. A field that borrows and one with serde's attributes have their own
/// rules; a type with parameters has serde's bounds.
#[must_use]
pub fn parts(input: &DeriveInput) -> Vec<Part<'_>> {
    let is_serde = |attributes: &[Attribute]| attributes.iter().any(|one| one.path().is_ident("serde"));
    if input.generics.type_params().next().is_some() || is_serde(&input.attrs) {
        return Vec::new();
    }
    let fields: Vec<&Field> = match &input.data {
        Data::Struct(data) => data.fields.iter().collect(),
        Data::Enum(data) => data.variants.iter().flat_map(|variant| &variant.fields).collect(),
        Data::Union(_) => Vec::new(),
    };
    let mut parts: Vec<Part> = Vec::new();
    for field in fields.into_iter().filter(|field| !is_serde(&field.attrs)) {
        let (ty, in_long_array) = (element(&field.ty), may_be_long(&field.ty));
        let written = text::written(ty);
        match parts.iter_mut().find(|known| text::written(known.ty) == written) {
            Some(known) => known.in_long_array |= in_long_array,
            // `$crate` of a `macro_rules` macro cannot be read back from a text.
            None if !written.contains(['&', '\'', '$']) => parts.push(Part { ty, in_long_array }),
            None => {}
        }
    }
    parts
}

/// The type of the elements of arrays in arrays.
fn element(ty: &Type) -> &Type {
    if let Type::Array(array) = plain(ty) { element(&array.elem) } else { plain(ty) }
}

/// Whether a type is an array whose length is no literal up to [`MAX_ARRAY`].
fn may_be_long(ty: &Type) -> bool {
    let Type::Array(array) = ty else { return false };
    let Expr::Lit(ExprLit { lit: Lit::Int(length), .. }) = &array.len else { return true };
    length.base10_parse::<usize>().is_ok_and(|length| length > MAX_ARRAY)
}

/// Whether a type names a lifetime other than `'static`.
fn borrows(ty: TokenStream) -> bool {
    let mut is_lifetime = false;
    ty.into_iter().any(|token| match token {
        TokenTree::Group(group) => borrows(group.stream()),
        TokenTree::Ident(name) => std::mem::take(&mut is_lifetime) && name != "static",
        TokenTree::Punct(punct) => {
            is_lifetime = punct.as_char() == '\'';
            false
        }
        TokenTree::Literal(_) => false,
    })
}

/// The item with `#[derive(ComponentDoc)]`, and its doc comment.
pub fn component_doc(item: TokenStream, report: &mut Report) -> Option<(DeriveInput, String)> {
    let input: DeriveInput = report.take(syn::parse2(item))?;
    let doc = text::doc(&input.attrs);
    if doc.is_empty() {
        report.add(input.ident.to_token_stream(), wording::component_doc(&text::name(&input.ident)));
    }
    Some((input, doc))
}
