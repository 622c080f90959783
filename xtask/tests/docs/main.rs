//! Tests of the documentation: every relative link has a target, every command is accepted by its program, and every cited test
//! exists.
//! Tests of the manifests: every test belongs to a test program, and generic packages use no robot's.

mod cargo;
mod circles;
mod citations;
mod commands;
mod links;
mod pages;
mod prose;
mod rooms;
mod untested;

use pages::Page;

#[test]
fn relative_links_have_targets() {
    let pages = Page::read_all("md");
    let broken: Vec<String> = pages.iter().flat_map(links::broken).collect();
    assert!(broken.is_empty(), "broken links:\n{}", broken.join("\n"));
    let checked: usize = pages.iter().map(|page| links::of(&page.text).count()).sum();
    assert!(checked > 20, "only {checked} links were found: are the pages read?");
}

#[test]
fn commands_are_accepted_by_their_program() {
    let workspace = cargo::Workspace::read();
    let (mut refused, mut checked) = (Vec::new(), 0);
    // Tests of `bica-app` run the commands of a robot's own program.
    let is_own = |page: &&Page| page.name == "docs/your-robot.md" || page.name.starts_with("tools/app/template/");
    for page in Page::read_all("md").iter().filter(|page| !is_own(page)) {
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
fn cited_tests_and_files_exist() {
    let (sources, pages) = (Page::read_all("rs"), Page::read_all("md"));
    let broken: Vec<String> = pages.iter().flat_map(|page| citations::broken(page, &sources)).collect();
    assert!(broken.is_empty(), "cited, but in no source:\n{}", broken.join("\n"));
    let checked: usize = pages.iter().map(|page| citations::of(&page.text).count()).sum();
    assert!(checked > 40, "only {checked} citations were found: are the pages read?");
}

#[test]
fn code_of_the_tutorial_is_that_of_its_example() {
    let text = |name: &str| std::fs::read_to_string(pages::root().join(name)).expect("a file of the repository");
    let (page, example) = (text("docs/arm.md"), text("examples/arm.rs"));
    let blocks: Vec<_> = page.split("```rust\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert!(blocks.len() >= 8, "{} blocks", blocks.len());
    let other: Vec<_> = blocks.into_iter().filter(|block| !example.contains(*block)).collect();
    assert!(other.is_empty(), "not in the example:\n{}", other.join("\n"));
}

#[test]
fn names_of_tests_have_at_most_50_characters() {
    let long = |page: Page| {
        let names =
            page.text.split("fn ").skip(1).map(|rest| rest.split(['(', '<', ' ', '\n']).next().unwrap_or_default());
        let is_long = |name: &&str| name.len() > 50 && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        names.filter(is_long).map(|name| format!("{}: {name}", page.name)).collect::<Vec<_>>()
    };
    let long: Vec<_> = Page::read_all("rs").into_iter().flat_map(long).collect();
    assert!(long.is_empty(), "names of tests that do not state a property in 50 characters:\n{}", long.join("\n"));
}

#[test]
fn targets_without_test_program_have_no_tests() {
    let files = untested::with_tests(&cargo::packages());
    assert!(files.is_empty(), "tests that never run, as their manifest says `test = false`: {files:?}");
}

#[test]
fn libraries_without_doctests_have_no_examples() {
    let files = untested::with_examples(&cargo::packages());
    assert!(files.is_empty(), "examples that never run, as their manifest says `doctest = false`: {files:?}");
}

#[test]
fn modules_of_a_package_are_in_no_circle() {
    let (circles, read) = circles::found(&Page::read_all("rs"));
    assert!(circles.is_empty(), "modules that use each other, or what does:\n{}", circles.join("\n"));
    assert!(read > 60, "only {read} modules were found: are the sources read?");
}

#[test]
fn generic_packages_use_no_package_of_a_robot() {
    assert_eq!(rooms::forbidden_dependencies(), <[String; 0]>::default());
}

#[test]
fn generic_sources_name_no_component_or_joint() {
    let named = rooms::names_of_robots();
    assert!(named.is_empty(), "names of a robot in generic sources:\n{}", named.join("\n"));
}
