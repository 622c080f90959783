//! Test of the documentation of all JSON fields.

use std::collections::BTreeSet;
use std::fs;

use serde_json::Value;

use crate::process::{Folder, run};

fn fields(value: &Value, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(object) => {
            found.extend(object.keys().cloned());
            // Types of postcard-schema have the fields of that crate, and a shape has the fields of its type; they are
            // documented elsewhere.
            let elsewhere = if object.contains_key("shape") { "value" } else { "" };
            let values = object.iter().filter(|(name, _)| !["schema", "messages", elsewhere].contains(&name.as_str()));
            values.for_each(|(_, value)| fields(value, found));
        }
        Value::Array(values) => values.iter().for_each(|value| fields(value, found)),
        _ => {}
    }
}

#[test]
fn every_printed_field_is_documented() {
    let page = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/json.md")).unwrap();
    let folder = Folder::new("schema");
    fs::write(folder.path().join("1.png"), "no image").unwrap();
    let mut printed = BTreeSet::new();
    let file = folder.path().join("run.mcap");
    let file = file.to_str().expect("UTF-8");
    let copy = format!("{file}.copy");
    for args in [
        &["--seconds", "1.5"][..],
        &["play", "--games", "1", "--seconds", "0.1"],
        &["graph"],
        #[cfg(feature = "evaluation")]
        &["watch", folder.text()],
        &["--seconds", "0.5", "--record", file],
        &["record", "info", file],
        &["record", "recover", file, &copy],
        &["replay", file],
    ] {
        fields(&run(&[args, &["--json"]].concat()).json(), &mut printed);
    }
    assert!(printed.len() > 50, "{printed:?}");
    for field in printed {
        assert!(page.contains(&format!("`{field}`")), "docs/json.md lacks `{field}`");
    }
}
