//! Rooms: which package may use which, and what a generic one may name.
//!
//! Generic packages serve every robot. They use neither a humanoid's packages nor an application's, and their sources
//! contain no name of a component or a joint of a robot, and no word of soccer.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::cargo;
use crate::pages::{Page, root};

/// Generic packages; every other one may use what it needs.
const GENERIC: [&str; 14] = [
    "bica",
    "bica-core",
    "bica-syntax",
    "bica-macros",
    "bica-runner",
    "bica-wire",
    "bica-app",
    "bica-link",
    "bica-recording",
    "bica-ros",
    "bica-tuning",
    "bica-drawing",
    "bica-monitor",
    "bica-vicode",
];
/// Packages of a humanoid and of its application without soccer: they use generic packages and one another.
const WITHOUT_SOCCER: [&str; 3] = ["bica-motion", "bica-body", "therapy"];
/// Sources that list the components of a robot in `components: [...]`.
const TREES: [&str; 2] = ["player/src/forward.rs", "examples/goalkeeper/src/tree.rs"];
/// The joints of a robot, one line each.
const JOINTS: &str = "bica-motion/src/joints.rs";
/// Words of soccer: `BALL`, `place_ball` and `BallKeeper` contain one of them.
const OBJECTS: [&str; 4] = ["ball", "goal", "soccer", "nao"];
/// Components whose names generic code may use for something else, such as a message of ROS.
const WORDS: [&str; 6] = ["Body", "Head", "Odometry", "Turn", "Player", "Walk"];
/// Cameras of a robot.
const CAMERAS: [&str; 2] = ["top_camera", "bottom_camera"];

/// Returns a line for each dependency of a generic package on another package of the workspace that is not generic, and of a package
/// without soccer on one with it.
pub(crate) fn forbidden_dependencies() -> Vec<String> {
    let packages = cargo::packages();
    let names: BTreeSet<&str> = packages.iter().filter_map(|package| package["name"].as_str()).collect();
    let bound = packages.iter().filter(|package| is_generic(&package["name"]) || is_without_soccer(&package["name"]));
    // Tests may read the sources of a robot.
    let dependencies = bound.flat_map(|package| {
        let used = package["dependencies"].as_array().into_iter().flatten().filter(|used| used["kind"] != "dev");
        used.map(move |used| (&package["name"], &used["name"]))
    });
    let is_ours = |used: &Value| used.as_str().is_some_and(|used| names.contains(used));
    let may = |package: &Value, used: &Value| is_generic(used) || is_without_soccer(package) && is_without_soccer(used);
    let forbidden = dependencies.filter(|(package, used)| is_ours(used) && !may(package, used));
    forbidden.map(|(package, used)| format!("{package} uses {used}")).collect()
}

fn is_without_soccer(name: &Value) -> bool {
    name.as_str().is_some_and(|name| WITHOUT_SOCCER.contains(&name))
}

fn is_generic(name: &Value) -> bool {
    name.as_str().is_some_and(|name| GENERIC.contains(&name))
}

/// Returns a line for each name of a robot in the sources of the generic packages, outside comments and tests, and for each
/// word of soccer.
pub(crate) fn names_of_robots() -> Vec<String> {
    let (names, pages) = (names(), generic_sources());
    pages.iter().flat_map(|page| [named(page, &names), objects(page)]).flatten().collect()
}

fn generic_sources() -> Vec<Page> {
    let folders = sources();
    let is_generic_source = |page: &Page| {
        let is_source = folders.iter().any(|folder| page.name.starts_with(folder));
        is_source && !page.name.contains("/vendor/") && !page.name.ends_with("tests.rs")
    };
    let pages = ["rs", "js", "html", "css"].into_iter().flat_map(Page::read_all).filter(is_generic_source);
    let pages: Vec<_> = pages.collect();
    assert!(pages.len() > 300, "only {} sources were found: are they read?", pages.len());
    pages
}

