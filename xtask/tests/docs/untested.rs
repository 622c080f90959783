//! Targets that `cargo test` builds no test program for, because their manifest says `test = false`.

use std::fs;
use std::path::PathBuf;

use serde_json::Value;

use crate::pages::files;

/// Returns the source files of such targets that contain tests, which would never run.
pub(crate) fn with_tests(packages: &[Value]) -> Vec<PathBuf> {
    let files = packages.iter().flat_map(|package| {
        let targets = package["targets"].as_array().expect("a list of targets");
        let has_library = targets.iter().any(is_library);
        let untested = targets.iter().filter(|target| target["test"] == false);
        let untested = untested.filter(|target| is_library(target) || is(target, "bin"));
        untested.flat_map(move |target| {
            let root = PathBuf::from(target["src_path"].as_str().expect("a path"));
            // The other files of a program with a library are the library's.
            if has_library && is(target, "bin") { vec![root] } else { files(root.parent().expect("a folder"), "rs") }
        })
    });
    files.filter(|file| has_test(&fs::read_to_string(file).expect("a source file"))).collect()
}

/// Returns the source files of libraries with `doctest = false` that contain examples, which would never run.
pub(crate) fn with_examples(packages: &[Value]) -> Vec<PathBuf> {
    let targets = packages.iter().flat_map(|package| package["targets"].as_array().expect("a list of targets"));
    let undocumented = targets.filter(|target| is_library(target) && target["doctest"] == false);
    let files = undocumented.flat_map(|target| {
        let root = PathBuf::from(target["src_path"].as_str().expect("a path"));
        files(root.parent().expect("a folder"), "rs")
    });
    files.filter(|file| has_example(&fs::read_to_string(file).expect("a source file"))).collect()
}

/// Whether a doc comment contains a block of code that rustdoc would compile.
fn has_example(source: &str) -> bool {
    let docs = source.lines().map(str::trim_start);
    let docs = docs.filter_map(|line| line.strip_prefix("//!").or_else(|| line.strip_prefix("///")));
    let fences = docs.filter_map(|line| line.trim().strip_prefix("```"));
    // Each second fence ends a block.
    let mut languages = fences.step_by(2).map(|words| words.split(',').next().unwrap_or_default().trim());
    languages.any(|language| matches!(language, "" | "rust" | "no_run" | "should_panic" | "compile_fail"))
}

fn is(target: &Value, kind: &str) -> bool {
    target["kind"].as_array().expect("a list of kinds").iter().any(|name| name == kind)
}

fn is_library(target: &Value) -> bool {
    is(target, "lib") || is(target, "proc-macro")
}

/// Whether a source contains a test; text in macros, which expands elsewhere, does not begin a line with the attribute.
fn has_test(source: &str) -> bool {
    source.lines().map(str::trim_start).any(|line| line.starts_with("#[test]") || line.starts_with("#[cfg(test)]"))
}

#[test]
fn tests_and_test_modules_are_found() {
    assert!(
        has_test("fn a() {}\n\n#[cfg(test)]\nmod tests;\n") && has_test("mod m {\n    #[test]\n    fn a() {}\n}\n")
    );
    assert!(!has_test("//! ```\n//! #[test]\n//! ```\n$($meta)* #[test] fn $name() $body\n"));
}

#[test]
fn blocks_in_other_languages_are_no_examples() {
    assert!(has_example("//! Text.\n//!\n//! ```\n//! let a = 1;\n//! ```\n"));
    assert!(has_example("    /// ```text\n    /// a\n    /// ```\n    /// ```no_run\n    /// b();\n    /// ```\n"));
    assert!(!has_example("/// ```text\n/// a\n/// ```\nlet text = \"```\";\n// ```\n"));
}
