//! Tests of the documentation: every relative link has a target, and every command is accepted by its program.
//! Test of the manifests: every test belongs to a test program.

mod cargo;
mod commands;
mod links;
mod pages;
mod prose;
mod untested;

use pages::Page;

#[test]
fn every_relative_link_leads_to_a_file_and_a_heading() {
    let pages = Page::read_all("md");
    let broken: Vec<String> = pages.iter().flat_map(links::broken).collect();
    assert!(broken.is_empty(), "broken links:\n{}", broken.join("\n"));
    let checked: usize = pages.iter().map(|page| links::of(&page.text).count()).sum();
    assert!(checked > 20, "only {checked} links were found: are the pages read?");
}

#[test]
fn every_command_is_accepted_by_the_program_that_it_starts() {
    let workspace = cargo::Workspace::read();
    let (mut refused, mut checked) = (Vec::new(), 0);
    for page in Page::read_all("md") {
        for command in commands::of(&page.text) {
            checked += 1;
            if let Err(error) = commands::check(&command, &workspace) {
                refused.push(format!("{}:{}: `{}`: {error}", page.name, command.line, command.text));
            }
        }
    }
    assert!(refused.is_empty(), "commands that do not work:\n{}", refused.join("\n"));
    assert!(checked > 40, "only {checked} commands were found: are the pages read?");
}

#[test]
fn prose_keeps_its_width_and_words() {
    let is_text = |line: &str| !line.starts_with('|');
    let is_comment = |line: &str| {
        let comment = line.trim_start().strip_prefix("//").map(|text| text.trim_start_matches(['/', '!', ' ']));
        // Neither a table nor a line of code in a string.
        comment.is_some_and(|text| !text.starts_with('|') && !text.contains(r"\n"))
    };
    let pages = Page::read_all("md").iter().flat_map(|page| prose::faults(page, is_text)).collect::<Vec<_>>();
    let sources = Page::read_all("rs").iter().flat_map(|page| prose::faults(page, is_comment)).collect::<Vec<_>>();
    assert!(pages.is_empty() && sources.is_empty(), "{}\n{}", pages.join("\n"), sources.join("\n"));
}

#[test]
fn cited_tests_exist() {
    let sources = Page::read_all("rs");
    let exists = |name: &str| sources.iter().any(|source| source.text.contains(&format!("fn {name}(")));
    let pages = Page::read_all("md");
    let cited: Vec<&str> = pages.iter().flat_map(|page| prose::cited(&page.text)).collect();
    let missing: Vec<_> = cited.iter().filter(|name| !exists(name)).collect();
    assert!(missing.is_empty() && cited.len() > 20, "{} citations, without a test: {missing:?}", cited.len());
}

#[test]
fn no_test_is_in_a_target_without_a_test_program() {
    let files = untested::with_tests(&cargo::packages());
    assert!(files.is_empty(), "tests that never run, as their manifest says `test = false`: {files:?}");
}

#[test]
fn no_example_is_in_a_library_whose_examples_are_not_run() {
    let files = untested::with_examples(&cargo::packages());
    assert!(files.is_empty(), "examples that never run, as their manifest says `doctest = false`: {files:?}");
}
