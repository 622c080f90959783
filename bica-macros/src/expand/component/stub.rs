//! The code of an item with mistakes: a component that does nothing, so that one mistake gives one message.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{GenericArgument, GenericParam, Generics, Path, PathArguments, Type, parse_quote};

use super::description;
use crate::expand::quoting::{enclosed, runtime};
use bica_syntax::component::model::Component;
use bica_syntax::report::Report;

/// The impl block as written, the mistakes, and a component that does nothing.
pub(crate) fn stub(component: &Component, report: &Report) -> TokenStream {
    let (block, errors) = (&component.block, report.to_compile_errors());
    let nothing = nothing(&component.options.krate, &component.block.header.generics, component.own());
    quote!(#block #nothing #errors)
}

/// An item that is no impl block of a type, the mistakes, and a component that does nothing for the type that was meant.
pub(crate) fn misplaced(item: &TokenStream, of: Option<&(Generics, Type)>, report: &Report) -> TokenStream {
    let errors = report.to_compile_errors();
    let nothing = of.map(|(generics, own)| nothing(&parse_quote!(::bica), generics, own));
    quote!(#item #nothing #errors)
}

/// A component that trees accept and do not check. A type that borrows can be no component: its lifetimes become `'static`.
fn nothing(krate: &Path, generics: &Generics, own: &Type) -> TokenStream {
    let p = runtime();
    let own = &without_lifetimes(own.clone());
    let mut generics = generics.clone();
    generics.params =
        generics.params.into_iter().filter(|parameter| !matches!(parameter, GenericParam::Lifetime(_))).collect();
    let name = description::name(own);
    let time = (name == "Time")
        .then(|| quote!(impl #p::CycleTime for #own { fn of(_: &#p::Time) -> &Self { ::core::unreachable!() } }));
    let generics = description::owned(&generics);
    let mut member = generics.clone();
    member.params.push(parse_quote!(__T: #p::Has<#own>));
    let (parameters, _, bounds) = generics.split_for_impl();
    let (member_parameters, _, _) = member.split_for_impl();
    let items = quote! {
        pub struct __Block;

        #time

        #[automatically_derived]
        impl #parameters #p::Component for #own #bounds {
            type Itself = Self;
            type Block = __Block;
            const NAME: &'static ::core::primitive::str = #name;
            const DOC: &'static ::core::primitive::str = "";
            const HZ: ::core::option::Option<::core::primitive::f32> = ::core::option::Option::None;
            const BUDGET_US: ::core::option::Option<::core::primitive::f32> = ::core::option::Option::None;
            const RESUME: ::core::primitive::bool = false;
            const STATES: &'static [#p::State] = &[];
            const IS_STUB: ::core::primitive::bool = true;
            type Params = ();
            const DEFAULT_PARAMS: () = ();
            const CONSTANT_PARAMS: &'static () = &();
            type Work = ();
        }

        #[automatically_derived]
        impl #member_parameters #p::MemberOf<__T, __Block> for #own #bounds {
            const WRITTEN: &'static [#p::WrittenLink] = &[];
            const NODE: #p::Node = #p::Node::new(#name);
            const TIMED: ::core::primitive::bool = false;

            fn pass<__P: #p::Probe>(_: &mut #p::Cycle<'_, __T, __P>, _: #p::Visit) {
                const { ::core::panic!("`#[component]` could not read the block of this component: write it in plainer Rust") }
            }
        }
    };
    enclosed(krate, &items)
}

fn without_lifetimes(mut own: Type) -> Type {
    if let Type::Path(path) = &mut own
        && let Some(last) = path.path.segments.last_mut()
        && let PathArguments::AngleBracketed(list) = &mut last.arguments
    {
        for argument in &mut list.args {
            if let GenericArgument::Lifetime(lifetime) = argument {
                *lifetime = parse_quote!('static);
            }
        }
    }
    own
}
