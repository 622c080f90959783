//! Search for the places that read a parameter.

use quote::ToTokens;
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::visit::{self, Visit};
use syn::{
    Expr, ExprField, FieldPat, Fields, FnArg, Ident, ImplItemFn, Item, ItemFn, ItemImpl, ItemStruct, Local, Macro,
    Member, Pat, PatStruct, Token, Type,
};

use crate::model::Span;
use crate::read::{Source, parse};

/// Returns the places, in order, that declare the parameter `name` of the struct `group`, or read it as a field of a value of that
/// struct. The type of a value follows from an argument, a field or a `let`.
#[must_use]
pub fn reads(text: &str, group: &str, name: &str) -> Vec<Span> {
    let Some(source) = parse(text) else { return Vec::new() };
    let mut reads = Reads {
        source: &source,
        group,
        name,
        is_own: false,
        values: Vec::new(),
        fields: Vec::new(),
        found: Vec::new(),
    };
    reads.fields = fields_of(&source.file.items, group);
    reads.visit_file(&source.file);
    reads.found.sort();
    reads.found
}

struct Reads<'s, 't> {
    source: &'s Source<'t>,
    group: &'s str,
    name: &'s str,
    /// Whether `self` has the struct's type.
    is_own: bool,
    /// Variables of the current function with the struct's type.
    values: Vec<String>,
    /// Names of all fields with the struct's type.
    fields: Vec<String>,
    found: Vec<Span>,
}

/// Returns whether a type contains the struct's name.
fn mentions(ty: &Type, group: &str) -> bool {
    let text = ty.to_token_stream().to_string();
    text.split(|one: char| !one.is_alphanumeric() && one != '_').any(|word| word == group)
}

/// Returns the names of all fields whose type contains the struct's name.
fn fields_of(items: &[Item], group: &str) -> Vec<String> {
    let fields = items.iter().filter_map(|item| match item {
        Item::Struct(ItemStruct { fields: Fields::Named(fields), .. }) => Some(&fields.named),
        _ => None,
    });
    let typed = fields.flatten().filter(|field| mentions(&field.ty, group));
    typed.filter_map(|field| field.ident.as_ref().map(ToString::to_string)).collect()
}

impl Reads<'_, '_> {
    fn add(&mut self, name: &Ident) {
        if name == self.name {
            self.found.push(self.source.of(name));
        }
    }

    fn is_value(&self, value: &Expr) -> bool {
        match value {
            Expr::Reference(inner) => self.is_value(&inner.expr),
            Expr::Paren(inner) => self.is_value(&inner.expr),
            Expr::Unary(inner) => self.is_value(&inner.expr),
            Expr::Path(path) if path.path.is_ident("self") => self.is_own,
            Expr::Path(path) => path.path.get_ident().is_some_and(|name| self.values.iter().any(|one| name == one)),
            Expr::Field(ExprField { member: Member::Named(name), .. }) => self.fields.iter().any(|one| name == one),
            _ => false,
        }
    }

    /// Searches a function with its own scope of variables.
    fn function(&mut self, walk: impl FnOnce(&mut Self)) {
        let outer = std::mem::take(&mut self.values);
        walk(self);
        self.values = outer;
    }
}

impl Visit<'_> for Reads<'_, '_> {
    fn visit_item_struct(&mut self, item: &ItemStruct) {
        if item.ident == self.group {
            item.fields.iter().filter_map(|field| field.ident.as_ref()).for_each(|name| self.add(name));
        }
    }

    fn visit_item_impl(&mut self, item: &ItemImpl) {
        self.is_own = mentions(&item.self_ty, self.group);
        visit::visit_item_impl(self, item);
        self.is_own = false;
    }

    fn visit_item_fn(&mut self, item: &ItemFn) {
        self.function(|reads| visit::visit_item_fn(reads, item));
    }

    fn visit_impl_item_fn(&mut self, item: &ImplItemFn) {
        self.function(|reads| visit::visit_impl_item_fn(reads, item));
    }

    fn visit_fn_arg(&mut self, input: &FnArg) {
        if let FnArg::Typed(input) = input
            && let Pat::Ident(name) = &*input.pat
            && mentions(&input.ty, self.group)
        {
            self.values.push(name.ident.to_string());
        }
        visit::visit_fn_arg(self, input);
    }

    fn visit_local(&mut self, local: &Local) {
        visit::visit_local(self, local);
        let (pattern, ty) = match &local.pat {
            Pat::Type(typed) => (&*typed.pat, Some(&*typed.ty)),
            pattern => (pattern, None),
        };
        let is_value = ty.map_or_else(
            || local.init.as_ref().is_some_and(|init| self.is_value(&init.expr)),
            |ty| mentions(ty, self.group),
        );
        if let Pat::Ident(name) = pattern {
            self.values.retain(|one| name.ident != one);
            self.values.extend(is_value.then(|| name.ident.to_string()));
        }
    }

    fn visit_expr_field(&mut self, field: &ExprField) {
        if let Member::Named(name) = &field.member
            && self.is_value(&field.base)
        {
            self.add(name);
        }
        visit::visit_expr_field(self, field);
    }

    fn visit_pat_struct(&mut self, pattern: &PatStruct) {
        if pattern.path.segments.last().is_some_and(|last| last.ident == self.group) {
            for FieldPat { member, .. } in &pattern.fields {
                if let Member::Named(name) = member {
                    self.add(name);
                }
            }
        }
        visit::visit_pat_struct(self, pattern);
    }

    fn visit_macro(&mut self, call: &Macro) {
        let values = Punctuated::<Expr, Token![,]>::parse_terminated.parse2(call.tokens.clone());
        values.iter().flatten().for_each(|value| self.visit_expr(value));
    }
}
