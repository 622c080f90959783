//! Results of edits compile, and their `GRAPH` is the model.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use bica_test_data::random::Random;
use bica_vicode::Document;
use serde_json::Value;

use crate::agreement::agrees;
use crate::editing::edit;
use crate::machines::{PARTS, machine};
use crate::sources;

/// Returns a machine after random edits, if the rules of the macro find no mistake in it.
fn edited(seed: u64) -> Option<Document> {
    let mut random = Random::new(seed);
    let mut document = Document::new(&machine(&mut random, true));
    let mut fresh = 0;
    for _ in 0..=random.below(20) {
        let component = document.model().components[0].clone();
        let _ = document.apply(&[edit(&mut random, &component, &mut fresh)]);
    }
    document.model().problems.is_empty().then_some(document)
}

/// Returns the types of the machine's children.
fn children(document: &Document) -> BTreeSet<String> {
    document.model().components[0].links().into_iter().map(|link| link.child).collect()
}

fn write_package(folder: &Path, documents: &[Document]) {
    fs::create_dir_all(folder.join("src")).unwrap();
    let root = sources::root().canonicalize().unwrap();
    let manifest = format!(
        "[workspace]\n[package]\nname = \"edited\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[dependencies]\nbica = {{ path = \"{0}\" }}\n\
         bica-wire = {{ path = \"{0}/bica-wire\", features = [\"std\"] }}\nserde_json = \"1\"\n",
        root.display()
    );
    fs::write(folder.join("Cargo.toml"), manifest).unwrap();
    fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock")).unwrap();
    fs::write(folder.join("src/parts.rs"), PARTS).unwrap();
    let mut main = String::from("#![allow(warnings)]\nuse bica::prelude::*;\nmod parts;\n");
    let mut print = String::new();
    for (index, document) in documents.iter().enumerate() {
        fs::write(folder.join(format!("src/m{index}.rs")), document.text()).unwrap();
        let list = children(document).into_iter().collect::<Vec<_>>().join(", ");
        write!(
            main,
            "mod m{index};\nmod t{index} {{ use bica::prelude::*; use crate::m{index}::Machine; use crate::parts::*; \
             activation_tree! {{ pub struct Tree {{ root: Machine, cycle_hz: 100, components: [Machine, {list}] }} }} }}\n"
        )
        .unwrap();
        writeln!(
            print,
            "    let described = bica_wire::model::Description::of(&<t{index}::Tree as bica::Tree>::GRAPH);\n    \
             println!(\"{{}}\", serde_json::to_string(&described).unwrap());\n    println!(\"\\x01\");"
        )
        .unwrap();
    }
    write!(main, "fn main() {{\n{print}}}\n").unwrap();
    fs::write(folder.join("src/main.rs"), main).unwrap();
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_edited_machines_compile_to_their_model() {
    let documents: Vec<Document> = (0..).filter_map(edited).take(200).collect();
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("edited");
    write_package(&folder, &documents);
    let output = Command::new(env!("CARGO"))
        .args(["run", "--offline", "--quiet", "--manifest-path"])
        .arg(folder.join("Cargo.toml"))
        .env("CARGO_TARGET_DIR", folder.join("target"))
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let printed = String::from_utf8(output.stdout).unwrap();
    let trees: Vec<Value> = printed
        .split('\u{1}')
        .filter(|tree| !tree.trim().is_empty())
        .map(|tree| serde_json::from_str(tree).unwrap())
        .collect();
    assert_eq!(trees.len(), documents.len());
    for (document, tree) in documents.iter().zip(&trees) {
        agrees(&document.model().components[0], tree);
    }
}
