//! The rules of the macros, by the macros' own code.

use std::str::FromStr;

use bica_syntax::component::{check as component_check, parse as component_parse};
use bica_syntax::params::parse as params_parse;
use bica_syntax::report::Report;
use bica_syntax::tree::{check as tree_check, parse as tree_parse};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use ra_ap_syntax::{AstNode, SyntaxNode, ast};

use super::block::component_attribute;
use super::params::derives;
use super::span;
use crate::model::{Problem, Reporter, Span};

/// Adds what the macros would report about the components, the parameters and the trees of a file.
pub(super) fn check(root: &SyntaxNode, text: &str, problems: &mut Vec<Problem>) {
    for node in root.descendants() {
        let place = span(node.text_range());
        if let Some(block) = ast::Impl::cast(node.clone()) {
            if component_attribute(&block).is_some() {
                report(place, text, problems, component);
            }
        } else if let Some(item) = ast::Struct::cast(node.clone()) {
            if derives(&item, "Params") {
                report(place, text, problems, |tokens, report| drop(params_parse::params(tokens, report)));
            }
        } else if let Some(item) = ast::Enum::cast(node.clone()) {
            if derives(&item, "ParamEnum") {
                report(place, text, problems, |tokens, report| drop(params_parse::choice(tokens, report)));
            }
        } else if let Some(call) = ast::MacroCall::cast(node)
            && let Some(place) = tree_of(&call)
        {
            report(place, text, problems, tree);
        }
    }
    // The texts that this thread has read are kept for their spans until here.
    proc_macro2::extra::invalidate_current_thread_spans();
}

/// What stands in the brackets of `activation_tree!`.
fn tree_of(call: &ast::MacroCall) -> Option<Span> {
    let name = call.path()?.segment()?.name_ref()?;
    if name.text() != "activation_tree" {
        return None;
    }
    let place = span(call.token_tree()?.syntax().text_range());
    Some(Span::new(place.start + 1, place.end.saturating_sub(1).max(place.start + 1)))
}

/// Runs a macro's rules on a part of the text. What is not even a list of tokens is the parser's to report.
fn report(place: Span, text: &str, problems: &mut Vec<Problem>, rules: impl FnOnce(TokenStream, &mut Report)) {
    let Ok(tokens) = TokenStream::from_str(place.of(text)) else { return };
    let mut report = Report::default();
    rules(tokens, &mut report);
    for error in report.errors() {
        let range = error.span().byte_range();
        let found = Span::new(place.start + range.start, place.start + range.end);
        let at = if place.contains(found) && !range.is_empty() { found } else { place };
        problems.push(Problem { span: at, message: error.to_string(), from: Reporter::Macro });
    }
}

fn component(tokens: TokenStream, report: &mut Report) {
    let (options, item) = without_component(tokens);
    if let component_parse::Parsed::Component(component) = component_parse::parse(options, &item, report) {
        component_check::check(&component, report);
    }
}

fn tree(tokens: TokenStream, report: &mut Report) {
    if let Some(draft) = tree_parse::parse(tokens, report) {
        tree_check::check(&draft, report);
    }
}

/// Takes the first `#[component(...)]` off an item: the options, and the rest.
fn without_component(tokens: TokenStream) -> (TokenStream, TokenStream) {
    let mut options = None;
    let mut rest: Vec<TokenTree> = Vec::new();
    for token in tokens {
        if let (TokenTree::Group(group), None) = (&token, &options)
            && group.delimiter() == Delimiter::Bracket
            && let Some(found) = component_options(group.stream())
        {
            options = Some(found);
            rest.pop();
            continue;
        }
        rest.push(token);
    }
    (options.unwrap_or_default(), rest.into_iter().collect())
}

/// What stands in the parentheses of `component(...)`.
fn component_options(attribute: TokenStream) -> Option<TokenStream> {
    let mut tokens: Vec<TokenTree> = attribute.into_iter().collect();
    let list = match tokens.pop()? {
        TokenTree::Group(group) => {
            let list = group.stream();
            return matches!(tokens.pop()?, TokenTree::Ident(name) if name == "component").then_some(list);
        }
        TokenTree::Ident(name) if name == "component" => TokenStream::new(),
        _ => return None,
    };
    Some(list)
}
