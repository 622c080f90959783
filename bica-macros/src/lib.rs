//! The macros of BICA: `#[component]` and `activation_tree!`.
//!
//! Each is a pipeline: parse (tokens to a model of what was written) → check (rules that one item can break) → expand
//! (code). The stages collect mistakes in a report, so that all of an item are seen at once; whatever they find, the
//! item itself is still emitted, and a stand-in for what was to be generated, so that one mistake gives one message.
//! What only the whole program knows (a missing component, an activation cycle, a budget) is left to rustc and to the
//! constant function `bica_core::check::check`.

mod component;
mod expand;
mod language;
#[cfg(test)]
mod tests;
mod tree;

use proc_macro::TokenStream;

#[doc = include_str!("../doc/component.md")]
#[proc_macro_attribute]
pub fn component(options: TokenStream, item: TokenStream) -> TokenStream {
    component::run(options.into(), &item.into()).into()
}

#[doc = include_str!("../doc/activation_tree.md")]
#[proc_macro]
pub fn activation_tree(input: TokenStream) -> TokenStream {
    tree::run(input.into()).into()
}
