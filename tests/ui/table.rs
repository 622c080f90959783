//! Mistakes that one item shows, and the messages about them, without a compiler.
//!
//! The files in `table` hold the cases: a name behind `==`, the item, and below each wrong line its messages behind `^`
//! marks, which stand under the wrong tokens. `TRYBUILD=overwrite` writes the messages that were found.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs};

use bica_syntax::component::{self, check, parse::Parsed};
use bica_syntax::report::Report;
use bica_syntax::{params, plain_item, role, tree};
use proc_macro2::{Delimiter, TokenStream, TokenTree};

#[test]
fn each_mistake_has_its_message_at_its_tokens() {
    let mut wrong = String::new();
    for file in files() {
        let written = fs::read_to_string(&file).expect("a file of cases");
        let found = written.split("\n== ").map(case).collect::<Vec<_>>().join("\n== ");
        if env::var("TRYBUILD").is_ok_and(|value| value == "overwrite") {
            fs::write(&file, &found).expect("the file of cases can be written");
        }
        let cases = written.split("\n== ").zip(found.split("\n== ")).filter(|(written, found)| written != found);
        for (written, found) in cases {
            write!(wrong, "\nexpected:\n== {written}\nfound:\n== {found}").expect("a text");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn each_case_of_the_table_has_a_message() {
    for file in files() {
        let text = fs::read_to_string(&file).expect("a file of cases");
        for case in text.split("\n== ") {
            assert!(case.lines().any(is_message), "{}: no message\n{case}", file.display());
        }
    }
}

fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ui/table");
    let files = fs::read_dir(folder).expect("the folder of cases").map(|file| file.expect("a file").path());
    let files: Vec<_> = files.collect();
    assert!(!files.is_empty(), "no cases");
    files
}

fn is_message(line: &str) -> bool {
    line.trim_start().starts_with('^')
}

/// A case with the messages that were found.
fn case(written: &str) -> String {
    let (name, body) = written.split_once('\n').expect("a name and an item");
    let source: Vec<&str> = body.lines().filter(|line| !is_message(line)).collect();
    let mut report = Report::default();
    read(source.join("\n").parse().expect("tokens"), &mut report);
    let mut messages: Vec<_> = report.mistakes().iter().map(|one| (one.error.span(), one.error.to_string())).collect();
    messages.sort_by_key(|(span, _)| (span.start().line, span.start().column));
    let mut found = format!("{name}\n");
    for (index, line) in source.iter().enumerate() {
        writeln!(found, "{line}").expect("a text");
        for (span, message) in messages.iter().filter(|(span, _)| span.start().line == index + 1) {
            let (start, end) = (span.start(), span.end());
            let end = if end.line == start.line { end.column } else { line.chars().count() };
            let (indent, marks) = (" ".repeat(start.column), "^".repeat((end - start.column).max(1)));
            writeln!(found, "{indent}{marks} {message}").expect("a text");
        }
    }
    if !body.ends_with('\n') {
        found.pop();
    }
    found
}

/// Reads an item as its macro does.
fn read(item: TokenStream, report: &mut Report) {
    let attributes = attributes(&item);
    if let Some(TokenTree::Ident(name)) = item.clone().into_iter().next()
        && name == "activation_tree"
    {
        let content = item.into_iter().find_map(|token| braced(&token)).expect("a tree in braces");
        let _ = tree::parse::parse(content, report).and_then(|draft| tree::check::check(&draft, report));
    } else if attributes.iter().any(|one| one.contains("ParamEnum")) {
        let _ = params::parse::choice(item, report);
    } else if attributes.iter().any(|one| one.contains("Params")) {
        let _ = params::parse::params(item, report);
    } else if attributes.iter().any(|one| one.contains("ComponentDoc")) {
        let _ = plain_item::component_doc(item, report);
    } else if attributes.iter().any(|one| one.starts_with("data")) {
        let (options, item) = split("data", item);
        let _ = plain_item::framework(options, &item, report);
    } else if attributes.iter().any(|one| one.starts_with("role")) {
        let (options, item) = split("role", item);
        let _ = role::parse(options, &item, report);
    } else {
        let (options, item) = split("component", item);
        if let Parsed::Component(component) = component::parse::parse(options, &item, report) {
            let _ = check::check(&component, report);
        }
    }
}

/// The options of `#[name(options)] item`, and the item.
fn split(name: &str, item: TokenStream) -> (TokenStream, TokenStream) {
    let mut tokens: Vec<TokenTree> = item.into_iter().collect();
    let attribute = tokens.iter().position(|token| bracketed(token).is_some_and(|text| text.starts_with(name)));
    let attribute = attribute.expect("an item with an attribute of ours");
    let TokenTree::Group(brackets) = tokens.remove(attribute) else { unreachable!("brackets are a group") };
    tokens.remove(attribute - 1);
    let options = brackets.stream().into_iter().nth(1).map(|token| match token {
        TokenTree::Group(options) => options.stream(),
        other => other.into(),
    });
    (options.unwrap_or_default(), tokens.into_iter().collect())
}

fn attributes(item: &TokenStream) -> Vec<String> {
    item.clone().into_iter().filter_map(|token| bracketed(&token)).collect()
}

fn bracketed(token: &TokenTree) -> Option<String> {
    match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket => Some(group.stream().to_string()),
        _ => None,
    }
}

fn braced(token: &TokenTree) -> Option<TokenStream> {
    match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group.stream()),
        _ => None,
    }
}
