//! Which types in a text are a component: as far as the text of one file decides it.

use ra_ap_syntax::ast::{self, HasGenericArgs, HasGenericParams, HasName};
use ra_ap_syntax::{AstNode, SyntaxKind, SyntaxNode, SyntaxToken, T};

use super::uses::Target;
use crate::read::module_of;

/// Answers are `None` if the text does not decide.
pub(super) struct Types<'a> {
    pub(super) target: &'a Target,
    /// Whether the text has the component.
    pub(super) is_home: bool,
}

/// Pointers through which methods of their content are called.
const POINTERS: [&str; 9] = ["Box", "Rc", "Arc", "Ref", "RefMut", "Pin", "Cow", "MutexGuard", "ManuallyDrop"];

/// The token before a token, without white space and comments.
pub(super) fn previous(token: &SyntaxToken) -> Option<SyntaxToken> {
    std::iter::successors(token.prev_token(), SyntaxToken::prev_token).find(|token| !token.kind().is_trivia())
}

/// The token after a token, without white space and comments.
pub(super) fn next(token: &SyntaxToken) -> Option<SyntaxToken> {
    std::iter::successors(token.next_token(), SyntaxToken::next_token).find(|token| !token.kind().is_trivia())
}

/// The token before the `::` in front of a token; within a macro `::` is two tokens.
pub(super) fn before_separator(token: &SyntaxToken) -> Option<SyntaxToken> {
    let colons = previous(token)?;
    match colons.kind() {
        T![::] => previous(&colons),
        T![:] => previous(&colons).filter(|first| first.kind() == T![:]).and_then(|first| previous(&first)),
        _ => None,
    }
}

/// The bracket that opens what a closing one ends.
fn opening(close: &SyntaxToken) -> Option<SyntaxToken> {
    let open = if close.kind() == T![')'] { T!['('] } else { T![<] };
    let mut depth = 0_usize;
    std::iter::successors(Some(close.clone()), previous).find(|token| {
        depth += usize::from(token.kind() == close.kind());
        depth -= usize::from(token.kind() == open);
        depth == 0
    })
}

/// The tokens between two brackets, references and pointers before the first one left out.
fn between(open: &SyntaxToken, close: &SyntaxToken) -> Vec<SyntaxToken> {
    let end = close.text_range().end();
    std::iter::successors(next(open), next)
        .take_while(|token| token.text_range().end() < end)
        .skip_while(|token| matches!(token.kind(), T![&] | T![*] | T![mut]))
        .collect()
}

