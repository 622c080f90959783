//! Imports of children and of other names.

use bica_vicode::{Document, Edit};

/// The text after importing some names, each from its module.
fn imported(text: &str, names: &[(&str, &str)]) -> String {
    let mut document = Document::new(text);
    for (import, name) in names {
        let edit = Edit::AddImport { import: (*import).to_owned(), name: (*name).to_owned() };
        document.apply(&[edit]).expect("the edit is possible");
    }
    document.text().to_owned()
}

#[test]
fn imports_of_other_crates_share_a_paragraph() {
    let names = [("crate::skills", "Dive"), ("player::motion", "Body"), ("glam", "Vec2"), ("core::cell", "Cell")];
    let expected = "use bica::prelude::*;\nuse glam::Vec2;\nuse player::motion::Body;\n\nuse crate::skills::Dive;\n\n\
                    use core::cell::Cell;\n\nstruct A;\n";
    assert_eq!(imported("use bica::prelude::*;\n\nstruct A;\n", &names), expected);
}

#[test]
fn import_joins_the_line_of_its_module() {
    let names = [("player::motion", "Body"), ("player::motion", "Arm"), ("player::motion", "Head")];
    assert_eq!(imported("struct A;\n", &names), "use player::motion::{Arm, Body, Head};\n\nstruct A;\n");
}

#[test]
fn exported_and_conditional_imports_stay() {
    for kept in ["pub use player::motion::Head;\n", "#[cfg(test)]\nuse player::motion::{Head};\n"] {
        let after = imported(&format!("{kept}\nstruct A;\n"), &[("player::motion", "Body")]);
        assert_eq!(after.replace("use player::motion::Body;\n", ""), format!("{kept}\nstruct A;\n"));
    }
}

#[test]
fn known_names_and_wrong_paths_are_refused() {
    for (import, name, why) in [
        ("player::motion", "Head", "is known in this file already"),
        ("other", "A", "is known in this file already"),
        ("player::{motion}", "Body", "is no Rust"),
        ("player motion", "Body", "is no Rust"),
        ("player::motion", "fn", "is a keyword"),
        ("player::motion", "a, b", "is no name"),
    ] {
        let text = "use player::motion::Head;\n\nstruct A;\n";
        let mut document = Document::new(text);
        let refusal = document.apply(&[Edit::AddImport { import: import.to_owned(), name: name.to_owned() }]);
        let message = refusal.expect_err("the edit is refused").message;
        assert!(message.contains(why), "{import}::{name}: {message}");
        assert_eq!(document.text(), text);
    }
}
