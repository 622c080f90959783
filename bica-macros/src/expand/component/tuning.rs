//! The parameters of a component: every `Tuned<P>` of its functions, as one type.

use proc_macro2::{Literal, Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};
use syn::Type;
use syn::spanned::Spanned;

use super::call::nested;
use crate::expand::quoting::{at, placed, runtime};
use bica_syntax::component::model::{Argument, Component, Parameter};
use bica_syntax::text;

/// The structs of parameters that the functions take, each once if it is written alike.
pub(super) struct Tuning(Vec<Type>);

impl Tuning {
    pub(super) fn of(component: &Component) -> Self {
        let mut kinds: Vec<Type> = Vec::new();
        let arguments = component.functions().flat_map(|function| &function.arguments);
        let taken =
            arguments.filter_map(|argument| if let Argument::Tuned(kind) = argument { Some(kind) } else { None });
        for kind in taken.chain(component.timers().map(|timer| &timer.of.0)) {
            if !kinds.iter().any(|known| text::written(known) == text::written(kind)) {
                kinds.push(kind.clone());
            }
        }
        Self(kinds)
    }

    /// Place of a struct of parameters among the groups.
    fn place(&self, kind: &Type) -> usize {
        self.0.iter().position(|known| text::written(known) == text::written(kind)).unwrap_or_default()
    }

    /// The time of a timer that is a parameter, ms, in a visit.
    pub(super) fn milliseconds(&self, timer: &Parameter) -> TokenStream {
        let (kind, field, place) = (&timer.of.0, &timer.field, at(&timer.field));
        let (values, p) = (self.argument(kind), placed(&runtime(), place));
        let number = quote_spanned!(place => #p::Timer::milliseconds(values.#field));
        // At the very token: the compiler finds what is no struct of parameters twice, and reports it once.
        let (params, call) = (placed(&runtime(), kind.span()), quote_spanned!(kind.span() => itself(#values)));
        let own = quote_spanned!(kind.span() => <#kind as #params::Params>::#call);
        quote! {{
            let tuned = cycle.tuned::<Self>();
            let values = #own;
            #number
        }}
    }

    /// Assertions that the parameters that are timers are times.
    pub(super) fn checks(component: &Component) -> TokenStream {
        let check = |timer: &Parameter| {
            let (kind, name, place) = (&timer.of.0, text::name(&timer.field), at(&timer.field));
            let p = placed(&runtime(), place);
            quote_spanned!(place => const _: () = #p::assert_timer(&<#kind as #p::Params>::GROUP, #name);)
        };
        component.timers().map(check).collect()
    }

    /// Index and default of a timer that is a parameter, as a constant.
    pub(super) fn described(&self, timer: &Parameter) -> TokenStream {
        let (group, name, place) = (self.place(&timer.of.0), text::name(&timer.field), at(&timer.field));
        let p = placed(&runtime(), place);
        quote_spanned!(place => #p::timer(<Self as #p::Component>::PARAMS, #group, #name))
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The argument of a call: a reference into the value `tuned`.
    pub(super) fn argument(&self, kind: &Type) -> TokenStream {
        let path = path(self.place(kind), self.0.len());
        if path.is_empty() { quote_spanned!(at(kind) => tuned) } else { quote_spanned!(at(kind) => &tuned #path) }
    }

    /// The items of `impl Component`.
    ///
    /// All of them name a struct as `<P as Params>`, at its place in the signature: if it is none, the compiler finds the
    /// same mistake in each, and reports it once.
    pub(super) fn items(&self) -> TokenStream {
        let p = runtime();
        let types = nested(self.0.iter().map(|kind| quote!(#p::Tuned<#kind>)).collect());
        let place = self.0.first().map_or_else(Span::call_site, at);
        let types = quote_spanned!(place => type Params = #types;);
        let defaults = self.each(&p, &quote!(DEFAULT)).map(|default| quote!(#p::Tuned::new(#default)));
        let defaults = nested(defaults.collect());
        let groups = self.each(&p, &quote!(GROUP));
        let distinct = self.0.iter().enumerate().skip(1).map(|(index, kind)| {
            let p = placed(&p, at(kind));
            quote_spanned!(at(kind) => #p::assert_distinct_names(groups, #index);)
        });
        let access = (!self.is_empty()).then(|| self.access(&p));
        quote! {
            #types
            const PARAMS: &'static [#p::ParamGroup] = {
                let groups: &[#p::ParamGroup] = &[#(#groups),*];
                #(#distinct)*
                groups
            };
            const DEFAULT_PARAMS: Self::Params = #defaults;
            const CONSTANT_PARAMS: &'static Self::Params = &#defaults;
            #access
        }
    }

    /// The functions that read, write and check parameters by their index.
    fn access(&self, p: &TokenStream) -> TokenStream {
        let paths: Vec<_> = (0..self.0.len()).map(|place| path(place, self.0.len())).collect();
        let groups: Vec<_> = self.each(p, &quote!(GROUP)).collect();
        let (get, put, check) = (self.each(p, &quote!(get)), self.each(p, &quote!(put)), self.each(p, &quote!(check)));
        quote! {
            fn param(params: &Self::Params, index: ::core::primitive::usize) -> ::core::option::Option<#p::Value> {
                let first = 0;
                #(
                    let next = first + #groups.params.len();
                    if index < next {
                        return #get(&params #paths, index - first);
                    }
                    let first = next;
                )*
                let _ = first;
                ::core::option::Option::None
            }

            fn put_param(params: &mut Self::Params, index: ::core::primitive::usize, value: #p::Value) {
                let first = 0;
                #(
                    let next = first + #groups.params.len();
                    if index < next {
                        return #put(params #paths.values_mut(), index - first, value);
                    }
                    let first = next;
                )*
                let _ = first;
            }

            fn check_params(params: &Self::Params) -> ::core::result::Result<(), &'static ::core::primitive::str> {
                #(#check(&params #paths)?;)*
                ::core::result::Result::Ok(())
            }
        }
    }

    /// `<P as Params>::item` of each struct.
    fn each(&self, p: &TokenStream, item: &TokenStream) -> std::vec::IntoIter<TokenStream> {
        let one = |kind| {
            let (p, item) = (placed(p, at(kind)), placed(item, at(kind)));
            quote_spanned!(at(kind) => <#kind as #p::Params>::#item)
        };
        self.0.iter().map(one).collect::<Vec<_>>().into_iter()
    }
}

/// The fields that lead to a place in pairs of pairs, as `nested` builds them.
fn path(place: usize, len: usize) -> TokenStream {
    if len < 2 {
        return TokenStream::new();
    }
    let left = len / 2;
    let (field, rest) = if place < left { (0, path(place, left)) } else { (1, path(place - left, len - left)) };
    let field = Literal::usize_unsuffixed(field).to_token_stream();
    quote!(.#field #rest)
}
