//! An impl block with `#[component]`.

use bica_syntax::component::ROLES;
use ra_ap_syntax::AstNode;
use ra_ap_syntax::ast::{self, HasAttrs, HasName};

use super::attributes::{self, Attribute};
use super::tokens::{name, tokens, written};
use super::{docs, function, span};
use crate::model::{
    Component, Docs, Function, Hook, HookRole, Info, Modulation, Name, Options, Span, State, Transition,
};

/// Reads an impl block; `None` if it has no `#[component]` or is one of a trait.
pub(super) fn component(block: &ast::Impl, text: &str) -> Option<Component> {
    let attribute = component_attribute(block)?;
    if block.for_token().is_some() {
        return None;
    }
    let ty = block.self_ty()?;
    let own = Name { text: written(&tokens(ty.syntax())), span: span(ty.syntax().text_range()) };
    let list = block.assoc_item_list();
    let braces = list.as_ref().filter(|list| list.r_curly_token().is_some() && list.l_curly_token().is_some());
    let braces = braces.map(|list| span(list.syntax().text_range()));
    let mut component = Component {
        module: super::module_of(block.syntax()),
        name: own,
        span: span(block.syntax().text_range()),
        block: braces.map(|span| Span::new(span.start + 1, span.end - 1)),
        options: options(&attribute, text),
        docs: docs::docs(block),
        ..Component::default()
    };
    for item in list.iter().flat_map(ast::AssocItemList::assoc_items) {
        match item {
            ast::AssocItem::Fn(item) => sort(&mut component, &item),
            ast::AssocItem::Const(item) => component.names.extend(item_name(&item)),
            ast::AssocItem::TypeAlias(item) => component.names.extend(item_name(&item)),
            ast::AssocItem::MacroCall(_) => {}
        }
    }
    if let (true, Some(step)) = (component.docs.text.is_empty(), &component.step) {
        component.docs = Docs { span: None, ..step.docs.clone() };
    }
    Some(component)
}

fn item_name(item: &impl HasName) -> Option<Name> {
    item.name().map(|ident| name(ident.text(), span(ident.syntax().text_range())))
}

/// The attribute `#[component]` of a block.
pub(super) fn component_attribute(block: &ast::Impl) -> Option<Attribute> {
    block.attrs().filter_map(|one| attributes::attribute(&one)).find(|one| one.name == "component")
}

fn options(attribute: &Attribute, text: &str) -> Options {
    let list = attribute.list.as_ref();
    let settings = list.map(|(_, tokens)| attributes::settings(tokens, text)).unwrap_or_default();
    Options { span: attribute.span, list: list.map(|(span, _)| *span), settings }
}

/// Sorts a function by its role, which its first attribute with a role assigns.
fn sort(component: &mut Component, item: &ast::Fn) {
    let Some(function) = function::function(item, &component.name.text) else { return };
    let all: Vec<Attribute> = item.attrs().filter_map(|one| attributes::attribute(&one)).collect();
    let Some(first) = all.iter().find(|one| ROLES.contains(&&*one.name)) else {
        if function.name.text == "step" && component.step.is_none() {
            component.step = Some(function);
        } else {
            component.others.push(function);
        }
        return;
    };
    match first.name.as_str() {
        "state" => component.states.push(state(function, first)),
        "transition" => {
            let arrows = all.iter().filter(|one| one.name == "transition").filter_map(attributes::arrow).collect();
            component.transitions.push(Transition { function, arrows });
        }
        "info" => component.info.push(info(function, first, item)),
        "modulation" => component.modulations.push(Modulation { function, attribute: first.span }),
        other => component.hooks.push(hook(function, other, first)),
    }
}

fn state(function: Function, attribute: &Attribute) -> State {
    let words = attribute.list.as_ref().map(|(_, tokens)| attributes::names(tokens)).unwrap_or_default();
    let has = |word: &str| words.iter().any(|one| one.text == word);
    State { function, attribute: attribute.span, initial: has("initial"), last: has("last") }
}

fn hook(function: Function, role: &str, attribute: &Attribute) -> Hook {
    let roles = [HookRole::Entry, HookRole::Exit, HookRole::Start, HookRole::Stop];
    let role = roles.into_iter().find(|one| one.word() == role).unwrap_or(HookRole::Stop);
    let states = attribute.list.as_ref().map(|(_, tokens)| attributes::names(tokens)).unwrap_or_default();
    Hook { function, role, attribute: attribute.span, states, list: attribute.list.as_ref().map(|(span, _)| *span) }
}

fn info(function: Function, attribute: &Attribute, item: &ast::Fn) -> Info {
    let tokens_of = |ty: &ast::Type| written(&tokens(ty.syntax()));
    let ty = item.ret_type().and_then(|ret| ret.ty());
    let ty = ty.map(|ty| Name { text: tokens_of(&ty), span: span(ty.syntax().text_range()) });
    let unit = attribute.list.as_ref().and_then(|(_, tokens)| tokens.get(2));
    let unit = unit.map(|token| token.name.text.trim_matches('"').to_owned());
    Info { function, attribute: attribute.span, unit, ty }
}
