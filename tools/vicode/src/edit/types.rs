//! Which types in a text are a component: as far as the text of one file decides it.

use ra_ap_syntax::ast::{self, HasArgList, HasGenericArgs, HasGenericParams, HasName};
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

/// The token before a token, white space and comments left out.
pub(super) fn previous(token: &SyntaxToken) -> Option<SyntaxToken> {
    std::iter::successors(token.prev_token(), SyntaxToken::prev_token).find(|token| !token.kind().is_trivia())
}

/// The token behind a token, white space and comments left out.
pub(super) fn next(token: &SyntaxToken) -> Option<SyntaxToken> {
    std::iter::successors(token.next_token(), SyntaxToken::next_token).find(|token| !token.kind().is_trivia())
}

/// The bracket that opens what a closing one ends.
fn opening(close: &SyntaxToken) -> Option<SyntaxToken> {
    let open = match close.kind() {
        T![')'] => T!['('],
        T![>] => T![<],
        _ => return None,
    };
    let mut depth = 0_usize;
    std::iter::successors(Some(close.clone()), previous).find(|token| {
        depth += usize::from(token.kind() == close.kind());
        depth -= usize::from(token.kind() == open);
        depth == 0
    })
}

impl Types<'_> {
    /// Whether the path or type that ends with a token before `::` is the component.
    pub(super) fn before_colons(&self, last: &SyntaxToken) -> Option<bool> {
        if last.kind() == T![>] {
            let open = opening(last)?;
            let before = previous(&open)?;
            if before.kind() == T![::] || before.kind() == T![:] {
                let before = if before.kind() == T![:] { previous(&before)? } else { before };
                return self.before_colons(&previous(&before)?);
            }
            let end = last.text_range().end();
            let inner: Vec<SyntaxToken> = std::iter::successors(next(&open), next)
                .take_while(|token| token.text_range().end() < end)
                .skip_while(|token| matches!(token.kind(), T![&] | T![mut]))
                .collect();
            let path: Vec<&str> = inner
                .iter()
                .take_while(|token| is_word(token) || matches!(token.kind(), T![::] | T![:]))
                .filter(|token| is_word(token))
                .map(SyntaxToken::text)
                .collect();
            // `<A as Trait>::f` is a function of the trait.
            let of_trait = inner.iter().any(|token| token.kind() == T![as]);
            return if of_trait { Some(false) } else { self.of_path(&path, last) };
        }
        if !is_word(last) {
            return None;
        }
        let mut path = vec![last.clone()];
        let mut at = last.clone();
        while let Some(before) = previous(&at).filter(|before| matches!(before.kind(), T![::] | T![:])) {
            at = before;
            if let Some(word) = previous(&at).filter(is_word) {
                path.insert(0, word.clone());
                at = word;
            }
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
            SyntaxKind::IDENT => {
                let before = previous(last)?;
                match before.kind() {
                    T![.] => self.of_field(last, &previous(&before)?),
                    T![$] | T![::] | T![:] => None,
                    _ => self.of_variable(last),
                }
            }
            T![')'] => {
                let open = opening(last)?;
                let before = previous(&open)?;
                if is_word(&before)
                    && before.kind() != T![self]
                    && !before.kind().is_keyword(ra_ap_syntax::Edition::CURRENT)
                {
                    return self.of_call(&before);
                }
                let inner = std::iter::successors(next(&open), next);
                let inner: Vec<SyntaxToken> = inner
                    .skip_while(|token| matches!(token.kind(), T![&] | T![*] | T![mut]))
                    .take_while(|token| token.text_range().end() < last.text_range().end())
                    .collect();
                if let [value] = &inner[..] { self.of_receiver(value) } else { None }
            }
            kind => kind.is_literal().then_some(false),
        }
    }

    /// `Player::new()`: what a function of that name returns.
    fn of_call(&self, function: &SyntaxToken) -> Option<bool> {
        let colons = previous(function).filter(|before| before.kind() == T![::])?;
        matches!(function.text(), "new" | "default").then(|| self.before_colons(&previous(&colons)?))?
    }

    /// `self.field`
    fn of_field(&self, field: &SyntaxToken, owner: &SyntaxToken) -> Option<bool> {
        if owner.kind() != T![self] {
            return None;
        }
        let of = field.parent_ancestors().find_map(ast::Impl::cast)?.self_ty()?;
        let ast::Type::PathType(path) = of else { return None };
        let name = path.path()?.segment()?.name_ref()?.text().to_string();
        let items = scope_of(field)?;
        let owner = items.children().filter_map(ast::Struct::cast).find(|one| named(one, &name))?;
        let Some(ast::FieldList::RecordFieldList(fields)) = owner.field_list() else { return None };
        self.of(&fields.fields().find(|one| named(one, field.text()))?.ty()?)
    }

    /// A variable: all that its function binds to the name before must agree.
    fn of_variable(&self, variable: &SyntaxToken) -> Option<bool> {
        let function = variable.parent_ancestors().filter_map(ast::Fn::cast).last()?;
        let before = variable.text_range().start();
        let bindings = function.syntax().descendants().filter_map(ast::IdentPat::cast);
        let bindings = bindings.filter(|one| named(one, variable.text()) && one.syntax().text_range().start() < before);
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
            None => self.of_value(binding.initializer()?),
        }
    }

    /// The value of `let a = value`.
    fn of_value(&self, value: ast::Expr) -> Option<bool> {
        match value {
            ast::Expr::RefExpr(inner) => self.of_value(inner.expr()?),
            ast::Expr::ParenExpr(inner) => self.of_value(inner.expr()?),
            ast::Expr::PrefixExpr(inner) => self.of_value(inner.expr()?),
            ast::Expr::Literal(_) | ast::Expr::ArrayExpr(_) | ast::Expr::TupleExpr(_) => Some(false),
            ast::Expr::RecordExpr(record) => self.of_ast_path(&record.path()?),
            ast::Expr::PathExpr(path) => {
                let last = path.syntax().last_token()?;
                if last.kind() == T![self] { self.of_receiver(&last) } else { self.of_unit(&path.path()?) }
            }
            ast::Expr::CallExpr(call) => {
                call.arg_list()?;
                let ast::Expr::PathExpr(callee) = call.expr()? else { return None };
                let path = callee.path()?;
                match path.qualifier() {
                    Some(of) if matches!(path.segment()?.name_ref()?.text(), "new" | "default") => {
                        self.of_ast_path(&of)
                    }
                    _ => self.of_unit(&path),
                }
            }
            _ => None,
        }
    }

    /// `Player` or `Player(1)`: a path whose last word is that of a type.
    fn of_unit(&self, path: &ast::Path) -> Option<bool> {
        let is_type = path.segment()?.name_ref()?.text().starts_with(|first: char| first.is_uppercase());
        is_type.then(|| self.of_ast_path(path))?
    }

    /// Whether a type, references and pointers left out, is the component.
    pub(super) fn of(&self, ty: &ast::Type) -> Option<bool> {
        match ty {
            ast::Type::RefType(inner) => self.of(&inner.ty()?),
            ast::Type::ParenType(inner) => self.of(&inner.ty()?),
            ast::Type::PathType(path) => {
                let segment = path.path()?.segment()?;
                let name = segment.name_ref()?.text().to_string();
                let generic = |node: SyntaxNode| {
                    let of_fn = ast::Fn::cast(node.clone()).and_then(|item| item.generic_param_list());
                    let list = of_fn.or_else(|| ast::Impl::cast(node).and_then(|item| item.generic_param_list()));
                    list.is_some_and(|list| {
                        list.generic_params()
                            .any(|one| one.syntax().first_token().is_some_and(|first| first.text() == name))
                    })
                };
                if path.syntax().ancestors().any(generic) {
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
        if path == ["Self"] {
            let of = at.parent_ancestors().find_map(ast::Impl::cast)?.self_ty()?;
            return self.of(&of);
        }
        self.in_scope(path, &scope_of(at)?, 0)
    }

    fn in_scope(&self, path: &[&str], scope: &SyntaxNode, depth: usize) -> Option<bool> {
        let outer = || scope.ancestors().skip(1).find(is_scope);
        match path {
            _ if depth > 8 => None,
            [] => None,
            ["self", rest @ ..] => self.in_scope(rest, scope, depth + 1),
            ["super", rest @ ..] if outer().is_some() => self.in_scope(rest, &outer()?, depth + 1),
            ["crate" | "super", .., last] => self.by_name(last),
            [name] => self.of_name(name, scope, depth),
            [module, rest @ ..] => {
                let inner = scope.children().filter_map(ast::Module::cast).find(|one| named(one, module));
                match inner.and_then(|module| module.item_list()) {
                    Some(items) => self.in_scope(rest, items.syntax(), depth + 1),
                    None => self.by_name(rest.last()?),
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
                    // `use a::Name` in the module itself must not lead back to it.
                    return if path.len() > 1 { self.in_scope(&path, scope, depth + 1) } else { self.by_name(name) };
                }
            }
        }
        let here = self.is_home && module_of(scope) == self.target.module;
        if here && self.target.names[0] == name { Some(true) } else { self.by_name(name) }
    }

    /// Whether a name that comes from elsewhere is the component's.
    fn by_name(&self, name: &str) -> Option<bool> {
        let is_known = self.target.names.iter().any(|known| known == name);
        if is_known && self.target.has_namesakes { None } else { Some(is_known) }
    }
}

/// The path by which a `use` brings a name.
fn imported(tree: &ast::UseTree, name: &str) -> Option<Vec<String>> {
    if tree.use_tree_list().is_some() || tree.star_token().is_some() {
        return None;
    }
    let words = |tree: &ast::UseTree| -> Vec<String> {
        let path = tree.path().map(|path| path.syntax().text().to_string()).unwrap_or_default();
        path.split("::").map(|word| word.trim().to_owned()).filter(|word| !word.is_empty()).collect()
    };
    let mut path = words(tree);
    let renamed = tree.rename().and_then(|rename| rename.name()).map(|renamed| renamed.text().to_string());
    if renamed.as_ref().or(path.last())? != name {
        return None;
    }
    for outer in tree.syntax().ancestors().skip(1).filter_map(ast::UseTree::cast) {
        path.splice(0..0, words(&outer));
    }
    Some(path)
}

fn named(item: &impl HasName, name: &str) -> bool {
    item.name().is_some_and(|known| known.text() == name)
}

fn is_word(token: &SyntaxToken) -> bool {
    token.kind() == SyntaxKind::IDENT
        || token.kind().is_any_identifier()
        || matches!(token.kind(), T![self] | T![Self] | T![super] | T![crate])
}

fn is_scope(node: &SyntaxNode) -> bool {
    matches!(node.kind(), SyntaxKind::SOURCE_FILE | SyntaxKind::ITEM_LIST)
}

/// The items of the module that contains a token.
fn scope_of(at: &SyntaxToken) -> Option<SyntaxNode> {
    at.parent_ancestors().find(is_scope)
}
