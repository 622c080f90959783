//! From the tokens of a struct or an enum to a model of it.

use proc_macro2::TokenStream;
use syn::{Attribute, Data, DeriveInput, Expr, Fields, Member, Path, Token, Type, parse_quote};

use super::field;
use super::model::{Choice, Field, Params};
use crate::code::Code;
use crate::report::{Mistake, Report, coded};
use crate::{text, wording};

/// Reads a struct with `#[derive(Params)]`. With mistakes the model has the fields that could be read.
pub fn params(item: TokenStream, report: &mut Report) -> Option<Params> {
    let input: DeriveInput = report.take(syn::parse2(item))?;
    let (krate, checks) = options(&input.attrs, report);
    let doc = text::doc(&input.attrs);
    let generic = !input.generics.params.is_empty();
    let is_struct = matches!(input.data, Data::Struct(_));
    let (fields, written) = (Vec::new(), Vec::new());
    let mut params = Params { name: input.ident, doc, fields, written, is_struct, generic, checks, krate };
    let Data::Struct(data) = &input.data else {
        report.add(&params.name, wording::PARAMS_STRUCT);
        return Some(params);
    };
    if generic {
        report.add(&input.generics, wording::PARAMS_GENERIC);
    }
    params.written = data.fields.iter().zip(data.fields.members()).map(written_field).collect();
    if params.doc.is_empty() {
        report.add(&params.name, wording::params_doc(&params.name.to_string()));
    }
    match &data.fields {
        Fields::Named(fields) if !fields.named.is_empty() => {
            params.fields = fields.named.iter().filter_map(|field| one(field, report)).collect();
        }
        _ => report.add(&params.name, wording::PARAMS_STRUCT),
    }
    Some(params)
}

/// Name, type and default of a field, whatever else is wrong with it.
fn written_field((field, member): (&syn::Field, Member)) -> (Member, Type, Option<Expr>) {
    let attribute = field.attrs.iter().find(|attribute| attribute.path().is_ident("param"));
    let default = attribute.and_then(|one| field::keys(one, &mut Report::default())).and_then(|keys| keys.default);
    (member, field.ty.clone(), default)
}

fn one(field: &syn::Field, report: &mut Report) -> Option<Field> {
    let name = field.ident.as_ref()?;
    let written = text::name(name);
    let doc = text::doc(&field.attrs);
    if doc.is_empty() {
        report.add(name, wording::param_doc(&written));
    }
    let mut attributes = field.attrs.iter().filter(|attribute| attribute.path().is_ident("param"));
    let Some(attribute) = attributes.next() else {
        report.add(name, wording::no_param(&written, &text::written(&field.ty)));
        return None;
    };
    if let Some(second) = attributes.next() {
        report.add(second, wording::TWICE);
    }
    let keys = field::keys(attribute, report)?;
    if keys.default.is_none() {
        report.add(name, wording::no_default(&written));
        return None;
    }
    field::field(name, doc, &field.ty, keys, report)
}

/// `#[params(check = path, crate = path)]`
fn options(attributes: &[Attribute], report: &mut Report) -> (Path, Vec<Path>) {
    let (mut krate, mut checks) = (parse_quote!(::bica), Vec::new());
    for attribute in attributes.iter().filter(|attribute| attribute.path().is_ident("params")) {
        let parsed = coded(|uncoded| {
            attribute.parse_nested_meta(|meta| {
                if meta.path.is_ident("crate") {
                    let form =
                        |found: syn::Error| syn::Error::new(found.span(), wording::crate_form("crate = bica_core"));
                    meta.input.parse::<Token![=]>().map_err(form)?;
                    krate = meta.input.call(Path::parse_mod_style).map_err(form)?;
                } else if meta.path.is_ident("check") {
                    let form = |found: syn::Error| syn::Error::new(found.span(), wording::CHECK_FORM);
                    meta.input.parse::<Token![=]>().map_err(form)?;
                    checks.push(meta.input.parse::<Path>().map_err(form)?);
                    if !meta.input.is_empty() && !meta.input.peek(Token![,]) {
                        return Err(meta.input.error(wording::CHECK_FORM));
                    }
                } else {
                    let found = text::written(&meta.path);
                    let nearest = text::nearest(&found, ["check"].into_iter());
                    return Err(uncoded(Mistake::new(&meta.path, Code::unknown_key(found, nearest, "`check`"))));
                }
                Ok(())
            })
        });
        report.take(parsed);
    }
    (krate, checks)
}

/// Reads an enum with `#[derive(ParamEnum)]`.
pub fn choice(item: TokenStream, report: &mut Report) -> Option<Choice> {
    let input: DeriveInput = report.take(syn::parse2(item))?;
    let (krate, checks) = options(&input.attrs, report);
    if let Some(check) = checks.first() {
        report.add(check, wording::CHOICE_CHECK);
    }
    let mut choice =
        Choice { generic: !input.generics.params.is_empty(), name: input.ident, variants: Vec::new(), krate };
    let Data::Enum(data) = &input.data else {
        report.add(&choice.name, wording::CHOICE_ENUM);
        return Some(choice);
    };
    if choice.generic {
        report.add(&input.generics, wording::PARAMS_GENERIC);
    }
    if data.variants.is_empty() {
        report.add(&choice.name, wording::CHOICE_ENUM);
    }
    for variant in &data.variants {
        if !matches!(variant.fields, Fields::Unit) {
            report.add(&variant.fields, wording::variant_fields(&variant.ident.to_string()));
        }
        choice.variants.push((variant.ident.clone(), text::doc(&variant.attrs)));
    }
    Some(choice)
}
