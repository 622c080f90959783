//! The rules of the macros, by the macros' own code.

use bica_syntax::component::{check as component_check, parse as component_parse};
use bica_syntax::params::parse as params_parse;
use bica_syntax::report::Report;
use bica_syntax::tree::{check as tree_check, parse as tree_parse};
use ra_ap_syntax::{AstNode, SyntaxNode, ast};

use super::attributes::Attribute;
use super::block::component_attribute;
use super::params::derives;
use super::span;
use crate::model::{Problem, Reporter, Span};

/// Adds what the macros would report about the components, the parameters and the trees of a file.
pub(super) fn check(root: &SyntaxNode, text: &str, problems: &mut Vec<Problem>) {
    for node in root.descendants() {
        let mut report = Report::default();
        let Some(place) = rules(node, text, &mut report) else { continue };
        problems.extend(report.errors().map(|error| {
            let range = error.span().byte_range();
            let found = Span::new(place.start + range.start, place.start + range.end);
            let span = if place.contains(found) && !range.is_empty() { found } else { place };
            Problem { span, message: error.to_string(), from: Reporter::Macro }
        }));
    }
    // The texts that this thread has read are kept for their spans until here.
    proc_macro2::extra::invalidate_current_thread_spans();
}

/// Runs the rules of a macro on its input, and returns the place of the input; `None` if the node has none, or one that is not
/// even a list of tokens, which the parser reports.
fn rules(node: SyntaxNode, text: &str, report: &mut Report) -> Option<Span> {
    let place = span(node.text_range());
    if let Some(block) = ast::Impl::cast(node.clone()) {
        component(place, &component_attribute(&block)?, text, report)?;
    } else if let Some(item) = ast::Struct::cast(node.clone()) {
        let item = derives(&item, "Params").then(|| place.of(text).parse().ok())??;
        params_parse::params(item, report);
    } else if let Some(item) = ast::Enum::cast(node.clone()) {
        let item = derives(&item, "ParamEnum").then(|| place.of(text).parse().ok())??;
        params_parse::choice(item, report);
    } else {
        let place = tree_of(&ast::MacroCall::cast(node)?)?;
        let draft = tree_parse::parse(place.of(text).parse().ok()?, report);
        draft.and_then(|draft| tree_check::check(&draft, report));
        return Some(place);
    }
    Some(place)
}

/// What stands in the brackets of `activation_tree!`.
fn tree_of(call: &ast::MacroCall) -> Option<Span> {
    let is_tree = call.path()?.segment()?.name_ref()?.text() == "activation_tree";
    is_tree.then(|| Some(super::within(span(call.token_tree()?.syntax().text_range()))))?
}

/// Checks a block without its attribute, and the options in it. Spaces keep the offsets of both.
fn component(place: Span, attribute: &Attribute, text: &str, report: &mut Report) -> Option<()> {
    let Span { start, end } = attribute.span;
    let list = attribute.list.as_ref().map_or(Span::at(place.start), |(list, _)| *list);
    let options = " ".repeat(list.start - place.start) + list.of(text);
    let item = format!("{}{}{}", &text[place.start..start], " ".repeat(end - start), &text[end..place.end]);
    let parsed = component_parse::parse(options.parse().ok()?, &item.parse().ok()?, report);
    if let component_parse::Parsed::Component(component) = parsed {
        component_check::check(&component, report);
    }
    Some(())
}
