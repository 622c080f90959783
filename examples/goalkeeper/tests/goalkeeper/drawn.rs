//! The steps of the tutorial, from a blank canvas to the component.

use std::fs;
use std::path::{Path, PathBuf};

use bica_vicode::{Document, Edit, blank, cli, read};

/// Steps of the tutorial, in order.
const STEPS: [&str; 6] = ["1-states", "2-children", "3-transitions", "4-watch", "5-block", "6-kick"];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/goalkeeper")
}

fn component() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src/goalkeeper.rs")
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The text after each step.
fn drawn() -> Vec<String> {
    let blank = text(&folder().join("blank.rs"));
    let mut document = Document::new(&blank).with_width(cli::width_of(&component()));
    let texts = STEPS.iter().map(|step| {
        let edits = text(&folder().join(format!("{step}.json")));
        let edits: Vec<Edit> = serde_json::from_str(&edits).unwrap_or_else(|error| panic!("{step}: {error}"));
        for (index, edit) in edits.iter().enumerate() {
            let applied = document.apply(std::slice::from_ref(edit));
            applied.unwrap_or_else(|refusal| panic!("{step}, edit {}: {refusal}", index + 1));
        }
        document.text().to_owned()
    });
    texts.collect()
}

#[test]
fn blank_canvas_is_what_vicode_makes() {
    assert_eq!(text(&folder().join("blank.rs")), blank("Goalkeeper"));
}

#[test]
fn tutorial_steps_reproduce_the_component() {
    let made = drawn().pop().expect("a step");
    assert!(made == text(&component()), "the steps make another file:\n{made}");
}

#[test]
fn machine_is_complete_after_its_transitions() {
    for (step, text) in STEPS.iter().zip(drawn()).skip(2) {
        let problems = read(&text).problems;
        assert!(problems.is_empty(), "{step}: {problems:?}");
    }
}

#[test]
fn every_list_of_edits_is_step() {
    let files = fs::read_dir(folder()).expect("the folder of the steps").map(|entry| entry.expect("an entry").path());
    let lists = files.filter(|path| path.extension().is_some_and(|extension| extension == "json"));
    let mut names: Vec<String> =
        lists.map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned()).collect();
    names.sort();
    assert_eq!(names, STEPS);
}
