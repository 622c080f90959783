//! `impl Actions` for a world.

use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};

use super::component::operator;
use super::quoting::{at, enclosed, option, placed, runtime};
use bica_syntax::component::actions::{Action, WorldActions};
use bica_syntax::report::Report;

/// The impl block as written, what makes actions of its methods, and mistakes: then there are no actions.
pub(crate) fn expand(world: &WorldActions, report: &Report) -> TokenStream {
    let (p, block, errors) = (runtime(), &world.block, report.to_compile_errors());
    let actions = if report.is_empty() { &world.actions[..] } else { &[] };
    let own = &block.header.self_ty;
    let (parameters, _, bounds) = block.header.generics.split_for_impl();
    let descriptions = actions.iter().map(|Action { call, moves }| {
        let (call, moves) = (operator::description(&p, call), option(moves.as_ref()));
        quote!(#p::Action { call: #call, moves: #moves })
    });
    let each = actions.iter().enumerate();
    let checks =
        each.clone().flat_map(|(index, action)| operator::checks(&p, &action.call, &quote!(list[#index].call)));
    let refused = quote!(return ::core::result::Result::Err("there is no such action with these arguments"));
    let arms = each.map(|(index, action)| {
        let called = |name: &Ident, values: &[Ident]| {
            let p = placed(&p, at(name));
            quote_spanned!(at(name) => #p::Outcome::result(self.#name(#(#values),*)))
        };
        operator::arm(&p, index, &action.call, &refused, called)
    });
    let list = quote!({
        let list: &'static [#p::Action] = const { &[#(#descriptions),*] };
        #(#checks;)*
        list
    });
    // A constant is checked whether or not something uses the world; it knows no generics.
    let (constant, list) = if block.header.generics.params.is_empty() {
        (quote!(const __LIST: &'static [#p::Action] = #list;), quote!(__LIST))
    } else {
        (TokenStream::new(), quote!(const #list))
    };
    let items = quote! {
        #constant

        #[automatically_derived]
        impl #parameters #p::Actions for #own #bounds {
            fn list(&self) -> &'static [#p::Action] {
                #list
            }

            fn perform(
                &mut self,
                index: ::core::primitive::usize,
                arguments: &[#p::Value],
            ) -> ::core::result::Result<(), &'static ::core::primitive::str> {
                match (index, arguments) {
                    #(#arms)*
                    _ => #refused,
                }
            }
        }
    };
    let items = enclosed(&world.krate, &items);
    quote!(#block #items #errors)
}
