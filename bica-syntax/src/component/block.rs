//! An impl block whose function bodies are not read.
//!
//! The macro needs signatures only. A body that is no Rust reaches the compiler as it was written, so that the
//! compiler's own message is the only one.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::parse::discouraged::Speculative;
use syn::parse::{ParseStream, Parser};
use syn::{Abi, Attribute, ImplItem, ItemImpl, Signature, Token, Visibility};

use super::roles::begins_with_role;

/// An impl block.
pub struct Block {
    /// Attributes, generics, type; no items.
    pub header: ItemImpl,
    /// Items in the order of the text.
    pub items: Vec<Item>,
    braces: Group,
    /// Whether something in it is no Rust; the compiler has reported that.
    pub unreadable: bool,
}

/// An item of an impl block.
pub enum Item {
    /// A function.
    Function(Box<Function>),
    /// A constant, a type or a macro.
    Other {
        /// Attributes without ours.
        attributes: Vec<Attribute>,
        /// The item without its attributes.
        tokens: TokenStream,
    },
}

/// A function with its body as written.
pub struct Function {
    /// Attributes without ours.
    pub attributes: Vec<Attribute>,
    /// `pub`, `default`
    prefix: TokenStream,
    /// Signature.
    pub signature: Signature,
    body: TokenTree,
}

impl Block {
    /// Reads an impl block; `None` if the tokens are none.
    #[must_use]
    pub fn read(item: &TokenStream) -> Option<Self> {
        let mut tokens: Vec<TokenTree> = item.clone().into_iter().collect();
        let Some(TokenTree::Group(braces)) = tokens.pop() else { return None };
        if braces.delimiter() != Delimiter::Brace {
            return None;
        }
        tokens.push(with_content(&braces, TokenStream::new()).into());
        let header = syn::parse2(tokens.into_iter().collect()).ok()?;
        let mut block = Self { header, items: Vec::new(), braces: braces.clone(), unreadable: false };
        let reader = |input: ParseStream| {
            items(input, &mut block);
            Ok(())
        };
        let read = reader.parse2(braces.stream());
        block.unreadable |= read.is_err();
        Some(block)
    }

    /// The functions.
    pub fn functions(&self) -> impl Iterator<Item = &Function> {
        self.items.iter().filter_map(|item| if let Item::Function(function) = item { Some(&**function) } else { None })
    }
}

fn items(input: ParseStream, block: &mut Block) {
    if let Ok(inner) = input.call(Attribute::parse_inner) {
        block.items.push(Item::Other { attributes: Vec::new(), tokens: quote!(#(#inner)*) });
    }
    while !input.is_empty() {
        let ahead = input.fork();
        if let Ok(item) = item(&ahead) {
            input.advance_to(&ahead);
            block.items.push(item);
        } else {
            block.unreadable = true;
            block.items.push(Item::Other { attributes: Vec::new(), tokens: unreadable(input) });
        }
    }
}

fn item(input: ParseStream) -> syn::Result<Item> {
    let attributes = input.call(Attribute::parse_outer)?;
    if is_function(&input.fork()) {
        let (visibility, default): (Visibility, Option<Token![default]>) = (input.parse()?, input.parse()?);
        let prefix = quote!(#visibility #default);
        let (signature, body) = (input.parse()?, input.parse()?);
        return Ok(Item::Function(Box::new(Function { attributes, prefix, signature, body })));
    }
    let other: ImplItem = input.parse()?;
    Ok(Item::Other { attributes, tokens: other.to_token_stream() })
}

/// Whether the tokens after the attributes begin a function.
fn is_function(input: ParseStream) -> bool {
    let begin = || -> syn::Result<()> {
        input.parse::<Visibility>()?;
        input.parse::<Option<Token![default]>>()?;
        input.parse::<Option<Token![const]>>()?;
        input.parse::<Option<Token![async]>>()?;
        input.parse::<Option<Token![unsafe]>>()?;
        input.parse::<Option<Abi>>()?;
        input.parse::<Token![fn]>().map(|_| ())
    };
    begin().is_ok()
}

/// What cannot be read up to the next body, without our attributes.
fn unreadable(input: ParseStream) -> TokenStream {
    let mut tokens = Vec::new();
    while let Ok(token) = input.parse::<TokenTree>() {
        let ends = matches!(&token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
        let role = matches!(&token, TokenTree::Group(group) if begins_with_role(group));
        if role && matches!(tokens.last(), Some(TokenTree::Punct(mark)) if mark.as_char() == '#') {
            tokens.pop();
        } else {
            tokens.push(token);
        }
        if ends {
            break;
        }
    }
    tokens.into_iter().collect()
}

fn with_content(braces: &Group, content: TokenStream) -> Group {
    let mut group = Group::new(Delimiter::Brace, content);
    group.set_span(braces.span());
    group
}

impl ToTokens for Block {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        let items = &self.items;
        let mut header: Vec<TokenTree> = self.header.to_token_stream().into_iter().collect();
        header.pop();
        tokens.extend(header);
        tokens.extend([TokenTree::from(with_content(&self.braces, quote!(#(#items)*)))]);
    }
}

impl ToTokens for Item {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        match self {
            Self::Function(function) => {
                let Function { attributes, prefix, signature, body } = &**function;
                tokens.extend(quote!(#(#attributes)* #prefix #signature #body));
            }
            Self::Other { attributes, tokens: other } => tokens.extend(quote!(#(#attributes)* #other)),
        }
    }
}
