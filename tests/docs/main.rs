//! Tests of the documentation: every relative link has a target, and every command is accepted by its program.
//! Test of the manifests: every test belongs to a test program.

mod cargo;
mod commands;
mod links;
mod pages;
mod untested;

use pages::Page;

#[test]
fn every_relative_link_leads_to_a_file_and_a_heading() {
    let pages = Page::all();
    let broken: Vec<String> = pages.iter().flat_map(links::broken).collect();
    assert!(broken.is_empty(), "broken links:\n{}", broken.join("\n"));
    let checked: usize = pages.iter().map(|page| links::of(&page.text).count()).sum();
    assert!(checked > 20, "only {checked} links were found: are the pages read?");
}

#[test]
fn every_command_is_accepted_by_the_program_that_it_starts() {
    let workspace = cargo::Workspace::read();
    let (mut refused, mut checked) = (Vec::new(), 0);
    for page in Page::all() {
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
fn no_test_is_in_a_target_without_a_test_program() {
    let files = untested::with_tests(&cargo::packages());
    assert!(files.is_empty(), "tests that never run, as their manifest says `test = false`: {files:?}");
}

#[test]
fn no_example_is_in_a_library_whose_examples_are_not_run() {
    let files = untested::with_examples(&cargo::packages());
    assert!(files.is_empty(), "examples that never run, as their manifest says `doctest = false`: {files:?}");
}
