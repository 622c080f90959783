//! An impl block with `#[component]`, read by the grammar of the macros.

use bica_syntax::component::{self as syntax, model};
use bica_syntax::text;
use proc_macro2::{TokenStream, TokenTree};
use syn::{
    AttrStyle, Attribute, FnArg, Ident, ImplItem, ImplItemFn, ItemImpl, MacroDelimiter, Meta, PatType, ReturnType, Type,
};

use super::{Source, docs};
use crate::model::{
    Argument, Arrow, Component, Docs, Function, Hook, HookRole, Input, LinkKind, Modulation, Name, Options, Output,
    Setting, Sources, Span, State, Transition, Work,
};

/// Reads an impl block; `None` if it has no `#[component]` or is one of a trait.
pub(super) fn component(source: &Source<'_>, block: &ItemImpl, module: String) -> Option<Component> {
    let attribute = attribute(block).filter(|_| block.trait_.is_none())?;
    let mut component = Component {
        module,
        name: written(source, &block.self_ty),
        span: source.item(block),
        block: source.within(&block.brace_token.span),
        options: Options {
            span: source.of(attribute),
            list: list(source, attribute),
            settings: settings(source, attribute),
        },
        docs: docs::docs(source, &block.attrs),
        ..Component::default()
    };
    for item in &block.items {
        match item {
            ImplItem::Fn(item) => sort(source, &mut component, item, &block.self_ty),
            ImplItem::Const(item) => component.names.push(source.name(&item.ident)),
            ImplItem::Type(item) => component.names.push(source.name(&item.ident)),
            _ => {}
        }
    }
    if let (true, Some(step)) = (component.docs.text.is_empty(), &component.step) {
        component.docs = Docs { span: None, ..step.docs.clone() };
    }
    Some(component)
}

/// Returns the attribute `#[component]` of a block.
pub(super) fn attribute(block: &ItemImpl) -> Option<&Attribute> {
    block.attrs.iter().find(|one| matches!(one.style, AttrStyle::Outer) && syntax::is_component(one))
}

fn written(source: &Source<'_>, ty: &Type) -> Name {
    Name { text: plain(ty), span: source.of(ty) }
}

/// Formats a type, without the `r#` of raw identifiers.
fn plain(ty: &Type) -> String {
    text::written(ty).replace("r#", "")
}

/// Adds a function to the list of its role, which its first attribute with a role determines.
fn sort(source: &Source<'_>, component: &mut Component, item: &ImplItemFn, own: &Type) {
    let function = function(source, item, own);
    let roles = || item.attrs.iter().filter_map(|one| Some((syntax::role(one)?, one)));
    let Some((role, first)) = roles().find(|(role, _)| *role == "state").or_else(|| roles().next()) else {
        if function.name.text == "step" && component.step.is_none() {
            component.step = Some(function);
        } else {
            component.others.push(function);
        }
        return;
    };
    let attribute = source.of(first);
    let arrows = roles().filter(|(role, _)| *role == "transition").filter_map(|(_, one)| arrow(source, one));
    match role {
        "state" => {
            let words = syntax::state(first).unwrap_or_default();
            let (initial, last, end) = (words.initial.is_some(), words.last, words.end.map(model::End::word));
            component.states.push(State { function, attribute, initial, last, end, arrows: arrows.collect() });
        }
        "transition" => {
            let carries = syntax::carries(&item.sig).map(|of| written(source, of));
            component
                .transitions
                .push(Transition { function: Function { carries, ..function }, arrows: arrows.collect() });
        }
        "output" => {
            let ty = if let ReturnType::Type(_, ty) = &item.sig.output { Some(written(source, ty)) } else { None };
            component.outputs.push(Output {
                function,
                attribute,
                unit: syntax::output(first).unwrap_or_default().0,
                ty,
            });
        }
        "modulation" => component.modulations.push(Modulation { function, attribute }),
        "work" => component.work.push(Work { function, attribute }),
        _ => {
            let roles = [HookRole::Entry, HookRole::Exit, HookRole::Before, HookRole::Start, HookRole::Stop];
            let role = roles.into_iter().find(|one| one.word() == role).unwrap_or(HookRole::Stop);
            let states = names(source, &syntax::hook(first, role.word()).unwrap_or_default());
            component.hooks.push(Hook { function, role, attribute, states, list: list(source, first) });
        }
    }
}

fn names(source: &Source<'_>, idents: &[Ident]) -> Vec<Name> {
    idents.iter().map(|ident| source.name(ident)).collect()
}

/// Reads a function.
fn function(source: &Source<'_>, item: &ImplItemFn, own: &Type) -> Function {
    let name = source.name(&item.sig.ident);
    let arguments = item.sig.inputs.iter().filter_map(|input| match input {
        FnArg::Typed(input) => Some(argument(source, input, own)),
        FnArg::Receiver(_) => None,
    });
    Function {
        span: source.item(item),
        docs: docs::docs(source, &item.attrs),
        inputs: source.within(&item.sig.paren_token.span).unwrap_or(Span::at(name.span.end)),
        arguments: arguments.collect(),
        carries: None,
        body: source.within(&item.block.brace_token.span),
        name,
    }
}

