//! The macros of BICA: `#[component]`, `#[role]`, `activation_tree!`, `#[derive(Params)]`, `#[derive(ParamEnum)]`, `#[data]`,
//! `#[world_actions]` and `#[derive(ComponentDoc)]`.
//!
//! Each is a pipeline: parse (from tokens to a model) → check (rules within one item) → expand (to code). The first two
//! and the wording of every message are the crate `bica-syntax`, which tools use too; `expand` has one file for each thing
//! that is generated.
//!
//! The stages collect mistakes in a report, so that all of an item are reported at once. An item with mistakes is still
//! emitted, with a stub in place of the generated code, so that one mistake gives one message. Function bodies are not
//! read: a syntax error in one is the compiler's to report.
//!
//! Rules that concern the whole program (a missing component, an activation cycle, a budget, two paths to one type) are
//! left to the compiler: to traits with messages of their own and to constant functions such as
//! `bica_core::check::check`.

mod actions;
mod component;
mod expand;
mod params;
mod plain_item;
mod role;
#[cfg(test)]
mod tests;
mod tree;

use proc_macro::TokenStream;

#[doc = include_str!("../doc/component.md")]
#[proc_macro_attribute]
pub fn component(options: TokenStream, item: TokenStream) -> TokenStream {
    component::run(written(options), &item.into()).into()
}

#[doc = include_str!("../doc/activation_tree.md")]
#[proc_macro]
pub fn activation_tree(input: TokenStream) -> TokenStream {
    let place = proc_macro::Span::call_site();
    tree::run(input.into(), (place.line(), place.column())).into()
}

#[doc = include_str!("../doc/params.md")]
#[proc_macro_derive(Params, attributes(params, param))]
pub fn params(item: TokenStream) -> TokenStream {
    params::params(item.into()).into()
}

#[doc = include_str!("../doc/param_enum.md")]
#[proc_macro_derive(ParamEnum, attributes(params))]
pub fn param_enum(item: TokenStream) -> TokenStream {
    params::choice(item.into()).into()
}

#[doc = include_str!("../doc/component_doc.md")]
#[proc_macro_derive(ComponentDoc)]
pub fn component_doc(item: TokenStream) -> TokenStream {
    plain_item::component_doc(item.into()).into()
}

#[doc = include_str!("../doc/data.md")]
#[proc_macro_attribute]
pub fn data(options: TokenStream, item: TokenStream) -> TokenStream {
    plain_item::data(written(options), &item.into()).into()
}

/// Marks a getter of a component as an output: see [`macro@component`]. Anywhere else it is a mistake.
#[proc_macro_attribute]
pub fn output(options: TokenStream, item: TokenStream) -> TokenStream {
    plain_item::earlier("output", written(options), &item.into()).into()
}

#[doc(hidden)]
#[proc_macro_attribute]
pub fn message(options: TokenStream, item: TokenStream) -> TokenStream {
    plain_item::earlier("message", written(options), &item.into()).into()
}

#[doc = include_str!("../doc/world_actions.md")]
#[proc_macro_attribute]
pub fn world_actions(options: TokenStream, item: TokenStream) -> TokenStream {
    actions::run(written(options), &item.into()).into()
}

#[doc = include_str!("../doc/role.md")]
#[proc_macro_attribute]
pub fn role(options: TokenStream, item: TokenStream) -> TokenStream {
    role::run(written(options), &item.into()).into()
}

/// The options of an attribute; none if it is written `#[name = value]`, which the compiler refuses itself.
fn written(options: TokenStream) -> proc_macro2::TokenStream {
    let attribute = proc_macro::Span::call_site().source_text().unwrap_or_default();
    let first = attribute.trim_start_matches("#[").matches(['(', '[', '{', '=']).next();
    if first == Some("=") { proc_macro2::TokenStream::new() } else { options.into() }
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
