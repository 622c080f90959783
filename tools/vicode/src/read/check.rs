//! Rules of the macros, checked by the macros' own code.

use bica_syntax::component::{check as component_check, parse as component_parse};
use bica_syntax::params::parse as params_parse;
use bica_syntax::report::Report;
use bica_syntax::role;
use bica_syntax::tree::{check as tree_check, parse as tree_parse};
use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::{Item, Macro};

use super::component::input;
use super::params::derives;
use super::trees::is_tree;
use super::{Node, Outline};
use crate::model::{Component, Problem, Reporter, Span};

/// Adds the mistakes that the macros would report for the components, parameters and trees of a file.
pub(super) fn check(outline: &Outline<'_>, components: &[Component], problems: &mut Vec<Problem>) {
    let source = outline.source;
    // The macros do not read the bodies of functions.
    let bodies: Vec<Span> =
        components.iter().flat_map(Component::functions).filter_map(|function| function.body).collect();
    let is_read = |omitted: &&Span| !bodies.iter().any(|body| body.contains(**omitted));
    let omitted: Vec<&Span> = source.omitted.iter().filter(is_read).collect();
    let items = outline.regions.iter().filter_map(|region| match region.node {
        Node::Item(item) => Some((region.span, of_item(item)?)),
        _ => None,
    });
    let mut reports: Vec<(Span, Report)> = items.collect();
    let trees = outline.macros.iter().filter_map(|call| Some((source.of(&call.tokens), of_tree(call)?)));
    reports.extend(trees);
    for (place, report) in reports.iter().filter(|(place, _)| !omitted.iter().any(|part| place.contains(**part))) {
        problems.extend(report.mistakes().iter().map(|mistake| {
            let found = source.of(&mistake.error.span());
            let span = if place.contains(found) && found.start < found.end { found } else { *place };
            let message = mistake.error.to_string();
            Problem { span, message, from: Reporter::Macro, code: mistake.code.clone() }
        }));
    }
}

/// Runs the rules of the macro of an item; `None` if it has none.
fn of_item(item: &Item) -> Option<Report> {
    let mut report = Report::default();
    match item {
        Item::Impl(block) => {
            let (options, block) = input(block)?;
            let parsed = component_parse::parse(options, &block.to_token_stream(), &mut report);
            if let component_parse::Parsed::Component(component) = parsed {
                component_check::check(&component, &mut report);
            }
        }
        Item::Struct(item) if derives(&item.attrs, "Params") => {
            params_parse::params(item.to_token_stream(), &mut report);
        }
        Item::Trait(item) if item.attrs.iter().any(|one| one.path().is_ident("role")) => {
            let mut item = item.clone();
            item.attrs.retain(|one| !one.path().is_ident("role"));
            role::parse(TokenStream::new(), &item.to_token_stream(), &mut report);
        }
        Item::Enum(item) if derives(&item.attrs, "ParamEnum") => {
            params_parse::choice(item.to_token_stream(), &mut report);
        }
        _ => return None,
    }
    Some(report)
}

/// Runs the rules of `activation_tree!`.
fn of_tree(call: &Macro) -> Option<Report> {
    let mut report = Report::default();
    let draft = is_tree(call).then(|| tree_parse::parse(call.tokens.clone(), &mut report))?;
    draft.and_then(|draft| tree_check::check(&draft, &mut report));
    Some(report)
}
