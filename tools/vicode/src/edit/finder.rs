//! Search for the places in a text that may use a function of a component.

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::ToTokens;
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{
    Attribute, Block, Expr, ExprMethodCall, ExprPath, FnArg, ImplItemFn, Item, ItemFn, Local, Macro, Member, Meta, Pat,
    PatIdent, Path, Token, TraitItemFn, Type,
};

use super::target::Use;
use super::types::Types;
use crate::model::Span;

/// Finds the uses of some functions.
pub(super) fn find<'a>(types: Types<'_>, names: &[&'a str]) -> Vec<(&'a str, Use)> {
    let source = types.outline.source;
    let mut finder = Finder { types, names, uses: Vec::new(), bindings: Vec::new() };
    finder.visit_file(&source.file);
    // Parts that were omitted because of syntax errors cannot be resolved: each occurrence of a name is an uncertain use.
    let unread = source.tokens.iter().filter(|token| source.omitted.iter().any(|part| part.contains(token.span)));
    for token in unread {
        finder.add(token.text, token.span, |_| None);
    }
    finder.uses.sort_by_key(|(_, one)| one.span);
    finder.uses
}

struct Finder<'t, 'a> {
    types: Types<'t>,
    names: &'t [&'a str],
    uses: Vec<(&'a str, Use)>,
    /// Names that the current function has bound so far, and whether their values are the component.
    bindings: Vec<(String, Option<bool>)>,
}

impl Finder<'_, '_> {
    fn place(&self, node: &impl Spanned) -> Span {
        self.types.outline.source.of(node)
    }

    /// Adds a use if the name is one of those searched and may refer to the function.
    fn add(&mut self, name: &str, span: Span, is_use: impl FnOnce(&Self) -> Option<bool>) {
        let name = name.strip_prefix("r#").unwrap_or(name);
        let Some(name) = self.names.iter().find(|one| **one == name) else { return };
        let is_use = is_use(self);
        if is_use != Some(false) {
            self.uses.push((name, Use { span, certain: is_use.is_some() }));
        }
    }

    /// Searches the code in a macro or an attribute.
    fn tokens(&mut self, tokens: &TokenStream) {
        if let Ok(values) = Punctuated::<Expr, Token![,]>::parse_terminated.parse2(tokens.clone()) {
            for value in &values {
                self.visit_expr(value);
            }
        } else if let Ok(code) = Block::parse_within.parse2(tokens.clone()) {
            for statement in &code {
                self.visit_stmt(statement);
            }
        } else {
            let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
            for (index, token) in tokens.iter().enumerate() {
                match token {
                    TokenTree::Group(group) => self.tokens(&group.stream()),
                    TokenTree::Ident(name) => {
                        self.add(&name.to_string(), self.place(name), |finder| finder.of_tokens(&tokens[..=index]));
                    }
                    _ => {}
                }
            }
        }
    }

    /// Returns whether the name at the end of unparsable tokens refers to the function, by the value or the path before it.
    fn of_tokens(&self, tokens: &[TokenTree]) -> Option<bool> {
        let is = |back: usize, sign: char| {
            let token = tokens.len().checked_sub(back + 1).map(|at| &tokens[at]);
            matches!(token, Some(TokenTree::Punct(mark)) if mark.as_char() == sign)
        };
        let is_separated = is(1, '.') || is(1, ':') && is(2, ':');
        if !is_separated {
            return Some(false);
        }
        let belongs = |token: &&TokenTree| match token {
            TokenTree::Ident(word) => syn::parse2::<Path>(word.to_token_stream()).is_ok(),
            TokenTree::Punct(mark) => ['.', ':', '$'].contains(&mark.as_char()),
            _ => false,
        };
        let length = tokens.iter().rev().take_while(belongs).count();
        match syn::parse2(tokens[tokens.len() - length..].iter().cloned().collect()).ok()? {
            Expr::Field(field) => self.of(&field.base),
            Expr::Path(path) => self.of_owner(&path),
            _ => None,
        }
    }

    /// Searches a doc comment for paths to a function: `Self::name`, `Player::name`.
    fn docs(&mut self, comment: Span) {
        let text = comment.of(self.types.outline.source.text);
        let is_word = |one: char| one.is_alphanumeric() || one == '_';
        for name in self.names {
            for (at, _) in text.match_indices(name) {
                let path = text[..at].strip_suffix("::");
                let path = path.and_then(|path| path.rsplit(|one: char| !is_word(one) && one != ':').next());
                let path = path.filter(|_| !text[at + name.len()..].starts_with(is_word));
                let is_use = |finder: &Self| {
                    let is_it = finder.types.of_path(&path?.split("::").collect::<Vec<_>>(), comment.start);
                    Some(is_it == Some(true))
                };
                let start = comment.start + at;
                if path.is_some() {
                    self.add(name, Span::new(start, start + name.len()), is_use);
                }
            }
        }
    }

    /// Searches a function with its own scope of variables.
    fn function(&mut self, walk: impl FnOnce(&mut Self)) {
        let outer = std::mem::take(&mut self.bindings);
        walk(self);
        self.bindings = outer;
    }

    fn bind(&mut self, name: &PatIdent, is_component: Option<bool>) {
        self.bindings.push((name.ident.to_string(), is_component));
    }

