//! Merges of edits in the document and changes of its file.

use std::collections::BTreeMap;

use bica_test_data::random::Random;
use bica_vicode::{Document, Edit, External, Keep};

use crate::editing::edit;
use crate::machines::machine;

/// The text of each function by its name.
fn functions(text: &str) -> BTreeMap<String, String> {
    let model = bica_vicode::read(text);
    let functions = model.components[0].functions();
    functions.map(|function| (function.name.text.clone(), function.span.of(text).to_owned())).collect()
}

fn edited(document: &mut Document, random: &mut Random, count: usize, mut fresh: usize) {
    for _ in 0..count {
        let component = document.model().components[0].clone();
        let _ = document.apply(&[edit(random, &component, &mut fresh)]);
    }
}

/// Checks that the result has the change of one side to each function that the other side left unchanged.
fn no_edit_is_lost(base: &str, one: &str, other: &str, merged: &str) {
    let (base, one, other, merged) = (functions(base), functions(one), functions(other), functions(merged));
    // A function that one side renamed and the other one changed has the new name and the change.
    let renamed = base.iter().any(|(name, text)| !one.contains_key(name) && other.get(name) != Some(text));
    for name in base.keys().chain(one.keys()) {
        if base.get(name) != one.get(name) && base.get(name) == other.get(name) {
            if renamed && !base.contains_key(name) {
                assert!(merged.contains_key(name), "{name}");
            } else {
                assert_eq!(merged.get(name), one.get(name), "{name}");
            }
        }
    }
}

/// Runs interleavings; returns how many had no conflict.
fn interleavings(count: u64) -> u64 {
    let mut clean = 0;
    for seed in 0..count {
        let mut random = Random::new(seed);
        let hostile = random.percent(50);
        let base = machine(&mut random, hostile);
        let (mut ours, mut theirs) = (Document::new(&base), Document::new(&base));
        let (here, there) = (1 + random.below(3), 1 + random.below(3));
        edited(&mut ours, &mut random, here, 0);
        edited(&mut theirs, &mut random, there, 1000);
        let before = ours.text().to_owned();
        match ours.external_change(theirs.text()) {
            External::Same => {
                assert_eq!(ours.text(), before);
                no_edit_is_lost(&base, theirs.text(), &before, ours.text());
            }
            External::Merged(_) => {
                clean += 1;
                no_edit_is_lost(&base, &before, theirs.text(), ours.text());
                no_edit_is_lost(&base, theirs.text(), &before, ours.text());
                assert_eq!(ours.saved(), theirs.text());
                ours.undo();
                assert_eq!(ours.text(), before, "a merge is one step of the history");
            }
            External::Conflict(conflict) => {
                assert_eq!((ours.text(), &*conflict.ours, &*conflict.theirs), (&*before, &*before, theirs.text()));
                assert!(!conflict.spans.is_empty());
                ours.resolve(Keep::Theirs);
                assert!(ours.text() == theirs.text() && ours.conflict().is_none() && !ours.is_changed());
                ours.undo();
                assert_eq!(ours.text(), before, "the other text can be taken back");
            }
        }
    }
    clean
}

#[test]
fn interleavings_lose_no_edit() {
    let clean = interleavings(20);
    assert!(clean > 5, "{clean}");
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_interleavings_lose_no_edit() {
    let clean = interleavings(500);
    println!("{clean} of 500 merged");
    assert!((125..500).contains(&clean), "{clean}");
}

const BASE: &str = "\
#[component]
impl A {
    #[state(initial)]
    fn one(&mut self) {
        self.n = 1;
    }

    #[transition(one -> two)]
    fn go(&self) -> bool {
        true
    }

    #[state(last)]
    fn two(&mut self) {}
}
";

fn body(function: &str, body: &str) -> Edit {
    Edit::SetBody { component: "A".to_owned(), function: function.to_owned(), body: body.to_owned() }
}

#[test]
fn changes_of_one_body_are_a_conflict() {
    for (here, there) in [
        ("self.n = 2;", "self.n = 3;"),
        ("self.n = 1;\nself.m = 2;", "self.n = 1;\nself.m = 3;"),
        ("", "self.n = 1 + 1;"),
    ] {
        let mut document = Document::new(BASE);
        document.apply(&[body("one", here)]).unwrap();
        let ours = document.text().to_owned();
        let mut theirs = Document::new(BASE);
        theirs.apply(&[body("one", there)]).unwrap();
        assert!(matches!(document.external_change(theirs.text()), External::Conflict(_)), "{here} {there}");
        assert_eq!(document.text(), ours);
        document.resolve(Keep::Ours);
        assert!(document.text() == ours && document.saved() == theirs.text() && document.is_changed());
        for expected in [theirs.text(), &ours, BASE] {
            document.undo();
            assert_eq!(document.text(), expected, "the choice can be undone, and what was before it");
        }
    }
}

#[test]
fn equal_changes_are_no_conflict() {
    let mut document = Document::new(BASE);
    document.apply(&[body("one", "self.n = 2;")]).unwrap();
    let theirs = document.text().to_owned();
    assert_eq!(document.external_change(&theirs), External::Same);
    assert!(!document.is_changed());
}

#[test]
fn reverted_file_ends_the_conflict() {
    let mut document = Document::new(BASE);
    document.apply(&[body("one", "self.n = 2;")]).unwrap();
    assert!(matches!(document.external_change(&BASE.replace("n = 1", "n = 3")), External::Conflict(_)));
    assert_eq!(document.external_change(BASE), External::Same);
    assert!(document.conflict().is_none() && document.text().contains("n = 2"));
}

#[test]
fn one_history_has_canvas_code_and_file() {
    let mut document = Document::new(BASE);
    document.apply(&[body("two", "self.n = 9;")]).unwrap();
    let canvas = document.text().to_owned();
    let at = canvas.find("n = 1").unwrap() + 4;
    let typed = Edit::Replace { span: bica_vicode::model::Span::new(at, at + 1), text: "7".to_owned() };
    document.apply(&[typed]).unwrap();
    let code = document.text().to_owned();
    let theirs = BASE.replace("one -> two", "one -> two, after_ms = 5");
    assert!(matches!(document.external_change(&theirs), External::Merged(_)));
    let all = document.text().to_owned();
    assert!(all.contains("n = 7") && all.contains("n = 9") && all.contains("after_ms = 5"));
    for expected in [&code, &canvas, BASE] {
        document.undo();
        assert_eq!(document.text(), expected);
    }
    assert!(document.undo().is_none());
    for expected in [&canvas, &code, &all] {
        document.redo();
        assert_eq!(document.text(), expected);
    }
}
