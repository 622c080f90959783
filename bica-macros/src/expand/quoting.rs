//! Small parts of generated code.

use proc_macro2::{Group, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::Path;
use syn::spanned::Spanned;

/// `Some(value)` or `None`, written out.
pub(crate) fn option<T: ToTokens>(value: Option<&T>) -> TokenStream {
    value.map_or_else(|| quote!(::core::option::Option::None), |value| quote!(::core::option::Option::Some(#value)))
}

/// The path to what generated code uses, inside [`enclosed`].
pub(crate) fn runtime() -> TokenStream {
    quote!(__bica)
}

/// Items in a scope of their own, which names the crate once: a wrong path gives one message.
pub(crate) fn enclosed(krate: &Path, items: &TokenStream) -> TokenStream {
    quote! {
        const _: () = {
            use #krate::__private as __bica;
            #items
        };
    }
}

/// Where the compiler shall point when code generated for these tokens does not hold.
///
/// Only the place is theirs: the names in that code resolve as in all that is generated, also when a `macro_rules` macro
/// handed the tokens on.
pub(crate) fn at(tokens: &impl ToTokens) -> Span {
    Span::call_site().located_at(tokens.span())
}

/// The same tokens for the compiler to point elsewhere.
pub(crate) fn placed(tokens: &TokenStream, span: Span) -> TokenStream {
    let place = |mut token: TokenTree| {
        token.set_span(span);
        token
    };
    tokens.clone().into_iter().map(place).collect()
}

/// The tokens in their places, as if the macro had written them: the compiler then offers no change of the text, which a rule of the
/// macro may refuse, and the same mistake in the user's code and in generated code is one message. A path with `$crate` stays as it is.
pub(crate) fn settled(tokens: &TokenStream) -> TokenStream {
    let settle = |token| match token {
        TokenTree::Group(group) => {
            let mut settled = Group::new(group.delimiter(), settled(&group.stream()));
            settled.set_span(at(&group));
            Some(settled.into())
        }
        TokenTree::Ident(name) if name == "$crate" => None,
        mut token => {
            token.set_span(at(&token));
            Some(token)
        }
    };
    tokens.clone().into_iter().map(settle).collect::<Option<_>>().unwrap_or_else(|| tokens.clone())
}