impl Types<'_> {
    /// Whether the path or type that ends with a token before `::` is the component.
    pub(super) fn before_colons(&self, last: &SyntaxToken) -> Option<bool> {
        if last.kind() == T![>] {
            let open = opening(last)?;
            if let Some(of) = before_separator(&open) {
                return self.before_colons(&of);
            }
            let inner = between(&open, last);
            // `<A as Trait>::f` is a function of the trait.
            if inner.iter().any(|token| token.kind() == T![as]) {
                return Some(false);
            }
            let path = inner.iter().take_while(|token| is_word(token) || matches!(token.kind(), T![::] | T![:]));
            let path: Vec<&str> = path.filter(|token| is_word(token)).map(SyntaxToken::text).collect();
            return self.of_path(&path, last);
        }
        let mut path = vec![Some(last.clone()).filter(is_word)?];
        while let Some(before) = before_separator(&path[0]).filter(is_word) {
            path.insert(0, before);
        }
        if previous(&path[0]).is_some_and(|before| before.kind() == T![$]) && path[0].kind() != T![crate] {
            return None;
        }
        self.of_path(&path.iter().map(SyntaxToken::text).collect::<Vec<_>>(), last)
    }

    /// Whether the value that ends with a token before `.` is the component.
    pub(super) fn of_receiver(&self, last: &SyntaxToken) -> Option<bool> {
        match last.kind() {
            T![self] => self.of_path(&["Self"], last),
            SyntaxKind::IDENT | SyntaxKind::INT_NUMBER => {
                let before = previous(last)?;
                match before.kind() {
                    T![.] => self.of_field(last, &previous(&before)?),
                    T![$] | T![::] | T![:] => None,
                    _ if last.kind() == SyntaxKind::IDENT => self.of_variable(last),
                    _ => Some(false),
                }
            }
            T![')'] => {
                let open = opening(last)?;
                let before = previous(&open)?;
                if before.kind() == SyntaxKind::IDENT {
                    return self.of_call(&before);
                }
                if let [value] = &between(&open, last)[..] { self.of_receiver(value) } else { None }
            }
            kind => kind.is_literal().then_some(false),
        }
    }

    /// What `Player::new()` or `Player(1)` makes.
    fn of_call(&self, function: &SyntaxToken) -> Option<bool> {
        match function.text() {
            "new" | "default" => self.before_colons(&before_separator(function)?),
            name => is_type(name).then(|| self.before_colons(function))?,
        }
    }

    /// `self.field`, `self.0`
    fn of_field(&self, field: &SyntaxToken, owner: &SyntaxToken) -> Option<bool> {
        if owner.kind() != T![self] {
            return None;
        }
        let of = field.parent_ancestors().find_map(ast::Impl::cast)?.self_ty()?;
        let ast::Type::PathType(path) = of else { return None };
        let name = path.path()?.segment()?.name_ref()?.text().to_string();
        let items = field.parent_ancestors().filter(is_scope).flat_map(|scope| scope.children());
        let owner = items.filter_map(ast::Struct::cast).find(|one| named(one, &name))?;
        let ty = match owner.field_list()? {
            ast::FieldList::RecordFieldList(list) => list.fields().find(|one| named(one, field.text()))?.ty(),
            ast::FieldList::TupleFieldList(list) => list.fields().nth(field.text().parse().ok()?)?.ty(),
        };
        self.of(&ty?)
    }

    /// A variable: all that its function binds to the name before must agree.
    fn of_variable(&self, variable: &SyntaxToken) -> Option<bool> {
        let function = variable.parent_ancestors().filter_map(ast::Fn::cast).last()?;
        let before = variable.text_range().start();
        let bindings = function.syntax().descendants().filter_map(ast::IdentPat::cast);
        // `let k = k;` gives the value of the outer `k`.
        let around = |one: &ast::IdentPat| {
            one.syntax().parent().is_some_and(|parent| parent.text_range().contains_range(variable.text_range()))
        };
        let bindings = bindings
            .filter(|one| named(one, variable.text()) && one.syntax().text_range().start() < before && !around(one));
        let mut answers = bindings.map(|one| self.of_binding(&one));
        let first = answers.next()??;
        answers.all(|other| other == Some(first)).then_some(first)
    }

    fn of_binding(&self, binding: &ast::IdentPat) -> Option<bool> {
        let parent = binding.syntax().parent()?;
        if let Some(param) = ast::Param::cast(parent.clone()) {
            return self.of(&param.ty()?);
        }
        let binding = ast::LetStmt::cast(parent)?;
        match binding.ty() {
            Some(ty) => self.of(&ty),
            None => self.of_value(&binding.initializer()?),
        }
    }

    /// The value of `let a = value`.
    fn of_value(&self, value: &ast::Expr) -> Option<bool> {
        match value {
            ast::Expr::RefExpr(inner) => self.of_value(&inner.expr()?),
            ast::Expr::ParenExpr(inner) => self.of_value(&inner.expr()?),
            ast::Expr::PrefixExpr(inner) => self.of_value(&inner.expr()?),
            ast::Expr::ArrayExpr(_) | ast::Expr::TupleExpr(_) => Some(false),
            ast::Expr::RecordExpr(record) => self.of_ast_path(&record.path()?),
            ast::Expr::PathExpr(_) | ast::Expr::CallExpr(_) | ast::Expr::Literal(_) => {
                let last = value.syntax().last_token()?;
                if is_type(last.text()) { self.before_colons(&last) } else { self.of_receiver(&last) }
            }
            _ => None,
        }
    }

    /// Whether a type, references and pointers left out, is the component.
    pub(super) fn of(&self, ty: &ast::Type) -> Option<bool> {
        match ty {
            ast::Type::RefType(inner) => self.of(&inner.ty()?),
            ast::Type::ParenType(inner) => self.of(&inner.ty()?),
            ast::Type::PathType(path) => {
                let segment = path.path()?.segment()?;
                let name = segment.name_ref()?.text().to_string();
                let lists = path.syntax().ancestors().filter_map(ast::AnyHasGenericParams::cast);
                let params = lists.filter_map(|item| item.generic_param_list()).flat_map(|list| list.generic_params());
                if params.filter_map(|one| one.syntax().first_token()).any(|first| first.text() == name) {
                    return None;
                }
                if POINTERS.contains(&&*name) {
                    let inner = segment
                        .generic_arg_list()?
                        .syntax()
                        .children()
                        .find_map(|one| one.children().find_map(ast::Type::cast));
                    return self.of(&inner?);
                }
                self.of_ast_path(&path.path()?)
            }
            ast::Type::ImplTraitType(_)
            | ast::Type::DynTraitType(_)
            | ast::Type::InferType(_)
            | ast::Type::MacroType(_) => None,
            _ => Some(false),
        }
    }

    fn of_ast_path(&self, path: &ast::Path) -> Option<bool> {
        let words = path.segments().map(|one| one.syntax().first_token().map(|word| word.text().to_owned()));
        let words: Option<Vec<String>> = words.collect();
        self.of_path(&words?.iter().map(String::as_str).collect::<Vec<_>>(), &path.syntax().last_token()?)
    }

    /// Whether a path that stands at a token is the component.
    pub(super) fn of_path(&self, path: &[&str], at: &SyntaxToken) -> Option<bool> {
        if path != ["Self"] {
            return self.in_scope(path, &scope_of(at)?, 0);
        }
        at.parent_ancestors().find_map(|node| match ast::Item::cast(node)? {
            ast::Item::Impl(block) => Some(self.of(&block.self_ty()?)),
            ast::Item::Struct(item) => Some(self.in_scope(&[item.name()?.text()], &scope_of(at)?, 0)),
            ast::Item::Enum(item) => Some(self.in_scope(&[item.name()?.text()], &scope_of(at)?, 0)),
            ast::Item::Trait(_) => Some(Some(false)),
            _ => None,
        })?
    }

    fn in_scope(&self, path: &[&str], scope: &SyntaxNode, depth: usize) -> Option<bool> {
        let outer = || scope.ancestors().skip(1).find(is_scope);
        let is_block = scope.kind() == SyntaxKind::STMT_LIST;
        match path {
            _ if depth > 16 => None,
            [] | ["Self", ..] => None,
            ["self" | "super", ..] if is_block => self.in_scope(path, &outer()?, depth + 1),
            ["self", rest @ ..] => self.in_scope(rest, scope, depth + 1),
            ["super", rest @ ..] if outer().is_some() => self.in_scope(rest, &outer()?, depth + 1),
            ["crate" | "super", .., last] => self.by_name(last),
            [name] => self.of_name(name, scope, depth),
            [module, rest @ ..] => {
                let inner = scope.children().filter_map(ast::Module::cast).find(|one| named(one, module));
                match inner.as_ref().map(ast::Module::item_list) {
                    Some(Some(items)) => self.in_scope(rest, items.syntax(), depth + 1),
                    None if is_block => self.in_scope(path, &outer()?, depth + 1),
                    // Another crate has no component of this file.
                    None if self.is_home => Some(false),
                    _ => self.by_name(rest.last()?),
                }
            }
        }
    }

    /// What a name stands for among the items of a module.
    fn of_name(&self, name: &str, scope: &SyntaxNode, depth: usize) -> Option<bool> {
        for node in scope.children() {
            let is = |item: Option<ast::Name>| item.is_some_and(|item| item.text() == name);
            if is(ast::Struct::cast(node.clone()).and_then(|one| one.name()))
                || is(ast::Enum::cast(node.clone()).and_then(|one| one.name()))
            {
                let is_deref = |block: ast::Impl| {
                    let (of, ty) = (block.trait_(), block.self_ty());
                    of.is_some_and(|of| of.syntax().text().to_string().ends_with("Deref"))
                        && ty.is_some_and(|ty| ty.syntax().text() == name)
                };
                if scope.children().filter_map(ast::Impl::cast).any(is_deref) {
                    return None;
                }
                return Some(self.is_home && module_of(scope) == self.target.module && self.target.names[0] == name);
            }
            if let Some(alias) = ast::TypeAlias::cast(node.clone()).filter(|alias| named(alias, name)) {
                return self.of(&alias.ty()?);
            }
            for tree in
                ast::Use::cast(node).iter().flat_map(|item| item.syntax().descendants()).filter_map(ast::UseTree::cast)
            {
                if let Some(path) = imported(&tree, name) {
                    let path: Vec<&str> = path.iter().map(String::as_str).collect();
                    // `use Name` must not lead back to itself.
                    return if path == [name] { self.by_name(name) } else { self.in_scope(&path, scope, depth + 1) };
                }
            }
        }
        if self.globs(name, scope, depth) {
            return Some(false);
        }
        if scope.kind() == SyntaxKind::STMT_LIST {
            return self.in_scope(&[name], &scope.ancestors().skip(1).find(is_scope)?, depth + 1);
        }
        let here = self.is_home && module_of(scope) == self.target.module;
        if here && self.target.names[0] == name { Some(true) } else { self.by_name(name) }
    }

    /// Whether a `use ...::*` of a module of this file brings another type of that name.
    fn globs(&self, name: &str, scope: &SyntaxNode, depth: usize) -> bool {
        let items = scope.children().filter_map(ast::Use::cast).filter_map(|item| item.use_tree());
        let mut globs = items.filter(|tree| tree.star_token().is_some()).map(|tree| path_of(&tree));
        let is_inner = |module: &str| scope.children().filter_map(ast::Module::cast).any(|one| named(&one, module));
        globs.any(|mut path| {
            let is_here = path.first().is_some_and(|first| matches!(&**first, "self" | "super") || is_inner(first));
            path.push(name.to_owned());
            let path: Vec<&str> = path.iter().map(String::as_str).collect();
            is_here && self.in_scope(&path, scope, depth + 1) == Some(false)
        })
    }

    /// Whether a name that comes from elsewhere is the component's.
    fn by_name(&self, name: &str) -> Option<bool> {
        let is_known = self.target.names.iter().any(|known| known == name);
        if is_known && self.target.has_namesakes { None } else { Some(is_known) }
    }
}