/// Folders of the generic sources, relative to the repository.
fn sources() -> Vec<String> {
    let packages = cargo::packages();
    let folder = |package: &Value| {
        let manifest = package["manifest_path"].as_str()?;
        let folder = std::path::Path::new(manifest).parent()?.strip_prefix(root()).ok()?.display().to_string();
        Some(if folder.is_empty() { String::new() } else { format!("{folder}/") })
    };
    let folders = packages.iter().filter(|package| is_generic(&package["name"])).filter_map(folder);
    folders.flat_map(|folder| ["src/", "page/"].map(|below| format!("{folder}{below}"))).collect()
}

/// Names of the components, joints and cameras of the robots.
pub(crate) fn names() -> BTreeSet<String> {
    let read = |path: &str| std::fs::read_to_string(root().join(path)).expect("a source of the repository");
    let mut names: BTreeSet<String> = CAMERAS.map(str::to_owned).into();
    for tree in TREES {
        let text = read(tree);
        let (_, list) = text.split_once("components: [").expect("a list of components");
        let list = list.split(']').next().unwrap_or_default();
        names.extend(words(list).filter(|name| !WORDS.contains(name)).map(str::to_owned));
    }
    let joints = read(JOINTS);
    let (_, list) = joints.split_once("pub enum Joint {").expect("the joints");
    names.extend(words(list.split('}').next().unwrap_or_default()).map(str::to_owned));
    names
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty())
}

/// Returns a line for each word of soccer in a source, outside comments and unit tests.
fn objects(page: &Page) -> Vec<String> {
    let code = page.text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    let mut found = Vec::new();
    for (index, line) in code.lines().enumerate() {
        let line = line.split("//").next().unwrap_or_default();
        let is_object = |word: &&str| parts(word).iter().any(|part| OBJECTS.contains(&part.as_str()));
        found.extend(words(line).filter(is_object).map(|word| format!("{}:{}: `{word}`", page.name, index + 1)));
    }
    found
}

/// Returns the words of a name, in small letters: those of `own_goal`, `OwnGoal` and `OWN_GOAL` are `own` and `goal`.
fn parts(name: &str) -> Vec<String> {
    let mut parts = vec![String::new()];
    let mut before = 'A';
    for letter in name.chars() {
        if letter == '_' || letter.is_uppercase() && !before.is_uppercase() {
            parts.push(String::new());
        }
        if letter != '_' {
            parts.last_mut().expect("one").extend(letter.to_lowercase());
        }
        before = letter;
    }
    parts
}

/// Returns a line for each of the names in a source.
pub(crate) fn named(page: &Page, names: &BTreeSet<String>) -> Vec<String> {
    let code = page.text.lines().enumerate().map(|(index, line)| (index, line.split("//").next().unwrap_or_default()));
    code.flat_map(|(index, line)| {
        let named = words(line).filter(|word| names.contains(*word));
        named.map(move |word| format!("{}:{}: `{word}`", page.name, index + 1))
    })
    .collect()
}

#[test]
fn names_of_robots_are_found() {
    let text =
        "let x = HeadYaw;\nlet y = 1; // FaceBall\nlet z = FaceBall;\nlet w = FaceBalls;\nlet at = \"top_camera\";\n";
    let page = Page { path: "x.rs".into(), name: "x.rs".into(), text: text.to_owned() };
    assert_eq!(named(&page, &names()), ["x.rs:1: `HeadYaw`", "x.rs:3: `FaceBall`", "x.rs:5: `top_camera`"]);
}

#[test]
fn words_of_soccer_are_found_in_sources() {
    let code = "place_ball(OwnGoal); // ball\nlet BALL = 1;\nballoon(\"a nao\");\n";
    let text = format!("{code}#[cfg(test)]\nmod tests {{\n    ball();\n}}\n");
    let page = Page { path: "x.rs".into(), name: "x.rs".into(), text };
    assert_eq!(objects(&page), ["x.rs:1: `place_ball`", "x.rs:1: `OwnGoal`", "x.rs:2: `BALL`", "x.rs:3: `nao`"]);
}
