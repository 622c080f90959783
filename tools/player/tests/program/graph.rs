//! The activation tree in every format.

use crate::process::run;

fn printed(args: &[&str]) -> String {
    let ran = run(&[&["graph"], args].concat());
    assert_eq!((ran.code, ran.stderr.as_str()), (Some(0), ""));
    ran.stdout
}

#[test]
fn every_format_names_every_component() {
    let graph: serde_json::Value = serde_json::from_str(&printed(&["--json"])).unwrap();
    let components = graph["components"].as_array().unwrap();
    assert_eq!(graph["name"], "Forward");
    assert!(components.len() > 15);
    for (format, start) in [("svg", "<svg "), ("dot", "digraph"), ("mermaid", "flowchart"), ("json", "{")] {
        let text = printed(&["--format", format]);
        assert!(text.starts_with(start), "{format}: {}", &text[..40]);
        for component in components {
            let name = component["name"].as_str().unwrap();
            assert!(text.contains(name), "{format} lacks {name}");
        }
    }
    assert_eq!(printed(&[]), printed(&["--format", "svg"]));
    assert_eq!(printed(&["--json"]), printed(&["--format", "json"]));
}

#[test]
fn drawing_in_the_documentation_is_current() {
    let kept = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/forward.svg");
    let kept = std::fs::read_to_string(kept).unwrap_or_default();
    let remedy = "draw it anew: cargo run --release -- graph --format svg > docs/forward.svg";
    assert!(kept == printed(&["--format", "svg"]), "docs/forward.svg does not show the current tree; {remedy}");
}
