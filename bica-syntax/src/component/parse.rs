//! From an impl block to a model of it.

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::punctuated::Punctuated;
use syn::{Attribute, Generics, Item as AnyItem, Token, Type, TypeParamBound, WherePredicate, parse_quote};

use super::arguments::{self, Form};
use super::attributes::StateWords;
use super::block::{self, Block, Item};
use super::model::{Component, Function, Hook, State, Transition};
use super::{attributes, completion, found, operator, options, roles, signature, work};
use crate::report::Report;
use crate::types::{lifetimes, plain};
use crate::{text, wording};

/// What an item with `#[component]` turned out to be.
pub enum Parsed {
    /// An impl block of a type.
    Component(Box<Component>),
    /// No impl block of a type. The item without our attributes, and the type that was meant to be a component.
    Misplaced {
        /// The item without our attributes.
        item: TokenStream,
        /// The type that was meant to be a component.
        of: Option<Box<(Generics, Type)>>,
    },
}

/// Reads the item.
pub fn parse(options: TokenStream, item: &TokenStream, report: &mut Report) -> Parsed {
    let Some(mut block) = Block::read(item) else { return no_block(item, report) };
    *block.header.self_ty = plain(&block.header.self_ty).clone();
    let own = &block.header.self_ty;
    let name = component_name(own);
    if is_of_nobody(own, &block.header.generics) {
        report.add(own, wording::NOT_A_NAME);
        // The compiler would refuse the block, and what makes a component of it, once more.
        return Parsed::Misplaced { item: TokenStream::new(), of: None };
    }
    let misplaced = match (&block.header.trait_, &name) {
        (Some((path, _)), _) => Some((path.to_token_stream(), wording::TRAIT_IMPL.to_owned())),
        (None, None) => Some((own.to_token_stream(), wording::NOT_A_NAME.to_owned())),
        (None, Some(name))
            if matches!(name.as_str(), "Time" | "Rate" | "Age" | "Outcome" | "Tuned" | "Found" | "Work") =>
        {
            Some((own.to_token_stream(), wording::reserved(name)))
        }
        _ => None,
    };
    let options = options::parse(options, report);
    let doc = text::doc(&block.header.attrs);
    let mut component = Component {
        block,
        options,
        doc,
        step: None,
        states: Vec::new(),
        transitions: Vec::new(),
        entries: Vec::new(),
        exits: Vec::new(),
        hooks_before: Vec::new(),
        starts: Vec::new(),
        stops: Vec::new(),
        outputs: Vec::new(),
        modulations: Vec::new(),
        work: None,
        incomplete: false,
    };
    if let Some((at, problem)) = misplaced {
        return without_roles(component, at, &problem, report);
    }
    for second in component.block.header.attrs.extract_if(.., |one| attributes::is_component(one)) {
        report.add(second, wording::TWICE);
    }
    let unnamed = lifetimes(component.own()).filter(|lifetime| lifetime.ident == "_").map(ToTokens::to_token_stream);
    let named = component.block.header.generics.lifetimes().map(ToTokens::to_token_stream);
    for lifetime in named.chain(unnamed) {
        report.add(lifetime, wording::LIFETIME);
    }
    for lifetime in lifetimes(component.own()).filter(|lifetime| lifetime.ident == "static") {
        report.add(lifetime, wording::STATIC);
    }
    without_unsized(&mut component.block.header.generics, report);
    let reason = parse_quote!(#[allow(clippy::new_without_default, reason = "a tree makes it by `new`")]);
    component.block.header.attrs.push(reason);
    functions(&mut component, report);
    Parsed::Component(Box::new(component))
}

/// A block that makes no component; it loses our attributes.
fn without_roles(mut component: Component, at: TokenStream, problem: &str, report: &mut Report) -> Parsed {
    functions(&mut component, &mut Report::default());
    report.add(at, problem);
    let of_a_trait = component.block.header.trait_.is_some();
    let meant = component_name(component.own()).is_some() && (!of_a_trait || component.functions().next().is_some());
    let of = meant.then(|| Box::new((component.block.header.generics.clone(), component.own().clone())));
    // The compiler would refuse the block of another type once more.
    let is_type = of_a_trait || component_name(component.own()).is_some();
    let item = if is_type { component.block.to_token_stream() } else { TokenStream::new() };
    Parsed::Misplaced { item, of }
}

/// Takes off each bound `?Sized`, so that the compiler reports no further ones.
fn without_unsized(generics: &mut Generics, report: &mut Report) {
    let mut sized = |bounds: &mut Punctuated<TypeParamBound, Token![+]>| {
        let (wrong, rest): (Vec<_>, Vec<_>) =
            std::mem::take(bounds).into_iter().partition(|bound| text::written(bound).starts_with('?'));
        for bound in wrong {
            report.add(bound, wording::NO_SIZE_BOUND);
        }
        *bounds = rest.into_iter().collect();
    };
    generics.type_params_mut().for_each(|parameter| sized(&mut parameter.bounds));
    for predicate in generics.where_clause.iter_mut().flat_map(|clause| &mut clause.predicates) {
        if let WherePredicate::Type(predicate) = predicate {
            sized(&mut predicate.bounds);
        }
    }
}

/// Whether a type is written as one of the language or a type parameter, of which nobody can make a component.
fn is_of_nobody(own: &Type, generics: &Generics) -> bool {
    let Type::Path(path) = own else { return false };
    let Some(name) = path.path.get_ident() else { return false };
    name == "String" || arguments::is_value(name) || generics.type_params().any(|parameter| parameter.ident == *name)
}

fn component_name(own: &Type) -> Option<String> {
    let Type::Path(path) = own else { return None };
    path.path.segments.last().map(|last| text::name(&last.ident))
}

fn no_block(item: &TokenStream, report: &mut Report) -> Parsed {
    let (at, of) = match syn::parse2::<AnyItem>(item.clone()) {
        Ok(AnyItem::Struct(item)) => (item.ident.to_token_stream(), Some((item.generics, item.ident))),
        Ok(AnyItem::Enum(item)) => (item.ident.to_token_stream(), Some((item.generics, item.ident))),
        _ => (item.clone(), None),
    };
    report.add(at, wording::NO_IMPL);
    let of = of.map(|(generics, name)| {
        let arguments = generics.split_for_impl().1;
        let own = parse_quote!(#name #arguments);
        Box::new((generics, own))
    });
    Parsed::Misplaced { item: item.clone(), of }
}

/// Sorts the functions by their roles and takes our attributes off.
fn functions(component: &mut Component, report: &mut Report) {
    component.incomplete |= component.block.unreadable;
    let mut items = std::mem::take(&mut component.block.items);
    let twice = twice(&items);
    let mut reported = false;
    for item in &mut items {
        match item {
            Item::Function(function) => {
                let name = text::name(&function.signature.ident);
                let ours = take_ours(component, function, report);
                if !ours.iter().any(|one| roles::role(one) == Some("modulation")) {
                    operator::no_keys(function, report);
                }
                let is_called = name == "step" || !ours.is_empty();
                match twice.iter().find(|(other, _)| *other == name) {
                    Some((_, condition)) if is_called => {
                        component.incomplete = true;
                        if !std::mem::replace(&mut reported, true)
                            && let Some(condition) = condition
                        {
                            report.add(condition, wording::two_functions(&name));
                        }
                    }
                    _ => sort(component, function, ours, report),
                }
            }
            Item::Other { attributes, .. } => {
                for attribute in attributes.extract_if(.., |one| roles::role(one).is_some()) {
                    component.incomplete = true;
                    report.add(&attribute, wording::PLACE_OF_A_ROLE);
                }
            }
        }
    }
    component.block.items = items;
}

/// The names that several functions have, each with a condition of one of them. Without a condition the compiler reports
/// them.
fn twice(items: &[Item]) -> Vec<(String, Option<Attribute>)> {
    let mut names: Vec<(String, usize, Option<Attribute>)> = Vec::new();
    for item in items {
        let Item::Function(function) = item else { continue };
        let name = text::name(&function.signature.ident);
        let condition = function.attributes.iter().find(|one| attributes::is_condition(one)).cloned();
        match names.iter_mut().find(|(other, ..)| *other == name) {
            Some((_, count, first)) => {
                *count += 1;
                *first = first.take().or(condition);
            }
            None => names.push((name, 1, condition)),
        }
    }
    names.into_iter().filter(|(_, count, _)| *count > 1).map(|(name, _, condition)| (name, condition)).collect()
}

/// Takes our attributes off, and those that were meant to be ours.
fn take_ours(component: &mut Component, function: &mut block::Function, report: &mut Report) -> Vec<Attribute> {
    for attribute in function.attributes.extract_if(.., |one| attributes::misspelt(one).is_some()) {
        component.incomplete = true;
        if let Some(mistake) = attributes::misspelt(&attribute) {
            report.push(mistake);
        }
    }
    for attribute in function.attributes.extract_if(.., |one| attributes::conditional_role(one)) {
        component.incomplete = true;
        report.add(attribute, wording::CONDITIONAL);
    }
    function.attributes.extract_if(.., |one| roles::role(one).is_some()).collect()
}

fn sort(component: &mut Component, function: &mut block::Function, mut roles: Vec<Attribute>, report: &mut Report) {
    // Of several roles only the one that fits the signature is read, so each of the others gives one error.
    let is_condition =
        signature::is_condition(&function.signature) && !roles.iter().any(|one| roles::role(one) == Some("state"));
    roles.sort_by_key(|one| (roles::role(one) == Some("transition")) != is_condition);
    let Some(first) = roles.first() else {
        if text::name(&function.signature.ident) == "step" {
            component.step = Some(called(component, function, Form::Step, report));
            if component.doc.is_empty() {
                component.doc = text::doc(&function.attributes);
            }
        }
        return;
    };
    let role = roles::role(first);
    for other in &roles[1..] {
        if roles::role(other) == Some("transition") && matches!(role, Some("state" | "transition")) {
            continue;
        }
        component.incomplete = true;
        let problem = match roles::role(other) {
            Some(same) if Some(same) == role => wording::role_twice(same),
            _ => wording::TWO_ROLES.to_owned(),
        };
        report.add(other, problem);
    }
    if let Some(role @ ("output" | "modulation" | "work")) = role
        && text::name(&function.signature.ident) == "step"
    {
        component.incomplete = true;
        return report.add(first, wording::role_of_step(role));
    }
    match role {
        Some("state") => state(component, function, roles, report),
        Some("transition") => transitions(component, function, roles, report),
        Some(role @ ("start" | "stop")) => {
            report.take(attributes::bare(first, role));
            let function = called(component, function, Form::Plain, report);
            let hooks = if role == "start" { &mut component.starts } else { &mut component.stops };
            hooks.push(function);
        }
        Some("output") => {
            let output = operator::output(function, first, component.own(), report);
            component.outputs.extend(output);
        }
        Some("modulation") => {
            let own = component.own().clone();
            component.modulations.extend(operator::modulation(function, first, &own, report));
        }
        Some("work") => work(component, function, first, report),
        _ => hook(component, function, first, report),
    }
}

fn work(component: &mut Component, function: &mut block::Function, attribute: &Attribute, report: &mut Report) {
    for condition in function.attributes.extract_if(.., |one| attributes::is_condition(one)) {
        report.add(condition, wording::CONDITIONAL);
    }
    if component.work.is_some() {
        component.incomplete = true;
        return report.add(attribute, wording::WORK_TWICE);
    }
    let read = work::read(function, attribute, report);
    component.incomplete |= read.is_none();
    if read.is_none() {
        work::without_borrowed(&mut function.signature);
    }
    component.work = read;
}

fn state(component: &mut Component, function: &mut block::Function, all: Vec<Attribute>, report: &mut Report) {
    let words = all.first().and_then(|attribute| report.take(attributes::state(attribute)));
    component.incomplete |= words.is_none();
    let StateWords { initial, last, end } = words.unwrap_or_default();
    let function = called(component, function, Form::Step, report);
    component.states.push(State { function: function.clone(), initial, last, end });
    arrows(component, &function, true, all, report);
}

fn transitions(component: &mut Component, function: &mut block::Function, all: Vec<Attribute>, report: &mut Report) {
    let is_readable = signature::is_condition(&function.signature);
    let function = called(component, function, Form::Condition, report);
    // What it carries is then not known.
    component.incomplete |= !is_readable;
    arrows(component, &function, false, all, report);
}

/// Reads the attributes `#[transition]` of a condition or, `bare`, of a state.
fn arrows(component: &mut Component, function: &Function, bare: bool, all: Vec<Attribute>, report: &mut Report) {
    for attribute in all.into_iter().filter(|attribute| roles::role(attribute) == Some("transition")) {
        let Some(mut arrow) = report.take(attributes::transition(&attribute)) else {
            component.incomplete = true;
            continue;
        };
        arrow.guard.bare = bare;
        component.transitions.push(Transition { function: function.clone(), arrow, attribute });
    }
}

fn hook(component: &mut Component, function: &mut block::Function, attribute: &Attribute, report: &mut Report) {
    let role = roles::role(attribute).unwrap_or_default();
    let form = if role == "entry" { Form::Entry } else { Form::Step };
    let takes = found::is_taken(&function.signature);
    if role == "before" {
        signature::writes(&mut function.signature, component.own(), report);
    }
    let function = called(component, function, form, report);
    component.incomplete |= takes && function.found().is_none();
    let Some(states) = report.take(attributes::hook(attribute, role)) else {
        component.incomplete = true;
        return;
    };
    let hooks = match role {
        "entry" => &mut component.entries,
        "exit" => &mut component.exits,
        _ => &mut component.hooks_before,
    };
    hooks.push(Hook { function, states, attribute: attribute.clone() });
}

/// Reads the signature, and spares its author lints that its form, given by its role, would raise.
///
/// On bare metal the function stays a call of its own: inlined into the visit, its variables would lie on the stack
/// while the children are visited, and a tree as deep as its longest chain would need the stack of all of them at once.
fn called(component: &Component, function: &mut block::Function, form: Form, report: &mut Report) -> Function {
    let (arguments, carries) = signature::read(&function.signature, component.own(), form, report);
    for argument in &arguments {
        arguments::concrete(argument, &component.block.header.generics, report);
    }
    completion::complete_rates(&mut function.signature);
    for condition in function.attributes.extract_if(.., |one| attributes::is_condition(one)) {
        report.add(condition, wording::CONDITIONAL);
    }
    let attributes = &mut function.attributes;
    let doc = text::doc(attributes);
    attributes.push(parse_quote!(#[allow(
        unused_variables,
        clippy::needless_pass_by_ref_mut,
        clippy::too_many_arguments,
        clippy::trivially_copy_pass_by_ref,
        clippy::unused_self,
        reason = "an argument is a link, whether the function reads it or not"
    )]));
    if carries.is_some() {
        let reason = "the state that it enters takes a value, also if a timer is the whole condition";
        attributes.push(parse_quote!(#[allow(clippy::unnecessary_wraps, reason = #reason)]));
    }
    if matches!(form, Form::Step | Form::Entry)
        && !attributes.iter().any(|attribute| attribute.path().is_ident("inline"))
    {
        attributes.push(parse_quote!(#[cfg_attr(target_os = "none", inline(never))]));
    }
    Function { name: function.signature.ident.clone(), doc, arguments, carries: carries.map(Box::new) }
}
