//! From an impl block to a model of it.

use proc_macro2::TokenStream;
use syn::{Attribute, ImplItem, ImplItemFn, ItemImpl, Type, parse_quote};

use super::model::{Component, Function, Hook, State, Transition};
use super::signature::{self, Form};
use super::{attributes, options};
use crate::language::report::Report;
use crate::language::{text, wording};

/// Reads the impl block; `None` if it is none.
pub(crate) fn parse(options: TokenStream, item: &TokenStream, report: &mut Report) -> Option<Component> {
    let Ok(mut item) = syn::parse2::<ItemImpl>(item.clone()) else {
        report.add(item, wording::NO_IMPL);
        return None;
    };
    if let Some((path, _)) = &item.trait_ {
        report.add(path, wording::TRAIT_IMPL);
        return None;
    }
    if !matches!(&*item.self_ty, Type::Path(_)) {
        report.add(&item.self_ty, wording::NOT_A_NAME);
        return None;
    }
    for lifetime in item.generics.lifetimes() {
        report.add(lifetime, wording::LIFETIME);
    }
    let options = options::parse(options, report);
    let doc = text::doc(&item.attrs);
    item.attrs.push(parse_quote!(#[allow(clippy::new_without_default, reason = "a tree makes it by `new`")]));
    let mut component = Component {
        item,
        options,
        doc,
        step: None,
        states: Vec::new(),
        transitions: Vec::new(),
        entries: Vec::new(),
        exits: Vec::new(),
        starts: Vec::new(),
        stops: Vec::new(),
        gaps: false,
    };
    functions(&mut component, report);
    Some(component)
}

/// Sorts the functions by their roles and takes our attributes off.
fn functions(component: &mut Component, report: &mut Report) {
    let mut items = std::mem::take(&mut component.item.items);
    for item in &mut items {
        let ImplItem::Fn(function) = item else { continue };
        let (ours, others): (Vec<_>, Vec<_>) = std::mem::take(&mut function.attrs)
            .into_iter()
            .partition(|attribute| attributes::role(attribute).is_some());
        function.attrs = others;
        sort(component, function, ours, report);
    }
    component.item.items = items;
}

fn sort(component: &mut Component, function: &mut ImplItemFn, roles: Vec<Attribute>, report: &mut Report) {
    let Some(first) = roles.first() else {
        if function.sig.ident == "step" {
            component.step = Some(called(component, function, Form::Step, report));
            if component.doc.is_empty() {
                component.doc = text::doc(&function.attrs);
            }
        }
        return;
    };
    let role = attributes::role(first);
    for other in &roles[1..] {
        if attributes::role(other) != role {
            report.add(other, wording::TWO_ROLES);
        } else if role != Some("transition") {
            report.add(other, wording::TWICE);
        }
    }
    match role {
        Some("state") => state(component, function, first, report),
        Some("transition") => transitions(component, function, roles, report),
        Some("start") => {
            let function = called(component, function, Form::Plain, report);
            component.starts.push(function);
        }
        Some("stop") => {
            let function = called(component, function, Form::Plain, report);
            component.stops.push(function);
        }
        _ => hook(component, function, first, report),
    }
}

fn state(component: &mut Component, function: &mut ImplItemFn, attribute: &Attribute, report: &mut Report) {
    let words = report.take(attributes::state(attribute));
    component.gaps |= words.is_none();
    let (initial, last) = words.unwrap_or_default();
    let function = called(component, function, Form::Step, report);
    component.states.push(State { function, initial, last });
}

fn transitions(component: &mut Component, function: &mut ImplItemFn, all: Vec<Attribute>, report: &mut Report) {
    let function = called(component, function, Form::Condition, report);
    for attribute in all.into_iter().filter(|attribute| attributes::role(attribute) == Some("transition")) {
        let Some(arrow) = report.take(attributes::transition(&attribute)) else {
            component.gaps = true;
            continue;
        };
        let attributes::Arrow { from, to, after_ms } = arrow;
        component.transitions.push(Transition { function: function.clone(), from, to, after_ms, attribute });
    }
}

fn hook(component: &mut Component, function: &mut ImplItemFn, attribute: &Attribute, report: &mut Report) {
    let function = called(component, function, Form::Step, report);
    let Some(states) = report.take(attributes::hook(attribute)) else { return };
    let hooks = if attribute.path().is_ident("entry") { &mut component.entries } else { &mut component.exits };
    hooks.push(Hook { function, states });
}

/// Reads the signature, and spares its author lints that its form, given by its role, would raise.
///
/// On bare metal what runs stays a call of its own: inlined into the visit, its variables would lie on the stack while
/// the children are visited, and a tree as deep as its longest chain would need the stack of all of them at once.
fn called(component: &Component, function: &mut ImplItemFn, form: Form, report: &mut Report) -> Function {
    let arguments = signature::read(&function.sig, &component.item.self_ty, form, report);
    for condition in function.attrs.iter().filter(|attribute| attribute.path().is_ident("cfg")) {
        report.add(condition, wording::CONDITIONAL);
    }
    let doc = text::doc(&function.attrs);
    function.attrs.push(parse_quote!(#[allow(
        unused_variables,
        clippy::needless_pass_by_ref_mut,
        clippy::too_many_arguments,
        clippy::trivially_copy_pass_by_ref,
        clippy::unused_self,
        reason = "an argument is a link, whether the function looks at it or not"
    )]));
    if form == Form::Step && !function.attrs.iter().any(|attribute| attribute.path().is_ident("inline")) {
        function.attrs.push(parse_quote!(#[cfg_attr(target_os = "none", inline(never))]));
    }
    Function { name: function.sig.ident.clone(), doc, arguments }
}
