//! Tests and source files that a page cites.
//!
//! A citation is code: a path of a Rust file as `web/guard.rs`, or a test as `web/queue.rs::a_page_overflows_within_bounds` or
//! `link::attacks::a_lease_is_void`: parts of the test's path, then its function. A function of a test has a name of three words or more.

use std::path::Path;

use crate::pages::Page;

/// Returns the citations of a Markdown text.
pub(crate) fn of(text: &str) -> impl Iterator<Item = &str> {
    text.split('`').skip(1).step_by(2).filter(|code| is_citation(code))
}

fn is_citation(code: &str) -> bool {
    let is_path =
        |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_alphanumeric() || "_./-".contains(c));
    let (place, name) = code.rsplit_once("::").unwrap_or((code, ""));
    let is_rust = Path::new(place).extension().is_some_and(|extension| extension == "rs");
    let is_file = name.is_empty() && place.contains('/') && is_rust;
    let is_test = name.matches('_').count() >= 2
        && name.chars().all(|c| c.is_ascii_lowercase() || c == '_' || c.is_ascii_digit());
    place.split("::").all(is_path) && (is_file || is_test)
}

/// Returns a message for each citation of a page that is in no source.
pub(crate) fn broken(page: &Page, sources: &[Page]) -> Vec<String> {
    let missing = of(&page.text).filter(|citation| !sources.iter().any(|source| has(source, citation, &page.text)));
    missing.map(|citation| format!("{}: `{citation}`", page.name)).collect()
}

/// Whether a source is the file that a page cites, or contains the cited test.
fn has(source: &Page, citation: &str, page: &str) -> bool {
    let Some((place, name)) = citation.rsplit_once("::") else { return Path::new(&source.name).ends_with(citation) };
    let mut parts = place.split("::").flat_map(|part| part.split('/')).map(|part| part.trim_end_matches(".rs"));
    let file = Path::new(&source.name).with_extension("");
    let is_alias = |part| alias(page, part).is_some_and(|target| target.ends_with(&source.name));
    let contains = |part| file.iter().any(|other| other == part) || is_alias(part);
    let function = format!("fn {name}(");
    parts.all(contains) && source.text.contains(&function)
}

/// Target of a name that the page explains, as ``- `web`: [`attacks/main.rs`](../tests/attacks/main.rs)``.
fn alias<'a>(page: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = page.split_once(&format!("\n- `{name}`: ["))?;
    Some(rest.split_once("](")?.1.split_once(')')?.0)
}

#[test]
fn only_files_and_tests_are_citations() {
    let text =
        "`web/guard.rs` has `web::a_page_is_refused`, `one::two`, `bica_vision::profile`, `a_b_c` and `x::Y_Z_V`.";
    assert_eq!(of(text).collect::<Vec<_>>(), ["web/guard.rs", "web::a_page_is_refused"]);
}

#[test]
fn citation_needs_its_function_in_a_file_of_its_path() {
    let (name, text) = ("tools/link/tests/link/attacks.rs".to_owned(), "fn a_lease_is_void() {}".to_owned());
    let page = "Tests:\n- `x`: [`attacks.rs`](../tools/link/tests/link/attacks.rs);\n- `y`: [`z.rs`](../z.rs)";
    let source = Page { path: "attacks.rs".into(), name, text };
    for right in [
        "link::attacks::a_lease_is_void",
        "link/attacks.rs::a_lease_is_void",
        "tests/link/attacks.rs",
        "x::a_lease_is_void",
    ] {
        assert!(has(&source, right, page), "{right}");
    }
    for wrong in
        ["link::attacks::a_lease_is", "link::faults::a_lease_is_void", "tests/attacks.rs", "y::a_lease_is_void"]
    {
        assert!(!has(&source, wrong, page), "{wrong}");
    }
}