/// The path by which a `use` brings a name.
pub(super) fn imported(tree: &ast::UseTree, name: &str) -> Option<Vec<String>> {
    if tree.use_tree_list().is_some() || tree.star_token().is_some() {
        return None;
    }
    let mut path = path_of(tree);
    let renamed = tree.rename().and_then(|rename| rename.name()).map(|renamed| renamed.text().to_string());
    if renamed.as_ref().or(path.last())? != name {
        return None;
    }
    for outer in tree.syntax().ancestors().skip(1).filter_map(ast::UseTree::cast) {
        path.splice(0..0, path_of(&outer));
    }
    Some(path)
}

/// The words of the path of a `use`.
fn path_of(tree: &ast::UseTree) -> Vec<String> {
    let Some(path) = tree.path() else { return Vec::new() };
    path.segments().map(|segment| segment.syntax().text().to_string()).collect()
}

pub(super) fn named(item: &impl HasName, name: &str) -> bool {
    item.name().is_some_and(|known| known.text() == name)
}

/// Whether a name is written as that of a type, not as that of a constant.
fn is_type(name: &str) -> bool {
    name.starts_with(char::is_uppercase) && (name.len() == 1 || name.contains(char::is_lowercase))
}

fn is_word(token: &SyntaxToken) -> bool {
    token.kind() == SyntaxKind::IDENT
        || token.kind().is_any_identifier()
        || matches!(token.kind(), T![self] | T![Self] | T![super] | T![crate])
}

fn is_scope(node: &SyntaxNode) -> bool {
    matches!(node.kind(), SyntaxKind::SOURCE_FILE | SyntaxKind::ITEM_LIST | SyntaxKind::STMT_LIST)
}

/// The items of the module or of the block that contains a token.
fn scope_of(at: &SyntaxToken) -> Option<SyntaxNode> {
    at.parent_ancestors().find(is_scope)
}