    /// Returns whether a value is the component.
    fn of(&self, value: &Expr) -> Option<bool> {
        match value {
            Expr::Reference(inner) => self.of(&inner.expr),
            Expr::Paren(inner) => self.of(&inner.expr),
            Expr::Unary(inner) => self.of(&inner.expr),
            Expr::Array(_) | Expr::Tuple(_) | Expr::Lit(_) => Some(false),
            Expr::Struct(record) => self.types.of_syn_path(&record.path, 0),
            Expr::Path(path) if path.path.is_ident("self") => self.types.of_path(&["Self"], self.place(path).start),
            Expr::Path(path) => match (last(path), path.path.get_ident()) {
                (word, _) if is_type(word) => self.types.of_syn_path(&path.path, 0),
                (_, Some(name)) => self.of_variable(name),
                _ => None,
            },
            // Value of `Player::new()` or `Player(1)`.
            Expr::Call(call) => match &*call.func {
                Expr::Path(path) if is_type(last(path)) => self.types.of_syn_path(&path.path, 0),
                Expr::Path(path) if last(path) == "new" || last(path) == "default" => self.of_owner(path),
                _ => None,
            },
            Expr::Field(field) => match &*field.base {
                Expr::Path(path) if path.path.is_ident("self") => self.of_field(&field.member),
                _ => None,
            },
            _ => None,
        }
    }

    /// Returns whether the type before the last segment of a path is the component.
    fn of_owner(&self, path: &ExprPath) -> Option<bool> {
        match &path.qself {
            Some(of) if of.position == 0 && path.path.segments.len() == 1 => self.types.of(&of.ty),
            // `<A as Trait>::f` is a function of the trait.
            Some(of) => (of.position > 0).then_some(false),
            None if path.path.segments.len() > 1 => self.types.of_syn_path(&path.path, 1),
            None => Some(false),
        }
    }

    /// Returns whether a variable is the component, if all bindings of the name so far agree.
    fn of_variable(&self, name: &Ident) -> Option<bool> {
        let mut answers = self.bindings.iter().filter(|(known, _)| name == known).map(|(_, answer)| *answer);
        let first = answers.next()??;
        answers.all(|other| other == Some(first)).then_some(first)
    }

    /// `self.field`, `self.0`
    fn of_field(&self, field: &Member) -> Option<bool> {
        let outline = self.types.outline;
        let at = outline.source.of(field).start;
        let block = outline.around(at).find_map(|region| outline.block(region))?;
        let Type::Path(path) = &*block.self_ty else { return None };
        let name = &path.path.segments.last()?.ident;
        let scopes = outline.around(at).filter_map(|region| outline.items(region));
        let owner = scopes.flatten().find_map(|item| match item {
            Item::Struct(item) => Some(item).filter(|item| item.ident == *name),
            _ => None,
        })?;
        let (_, ty) = owner.fields.members().zip(&owner.fields).find(|(member, _)| member == field)?;
        self.types.of(&ty.ty)
    }
}

/// Returns the last segment of a path.
fn last(path: &ExprPath) -> &Ident {
    &path.path.segments[path.path.segments.len() - 1].ident
}

/// Returns whether a name has the case of a type, not of a constant.
fn is_type(name: &Ident) -> bool {
    let name = name.to_string();
    name.starts_with(char::is_uppercase) && (name.len() == 1 || name.contains(char::is_lowercase))
}

impl Visit<'_> for Finder<'_, '_> {
    fn visit_attribute(&mut self, attribute: &Attribute) {
        match &attribute.meta {
            Meta::List(list) => self.tokens(&list.tokens),
            meta if meta.path().is_ident("doc") => self.docs(self.place(attribute)),
            _ => {}
        }
    }

    fn visit_macro(&mut self, call: &Macro) {
        self.tokens(&call.tokens);
    }

    fn visit_expr_method_call(&mut self, call: &ExprMethodCall) {
        let place = self.place(&call.method);
        self.add(&call.method.to_string(), place, |finder| finder.of(&call.receiver));
        visit::visit_expr_method_call(self, call);
    }

    fn visit_expr_path(&mut self, path: &ExprPath) {
        let place = self.place(last(path));
        self.add(&last(path).to_string(), place, |finder| finder.of_owner(path));
        visit::visit_expr_path(self, path);
    }

    fn visit_item_fn(&mut self, item: &ItemFn) {
        self.function(|finder| visit::visit_item_fn(finder, item));
    }

    fn visit_impl_item_fn(&mut self, item: &ImplItemFn) {
        self.function(|finder| visit::visit_impl_item_fn(finder, item));
    }

    fn visit_trait_item_fn(&mut self, item: &TraitItemFn) {
        self.function(|finder| visit::visit_trait_item_fn(finder, item));
    }

    fn visit_fn_arg(&mut self, input: &FnArg) {
        if let FnArg::Typed(input) = input
            && let Pat::Ident(name) = &*input.pat
        {
            self.bind(name, self.types.of(&input.ty));
        } else {
            visit::visit_fn_arg(self, input);
        }
    }

    fn visit_local(&mut self, local: &Local) {
        if let Some(init) = &local.init {
            self.visit_local_init(init);
        }
        let (pattern, ty) = match &local.pat {
            Pat::Type(typed) => (&*typed.pat, Some(&*typed.ty)),
            pattern => (pattern, None),
        };
        match (pattern, ty, &local.init) {
            (Pat::Ident(name), Some(ty), _) => self.bind(name, self.types.of(ty)),
            (Pat::Ident(name), None, Some(init)) => self.bind(name, self.of(&init.expr)),
            _ => self.visit_pat(pattern),
        }
    }

    fn visit_pat_ident(&mut self, name: &PatIdent) {
        self.bind(name, None);
        visit::visit_pat_ident(self, name);
    }
}
