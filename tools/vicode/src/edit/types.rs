//! Which types in a text are a component: as far as the text of one file decides it.

use bica_syntax::text::written;
use syn::spanned::Spanned;
use syn::{Expr, Fields, GenericArgument, Item, Path, PathArguments, Type};

use super::imports::{Import, imports};
use super::uses::Target;
use crate::model::Span;
use crate::read::{Kind, Node, Outline, Token};

/// Answers are `None` if the text does not decide.
pub(super) struct Types<'a> {
    pub(super) target: &'a Target,
    /// Whether the text has the component.
    pub(super) is_home: bool,
    pub(super) outline: &'a Outline<'a>,
    /// The tokens without white space and comments.
    pub(super) code: Vec<Token<'a>>,
}

/// Pointers through which methods of their content are called.
const POINTERS: [&str; 9] = ["Box", "Rc", "Arc", "Ref", "RefMut", "Pin", "Cow", "MutexGuard", "ManuallyDrop"];

impl<'a> Types<'a> {
    pub(super) fn new(outline: &'a Outline<'a>, target: &'a Target, is_home: bool) -> Self {
        Self { target, is_home, outline, code: outline.source.code() }
    }

    /// The text of a token; empty before the first and after the last one.
    fn text(&self, token: usize) -> &'a str {
        self.code.get(token).map_or("", |token| token.text)
    }

    /// The token before the `::` in front of a token.
    pub(super) fn before_separator(&self, token: usize) -> Option<usize> {
        let before = token.checked_sub(2).filter(|first| self.text(*first) == ":" && self.text(first + 1) == ":")?;
        before.checked_sub(1)
    }

    /// The token before the `.` in front of a token, unless it is a range.
    pub(super) fn before_dot(&self, token: usize) -> Option<usize> {
        let before = token.checked_sub(2).filter(|before| self.text(before + 1) == ".")?;
        Some(before).filter(|before| self.text(*before) != ".")
    }

    fn is_word(&self, token: usize) -> bool {
        self.code.get(token).is_some_and(|token| token.kind == Kind::Word)
    }

    /// The bracket that opens what a closing one ends.
    fn opening(&self, close: usize) -> Option<usize> {
        let open = if self.text(close) == ")" { "(" } else { "<" };
        let mut depth = 0_usize;
        (0..=close).rev().find(|token| {
            depth += usize::from(self.text(*token) == self.text(close));
            depth -= usize::from(self.text(*token) == open);
            depth == 0
        })
    }

    /// The tokens between two brackets, references and pointers before the first one left out.
    fn between(&self, open: usize, close: usize) -> Vec<usize> {
        (open + 1..close).skip_while(|token| matches!(self.text(*token), "&" | "*" | "mut")).collect()
    }

    /// Whether the path or type that ends with a token before `::` is the component.
    pub(super) fn before_colons(&self, last: usize) -> Option<bool> {
        let at = self.code[last].span.start;
        if self.text(last) == ">" {
            let open = self.opening(last)?;
            if let Some(of) = self.before_separator(open) {
                return self.before_colons(of);
            }
            let inner = self.between(open, last);
            // `<A as Trait>::f` is a function of the trait.
            if inner.iter().any(|token| self.text(*token) == "as") {
                return Some(false);
            }
            let path = inner.iter().take_while(|token| self.is_word(**token) || self.text(**token) == ":");
            let path: Vec<&str> = path.filter(|token| self.is_word(**token)).map(|token| self.text(*token)).collect();
            return self.of_path(&path, at);
        }
        let mut first = Some(last).filter(|token| self.is_word(*token))?;
        let mut path = vec![self.text(first)];
        while let Some(before) = self.before_separator(first).filter(|token| self.is_word(*token)) {
            path.insert(0, self.text(before));
            first = before;
        }
        if first > 0 && self.text(first - 1) == "$" && path[0] != "crate" {
            return None;
        }
        self.of_path(&path, at)
    }

    /// Whether the value that ends with a token before `.` is the component.
    pub(super) fn of_receiver(&self, last: usize) -> Option<bool> {
        let token = self.code[last];
        if token.text == "self" {
            return self.of_path(&["Self"], token.span.start);
        }
        if token.text == ")" {
            let open = self.opening(last)?;
            let before = open.checked_sub(1)?;
            if self.is_word(before) {
                return self.of_call(before);
            }
            return if let [value] = self.between(open, last)[..] { self.of_receiver(value) } else { None };
        }
        match token.kind {
            Kind::Word | Kind::Literal if self.before_dot(last).is_some() => {
                self.of_field(token.text, self.before_dot(last)?)
            }
            Kind::Word if matches!(self.text(last.checked_sub(1)?), "$" | ":") => None,
            Kind::Word => self.of_variable(token),
            Kind::Literal | Kind::Text => Some(false),
            _ => None,
        }
    }

    /// What `Player::new()` or `Player(1)` makes.
    fn of_call(&self, function: usize) -> Option<bool> {
        match self.text(function) {
            "new" | "default" => self.before_colons(self.before_separator(function)?),
            name => is_type(name).then(|| self.before_colons(function))?,
        }
    }

    /// `self.field`, `self.0`
    fn of_field(&self, field: &str, owner: usize) -> Option<bool> {
        if self.text(owner) != "self" {
            return None;
        }
        let at = self.code[owner].span.start;
        let block = self.outline.around(at).find_map(|region| self.outline.block(region))?;
        let Type::Path(path) = &*block.self_ty else { return None };
        let name = &path.path.segments.last()?.ident;
        let scopes = self.outline.around(at).filter_map(|region| self.outline.items(region));
        let owner = scopes.flatten().find_map(|item| match item {
            Item::Struct(item) => Some(item).filter(|item| item.ident == *name),
            _ => None,
        })?;
        let ty = match &owner.fields {
            Fields::Named(fields) => {
                fields.named.iter().find(|one| one.ident.as_ref().is_some_and(|name| name == field)).map(|one| &one.ty)
            }
            Fields::Unnamed(fields) => fields.unnamed.iter().nth(field.parse().ok()?).map(|one| &one.ty),
            Fields::Unit => None,
        };
        self.of(ty?)
    }

    /// A variable: all that its function binds to the name before must agree.
    fn of_variable(&self, variable: Token<'_>) -> Option<bool> {
        let at = variable.span.start;
        let is_function =
            |region: &usize| matches!(self.outline.regions[*region].node, Node::Method(_) | Node::Item(Item::Fn(_)));
        let function = self.outline.around(at).filter(is_function).last()?;
        let function = self.outline.regions[function].span;
        let bindings = self.outline.bindings.iter().filter(|one| {
            let is_before = function.contains(Span::at(one.start)) && one.start < at;
            is_before && one.name == variable.text && !one.around.contains(variable.span)
        });
        let mut answers = bindings.map(|one| match (one.ty, one.value) {
            (Some(ty), _) => self.of(ty),
            (None, Some(value)) => self.of_value(value),
            (None, None) => None,
        });
        let first = answers.next()??;
        answers.all(|other| other == Some(first)).then_some(first)
    }

    /// The value of `let a = value`.
    fn of_value(&self, value: &Expr) -> Option<bool> {
        match value {
            Expr::Reference(inner) => self.of_value(&inner.expr),
            Expr::Paren(inner) => self.of_value(&inner.expr),
            Expr::Unary(inner) => self.of_value(&inner.expr),
            Expr::Array(_) | Expr::Tuple(_) => Some(false),
            Expr::Struct(record) => self.of_syn_path(&record.path),
            Expr::Path(_) | Expr::Call(_) | Expr::Lit(_) => {
                let end = self.outline.source.of(value).end;
                let last = self.code.partition_point(|token| token.span.end < end);
                if is_type(self.text(last)) { self.before_colons(last) } else { self.of_receiver(last) }
            }
            _ => None,
        }
    }

    /// Whether a type, references and pointers left out, is the component.
    pub(super) fn of(&self, ty: &Type) -> Option<bool> {
        match ty {
            Type::Reference(inner) => self.of(&inner.elem),
            Type::Paren(inner) => self.of(&inner.elem),
            Type::Path(path) if path.qself.is_none() => {
                let segment = path.path.segments.last()?;
                let (name, at) = (segment.ident.to_string(), self.outline.source.of(path).start);
                let parameters = self.outline.parameters.iter().filter(|(parameter, _)| parameter.ident == name);
                if parameters.map(|(_, region)| region).any(|region| self.outline.around(at).any(|one| one == *region))
                {
                    return None;
                }
                if !POINTERS.contains(&&*name) {
                    return self.of_syn_path(&path.path);
                }
                let PathArguments::AngleBracketed(list) = &segment.arguments else { return None };
                let inner =
                    list.args.iter().find_map(|one| if let GenericArgument::Type(ty) = one { Some(ty) } else { None });
                self.of(inner?)
            }
            Type::Path(_) | Type::ImplTrait(_) | Type::TraitObject(_) | Type::Infer(_) | Type::Macro(_) => None,
            _ => Some(false),
        }
    }

    fn of_syn_path(&self, path: &Path) -> Option<bool> {
        let words: Vec<String> = path.segments.iter().map(|one| one.ident.to_string()).collect();
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        self.of_path(&words, self.outline.source.of(&path.span()).start)
    }

    /// Whether a path that stands at a place is the component.
    pub(super) fn of_path(&self, path: &[&str], at: usize) -> Option<bool> {
        let scope = || self.outline.around(at).find(|region| self.outline.items(*region).is_some());
        if path != ["Self"] {
            return self.in_scope(path, scope()?, 0);
        }
        self.outline.around(at).find_map(|region| {
            let Node::Item(item) = self.outline.regions[region].node else { return None };
            match item {
                Item::Impl(block) => Some(self.of(&block.self_ty)),
                Item::Struct(item) => Some(self.in_scope(&[&item.ident.to_string()], scope()?, 0)),
                Item::Enum(item) => Some(self.in_scope(&[&item.ident.to_string()], scope()?, 0)),
                Item::Trait(_) => Some(Some(false)),
                _ => None,
            }
        })?
    }

    fn items(&self, scope: usize) -> &'a [&'a Item] {
        self.outline.items(scope).unwrap_or_default()
    }

    /// The module or block around another one.
    fn outer(&self, scope: usize) -> Option<usize> {
        self.outline.outwards(Some(scope)).skip(1).find(|region| self.outline.items(*region).is_some())
    }

    /// The module of that name among the items of a scope.
    fn inner(&self, name: &str, scope: usize) -> Option<usize> {
        self.outline.regions.iter().position(|region| {
            region.parent == Some(scope) && matches!(region.node, Node::Item(Item::Mod(item)) if item.ident == name)
        })
    }

    fn in_scope(&self, path: &[&str], scope: usize, depth: usize) -> Option<bool> {
        let is_block = matches!(self.outline.regions[scope].node, Node::Block(_));
        match path {
            _ if depth > 16 => None,
            [] | ["Self", ..] => None,
            ["self" | "super", ..] if is_block => self.in_scope(path, self.outer(scope)?, depth + 1),
            ["self", rest @ ..] => self.in_scope(rest, scope, depth + 1),
            ["super", rest @ ..] if self.outer(scope).is_some() => self.in_scope(rest, self.outer(scope)?, depth + 1),
            ["crate" | "super", .., last] => self.by_name(last),
            [name] => self.of_name(name, scope, depth),
            [module, rest @ ..] => match self.inner(module, scope) {
                Some(item) if self.outline.parent(item + 1) == Some(item) => self.in_scope(rest, item + 1, depth + 1),
                None if is_block => self.in_scope(path, self.outer(scope)?, depth + 1),
                // Another crate has no component of this file.
                None if self.is_home => Some(false),
                _ => self.by_name(rest.last()?),
            },
        }
    }

    /// What a name stands for among the items of a module or block.
    fn of_name(&self, name: &str, scope: usize, depth: usize) -> Option<bool> {
        for item in self.items(scope) {
            match item {
                Item::Struct(item) if item.ident == name => return self.of_definition(name, scope),
                Item::Enum(item) if item.ident == name => return self.of_definition(name, scope),
                Item::Type(alias) if alias.ident == name => return self.of(&alias.ty),
                Item::Use(item) => {
                    let brought = imports(&item.tree, Vec::new());
                    let Some(Import { path, .. }) = brought.iter().find(|one| one.name.as_deref() == Some(name)) else {
                        continue;
                    };
                    let path: Vec<&str> = path.iter().map(String::as_str).collect();
                    // `use Name` must not lead back to itself.
                    return if path == [name] { self.by_name(name) } else { self.in_scope(&path, scope, depth + 1) };
                }
                _ => {}
            }
        }
        if self.globs(name, scope, depth) {
            return Some(false);
        }
        if matches!(self.outline.regions[scope].node, Node::Block(_)) {
            return self.in_scope(&[name], self.outer(scope)?, depth + 1);
        }
        if self.is_target(name, scope) { Some(true) } else { self.by_name(name) }
    }

    /// Whether the type that a scope defines is the component; undecided if its methods may be those of another one.
    fn of_definition(&self, name: &str, scope: usize) -> Option<bool> {
        let is_deref = |item: &&Item| match item {
            Item::Impl(block) => {
                let of = block.trait_.as_ref().and_then(|(of, _)| of.segments.last());
                of.is_some_and(|of| of.ident == "Deref") && written(&block.self_ty) == name
            }
            _ => false,
        };
        (!self.items(scope).iter().any(is_deref)).then(|| self.is_target(name, scope))
    }

    fn is_target(&self, name: &str, scope: usize) -> bool {
        self.is_home && self.outline.path(scope) == self.target.module && self.target.names[0] == name
    }

    /// Whether a `use ...::*` of a module of this file brings another type of that name.
    fn globs(&self, name: &str, scope: usize, depth: usize) -> bool {
        let uses = super::imports::uses(self.items(scope).iter().copied());
        let mut globs = uses.flat_map(|item| imports(&item.tree, Vec::new())).filter(|one| one.name.is_none());
        globs.any(|one| {
            let first = one.path.first();
            let is_here =
                first.is_some_and(|first| matches!(&**first, "self" | "super") || self.inner(first, scope).is_some());
            let path: Vec<&str> = one.path.iter().map(String::as_str).chain([name]).collect();
            is_here && self.in_scope(&path, scope, depth + 1) == Some(false)
        })
    }

    /// Whether a name that comes from elsewhere is the component's.
    fn by_name(&self, name: &str) -> Option<bool> {
        let is_known = self.target.names.iter().any(|known| known == name);
        if is_known && self.target.has_namesakes { None } else { Some(is_known) }
    }
}

/// Whether a name is written as that of a type, not as that of a constant.
fn is_type(name: &str) -> bool {
    name.starts_with(char::is_uppercase) && (name.len() == 1 || name.contains(char::is_lowercase))
}
