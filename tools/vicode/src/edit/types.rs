//! Resolution of types to a component, within one file.

use bica_syntax::text::written;
use syn::{GenericArgument, Item, Path, PathArguments, Type};

use super::imports::{Import, imports, uses};
use super::target::Target;
use crate::read::{Node, Outline};

/// Resolver of types. Its methods return `None` if the file alone does not decide.
#[derive(Clone, Copy)]
pub(super) struct Types<'a> {
    pub(super) target: &'a Target,
    /// Whether the text has the component.
    pub(super) is_home: bool,
    pub(super) outline: &'a Outline<'a>,
}

/// Smart pointers, which dereference to their content for method calls.
const POINTERS: [&str; 9] = ["Box", "Rc", "Arc", "Ref", "RefMut", "Pin", "Cow", "MutexGuard", "ManuallyDrop"];

impl<'a> Types<'a> {
    /// Returns whether a type, without references and smart pointers, is the component.
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
                    return self.of_syn_path(&path.path, 0);
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

    /// Returns whether a path, without its last `without` segments, names the component.
    pub(super) fn of_syn_path(&self, path: &Path, without: usize) -> Option<bool> {
        let words: Vec<String> = path.segments.iter().map(|one| one.ident.to_string()).collect();
        let words: Vec<&str> = words[..words.len() - without].iter().map(String::as_str).collect();
        self.of_path(&words, self.outline.source.of(path).start)
    }

    /// Returns whether the path at this offset names the component.
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

    /// Returns the module or block around a scope.
    fn outer(&self, scope: usize) -> Option<usize> {
        self.outline.outwards(Some(scope)).skip(1).find(|region| self.outline.items(*region).is_some())
    }

    /// Returns the module with that name in a scope.
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
                // A path to another crate cannot name a component of this file.
                None if self.is_home => Some(false),
                _ => self.by_name(rest.last()?),
            },
        }
    }

    /// Resolves a name in a module or block.
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
                    // `use Name` would resolve to itself.
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

    /// Returns whether a type defined in a scope is the component; undecided if it dereferences to another type.
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

    /// Returns whether a glob import of a module of this file provides another type with that name.
    fn globs(&self, name: &str, scope: usize, depth: usize) -> bool {
        let uses = uses(self.items(scope).iter().copied());
        let mut globs = uses.flat_map(|item| imports(&item.tree, Vec::new())).filter(|one| one.name.is_none());
        globs.any(|one| {
            let first = one.path.first();
            let is_here =
                first.is_some_and(|first| matches!(&**first, "self" | "super") || self.inner(first, scope).is_some());
            let path: Vec<&str> = one.path.iter().map(String::as_str).chain([name]).collect();
            is_here && self.in_scope(&path, scope, depth + 1) == Some(false)
        })
    }

    /// Returns whether a name from another file is that of the component.
    fn by_name(&self, name: &str) -> Option<bool> {
        let is_known = self.target.names.iter().any(|known| known == name);
        if is_known && self.target.has_namesakes { None } else { Some(is_known) }
    }
}
