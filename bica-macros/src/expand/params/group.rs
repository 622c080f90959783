//! `impl Params`.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use syn::{Expr, ExprLit, Lit, Path};

use super::describe;
use crate::expand::quoting::{at, enclosed, placed, runtime};
use bica_syntax::params::model::Params;
use bica_syntax::report::Report;
use bica_syntax::text;

/// The traits of a struct of parameters, and the assertions about it.
pub(crate) fn params(params: &Params) -> TokenStream {
    let p = runtime();
    let (name, label, doc) = (&params.name, text::name(&params.name), &params.doc);
    let names: Vec<_> = params.fields.iter().map(|field| &field.name).collect();
    let defaults = params.fields.iter().map(|field| &field.default);
    let descriptions = params.fields.iter().map(|field| {
        let name = &field.name;
        describe::param(&p, field, Some(&quote!(<Self as #p::Params>::DEFAULT.#name)))
    });
    let assertions =
        params.fields.iter().enumerate().map(|(place, field)| {
            describe::assertions(&p, field, &quote!(<#name as #p::Params>::GROUP.params[#place]))
        });
    let (access, itself) = (access(params, &p), itself());
    let each = (0..params.checks.len()).map(|index| {
        let rule = rule_name(index);
        quote!(self.#rule()?;)
    });
    let check = (!params.checks.is_empty()).then(|| {
        quote! {
            fn check(&self) -> ::core::result::Result<(), &'static ::core::primitive::str> {
                #(#each)*
                ::core::result::Result::Ok(())
            }
        }
    });
    let rules = rules(params, &p);
    let items = quote! {
        #[automatically_derived]
        impl #p::Params for #name {
            const DEFAULT: Self = Self { #(#names: #defaults),* };
            const GROUP: #p::ParamGroup =
                #p::ParamGroup { name: #label, doc: #p::doc(#doc), params: &[#(#descriptions),*] };

            #itself

            #access
            #check
        }

        #[automatically_derived]
        impl ::core::default::Default for #name {
            fn default() -> Self {
                <Self as #p::Params>::DEFAULT
            }
        }

        impl #name {
            #[doc(hidden)]
            #[allow(dead_code, reason = "a component asks for it")]
            pub const __PARAMS: ::core::primitive::bool = true;
        }

        #(#assertions)*
        #rules
    };
    enclosed(&params.krate, &items)
}

/// The functions that read and write a parameter by its index.
fn access(params: &Params, p: &TokenStream) -> TokenStream {
    let places = 0..params.fields.len();
    let reads = params.fields.iter().map(|field| {
        let name = &field.name;
        describe::to_value(p, field, &quote!(self.#name))
    });
    let writes = params.fields.iter().enumerate().map(|(place, field)| {
        let (name, value) = (&field.name, describe::from_value(p, field, &quote!(value)));
        quote!(#place => if let ::core::option::Option::Some(value) = #value { self.#name = value; },)
    });
    quote! {
        fn get(&self, index: ::core::primitive::usize) -> ::core::option::Option<#p::Value> {
            match index {
                #(#places => ::core::option::Option::Some(#reads),)*
                _ => ::core::option::Option::None,
            }
        }

        fn put(&mut self, index: ::core::primitive::usize, value: #p::Value) {
            match index {
                #(#writes)*
                _ => {}
            }
        }
    }
}

fn rule_name(index: usize) -> Ident {
    format_ident!("__rule_{index}")
}

/// The rules between several values, and the check that the defaults meet them. The path to each stands once.
fn rules(params: &Params, p: &TokenStream) -> TokenStream {
    let name = &params.name;
    let rule = |(index, check): (usize, &Path)| {
        let (p, rule) = (placed(p, at(check)), rule_name(index));
        quote_spanned! {at(check) =>
            impl #name {
                #[doc(hidden)]
                const fn #rule(&self) -> ::core::result::Result<(), &'static ::core::primitive::str> {
                    #check(self)
                }
            }
            const _: () = #p::assert_rule(#name::#rule(&<#name as #p::Params>::DEFAULT));
        }
    };
    params.checks.iter().enumerate().map(rule).collect()
}

fn itself() -> TokenStream {
    quote! {
        type Itself = Self;

        #[inline]
        fn itself(&self) -> &Self {
            self
        }
    }
}

/// The mistakes, and a struct without parameters, so that one mistake gives one message.
pub(crate) fn stub(params: &Params, report: &Report) -> TokenStream {
    let (name, krate, errors) = (&params.name, &params.krate, report.to_compile_errors());
    let p = runtime();
    let Some(default) = any_values(params).filter(|_| !params.generic) else { return errors };
    let itself = itself();
    let items = quote! {
        #[automatically_derived]
        impl #p::Params for #name {
            const DEFAULT: Self = #default;
            const GROUP: #p::ParamGroup = #p::ParamGroup { name: "", doc: "", params: &[] };
            #itself
            fn get(&self, _: ::core::primitive::usize) -> ::core::option::Option<#p::Value> {
                ::core::option::Option::None
            }
            fn put(&mut self, _: ::core::primitive::usize, _: #p::Value) {}
        }
    };
    let items = enclosed(krate, &items);
    quote!(#items #errors)
}

/// Values for the fields of a struct with mistakes; `None` if there is a type of which no value is known.
fn any_values(params: &Params) -> Option<TokenStream> {
    let values = params.written.iter().map(|(name, kind, default)| {
        let value = match (text::written(kind).as_str(), default) {
            ("Duration" | "Instant", _) => quote!(<#kind>::from_millis(0)),
            ("String", _) => quote!(<#kind>::new()),
            ("&str" | "&'static str", _) => quote!(""),
            ("f32" | "f64", _) => quote!(0.0),
            ("bool", _) => quote!(false),
            ("i8" | "i16" | "i32" | "i64" | "isize" | "u8" | "u16" | "u32" | "u64" | "usize", _) => quote!(0),
            (_, Some(default)) if !matches!(default, Expr::Lit(ExprLit { lit: Lit::Str(_), .. })) => quote!(#default),
            _ => return None,
        };
        Some(quote!(#name: #value))
    });
    let values = values.collect::<Option<Vec<_>>>()?;
    params.is_struct.then(|| quote!(Self { #(#values),* }))
}
