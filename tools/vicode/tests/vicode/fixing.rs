//! Quick fixes.

use bica_vicode::{Document, fixes};

/// Replacements in the machine that make a mistake, and the fixes of it.
type Case<'a> = (&'a [(&'a str, &'a str)], &'a [&'a str]);

/// A machine with two states and a transition in each direction.
fn machine(changes: &[(&str, &str)]) -> Document {
    let text = "#[component]\nimpl A {\n    #[state(initial)]\n    fn one(&mut self) {}\n\n    #[state]\n    fn two(&mut self) {}\n\n    \
        #[transition(one -> two)]\n    fn go(&self) -> bool {\n        true\n    }\n\n    \
        #[transition(two -> one)]\n    fn back(&self) -> bool {\n        true\n    }\n}\n";
    Document::new(&changes.iter().fold(text.to_owned(), |text, (from, to)| text.replacen(from, to, 1)))
}

#[test]
fn each_fix_mends_its_mistake() {
    let cases: [Case<'_>; 7] = [
        (&[("one -> two", "one -> tow")], &["Replace `tow` by `two`", "Add last state `tow`"]),
        (&[("one -> two", "one -> kick")], &["Add last state `kick`"]),
        // A function has that name: no state is added.
        (&[("one -> two", "one -> back")], &[]),
        (&[("#[transition(one", "#[transtion(one")], &["Replace `transtion` by `transition`"]),
        (&[("#[state(initial)]", "#[state]")], &["Start in `one`"]),
        (&[("#[state]", "#[state(last)]")], &["`two` is not last"]),
        (
            &[("#[transition(two -> one)]", "#[transition(one -> two)]")],
            &["Mark `two` as last", "Add a transition to `one`"],
        ),
    ];
    for (changes, labels) in cases {
        let document = machine(changes);
        let found: Vec<_> = fixes(&document).into_iter().flatten().collect();
        let names: Vec<_> = found.iter().map(|fix| &*fix.label).collect();
        for label in labels {
            assert!(names.contains(label), "{changes:?}: {names:?} for {:?}", document.model().problems);
        }
        for fix in found {
            let mut mended = Document::new(document.text());
            mended.apply(&[fix.edit]).unwrap();
            let (before, after) = (&document.model().problems, &mended.model().problems);
            assert!(
                after.len() <= before.len()
                    && before.iter().any(|old| after.iter().all(|new| new.message != old.message)),
                "{}",
                fix.label
            );
        }
    }
    assert!(fixes(&machine(&[])).is_empty());
}