fn argument(source: &Source<'_>, input: &PatType, own: &Type) -> Argument {
    let pattern = source.of(&input.pat);
    let name = pattern.of(source.text);
    let link = |kind, child: &Type| Input::Link { kind, child: plain(child) };
    Argument {
        name: Name { text: name.strip_prefix("r#").unwrap_or(name).to_owned(), span: pattern },
        span: source.of(input),
        written: written(source, &input.ty),
        input: match syntax::meaning(&input.ty, own) {
            Some(model::Argument::Read(child)) => link(LinkKind::Requirement, &child),
            Some(model::Argument::Write(child)) => link(LinkKind::Modulation, &child),
            Some(model::Argument::Rate(child)) => link(LinkKind::Rate, &child),
            Some(model::Argument::OwnRate) => Input::OwnRate,
            Some(model::Argument::Age(of)) => Input::Age { of: plain(&of) },
            Some(model::Argument::Outcome(of)) => Input::Outcome { of: plain(&of) },
            Some(model::Argument::Time(_)) => Input::Time,
            Some(model::Argument::Work(_)) => Input::Work,
            Some(model::Argument::Tuned(of)) => Input::Tuned { parameters: plain(&of) },
            Some(model::Argument::Found(found)) => Input::Found { of: plain(&found.of) },
            None => Input::Other,
        },
    }
}

/// Returns the span between the parentheses of an attribute.
fn list(source: &Source<'_>, attribute: &Attribute) -> Option<Span> {
    let Meta::List(list) = &attribute.meta else { return None };
    let brackets = match &list.delimiter {
        MacroDelimiter::Paren(brackets) => brackets.span,
        MacroDelimiter::Brace(brackets) => brackets.span,
        MacroDelimiter::Bracket(brackets) => brackets.span,
    };
    source.within(&brackets)
}

/// Returns the tokens between the parentheses of an attribute.
fn tokens(attribute: &Attribute) -> Vec<TokenTree> {
    let list = attribute.meta.require_list();
    list.map(|list| list.tokens.clone()).unwrap_or_default().into_iter().collect()
}

fn is(token: &TokenTree, sign: char) -> bool {
    matches!(token, TokenTree::Punct(mark) if mark.as_char() == sign)
}

/// Returns the span from the first to the last token.
fn around(source: &Source<'_>, tokens: &[TokenTree]) -> Option<Span> {
    Some(Span::new(source.of(tokens.first()?).start, source.of(tokens.last()?).end))
}

/// `key = value, key`
pub(super) fn settings(source: &Source<'_>, attribute: &Attribute) -> Vec<Setting> {
    let setting = |part: &[TokenTree]| {
        let (span, first) = (around(source, part)?, part.first()?);
        let value = part.get(1).filter(|token| is(token, '=')).and_then(|_| around(source, &part[2..]));
        let value = value.map(|span| Name { text: span.of(source.text).to_owned(), span });
        Some(Setting { span, key: Name { text: first.to_string(), span: source.of(first) }, value })
    };
    tokens(attribute).split(|token| is(token, ',')).filter_map(setting).collect()
}

/// `a | b -> c, after_ms = N, when = done(Reach)`
fn arrow(source: &Source<'_>, attribute: &Attribute) -> Option<Arrow> {
    let model::Arrow { from, to, guard } = syntax::transition(attribute).ok()?;
    let tokens = tokens(attribute);
    let from_end = tokens.iter().position(|token| is(token, '-'))?;
    // The place of a key, with the comma before it.
    let place = |key: &str| {
        let is_key = |at: &usize| is(&tokens[*at], ',') && tokens.get(at + 1).is_some_and(|one| one.to_string() == key);
        let comma = (0..tokens.len()).find(is_key)?;
        let length = tokens[comma + 1..].iter().position(|token| is(token, ','));
        around(source, &tokens[comma..length.map_or(tokens.len(), |length| comma + 1 + length)])
    };
    let (after_ms, after) = match guard.timer {
        None => (None, None),
        Some(model::Timer::Ms(ms)) => (Some(ms), None),
        Some(model::Timer::Parameter(timer)) => (None, Some(timer.to_string())),
    };
    Some(Arrow {
        span: source.of(attribute),
        list: list(source, attribute)?,
        from: match from {
            model::Sources::Any => Sources::Any,
            model::Sources::These(states) => Sources::These(names(source, &states)),
        },
        from_span: around(source, &tokens[..from_end])?,
        to: source.name(&to),
        after_ms: after_ms.zip(place("after_ms")),
        after: after.zip(place("after")),
        when: guard.when.map(|when| when.to_string()).zip(place("when")),
        times: guard.times.zip(place("times")),
    })
}

/// Returns the input of the macro: the options, and the block without the attribute.
pub(super) fn input(block: &ItemImpl) -> Option<(TokenStream, ItemImpl)> {
    let own = attribute(block)?;
    let mut item = block.clone();
    item.attrs.remove(block.attrs.iter().position(|one| std::ptr::eq(one, own))?);
    Some((tokens(own).into_iter().collect(), item))
}
