//! `impl Params`.

use proc_macro2::TokenStream;
use quote::{format_ident, quote, quote_spanned};
use syn::Path;

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
    let access = access(params, &p);
    let each = params.checks.iter().map(|check| quote_spanned!(at(check) => #check(self)?;));
    let check = (!params.checks.is_empty()).then(|| {
        quote! {
            fn check(&self) -> ::core::result::Result<(), &'static str> {
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

            #access
            #check
        }

        #[automatically_derived]
        impl ::core::default::Default for #name {
            fn default() -> Self {
                <Self as #p::Params>::DEFAULT
            }
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
        fn get(&self, index: usize) -> ::core::option::Option<#p::Value> {
            match index {
                #(#places => ::core::option::Option::Some(#reads),)*
                _ => ::core::option::Option::None,
            }
        }

        fn put(&mut self, index: usize, value: #p::Value) {
            match index {
                #(#writes)*
                _ => {}
            }
        }
    }
}

/// The defaults meet the rules between several values.
fn rules(params: &Params, p: &TokenStream) -> TokenStream {
    let name = &params.name;
    let rule = |(index, check): (usize, &Path)| {
        let (p, checked) = (placed(p, at(check)), format_ident!("__CHECKED_{index}"));
        quote_spanned! {at(check) =>
            impl #name {
                #[doc(hidden)]
                const #checked: () = #p::assert_rule(#check(&<Self as #p::Params>::DEFAULT));
            }
            const _: () = #name::#checked;
        }
    };
    params.checks.iter().enumerate().map(rule).collect()
}

/// The mistakes, and a struct without parameters, so that one mistake gives one message.
pub(crate) fn stub(params: &Params, report: &Report) -> TokenStream {
    let (name, krate, errors) = (&params.name, &params.krate, report.to_compile_errors());
    let p = runtime();
    let Some(default) = any_values(params).filter(|_| !params.generic) else { return errors };
    let items = quote! {
        #[automatically_derived]
        impl #p::Params for #name {
            const DEFAULT: Self = #default;
            const GROUP: #p::ParamGroup = #p::ParamGroup { name: "", doc: "", params: &[] };
            fn get(&self, _: usize) -> ::core::option::Option<#p::Value> {
                ::core::option::Option::None
            }
            fn put(&mut self, _: usize, _: #p::Value) {}
        }
    };
    let items = enclosed(krate, &items);
    quote!(#items #errors)
}

/// Values for the fields of a struct with mistakes; `None` if there is a type of which no value is known.
fn any_values(params: &Params) -> Option<TokenStream> {
    let values = params.written.iter().map(|(name, kind, default)| {
        let value = match (default, text::written(kind).as_str()) {
            (Some(default), _) => quote!(#default),
            (None, "f32" | "f64") => quote!(0.0),
            (None, "bool") => quote!(false),
            (None, "i8" | "i16" | "i32" | "i64" | "isize" | "u8" | "u16" | "u32" | "u64" | "usize") => quote!(0),
            _ => return None,
        };
        Some(quote!(#name: #value))
    });
    let values = values.collect::<Option<Vec<_>>>()?;
    params.is_struct.then(|| quote!(Self { #(#values),* }))
}
