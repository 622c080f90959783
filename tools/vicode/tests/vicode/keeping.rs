//! Bytes that an edit must keep, and edits that must be refused.

use bica_vicode::model::Span;
use bica_vicode::{Document, Edit};

/// Returns the text after an edit given as JSON, or the message of its refusal.
pub(crate) fn edited(text: &str, edit: &str) -> Result<String, String> {
    let edit: Edit = serde_json::from_str(edit).expect(edit);
    let mut document = Document::new(text);
    document.apply(&[edit]).map_err(|refusal| refusal.message)?;
    let after = document.text().to_owned();
    document.undo();
    assert_eq!(document.text(), text, "the edit can be undone");
    Ok(after)
}

const MACHINE: &str = "#[component(hz = 20 /* why */, resume)]\r\nimpl A {\r\n    /// One.\r\n    ///\r\n    ///     code\r\n    \
    #[state(initial /* first */)]\r\n    fn one(&mut self, ball: &Ball, /* both */ _net: &Net) {\r\n        \
    let _ = format!(\"{ball:?}\");\r\n    }\r\n\r\n    #[state]\r\n    fn two(&mut self) {}\r\n\r\n    \
    #[transition(one /* | */ | two -> two /* last */, after_ms = /* ms */ 5)]\r\n    fn go(&self) -> bool { true }\r\n\r\n    \
    #[entry(one /* 1 */ | two // 2\r\n    )]\r\n    fn begin(&mut self) {}\r\n}\r\n";

#[test]
fn comments_line_ends_and_indented_docs_stay() {
    let on = |edit: &str| format!(r#"{{"component": "A", "edit": {edit}}}"#);
    for (edit, from, to) in [
        (r#""set_initial", "state": "two""#, "state(initial /* first */)", "state /* first */"),
        (r#""set_last", "state": "one", "last": true"#, "initial /* first */", "initial, last /* first */"),
        (r#""set_sources", "transition": "go", "from": ["one"]"#, "one /* | */ | two ->", "one /* | */ ->"),
        (r#""set_timer", "transition": "go", "after_ms": 7"#, ", after_ms = /* ms */ 5", ", after_ms = 7 /* ms */"),
        (r#""set_hook_states", "hook": "begin", "states": ["two"]"#, "one /* 1 */ | two //", "two /* 1 */ //"),
        (r#""set_option", "option": "hz", "value": null"#, "hz = 20 /* why */, resume", "/* why */resume"),
        (r#""remove_child", "function": "one", "child": "Net""#, ", /* both */ _net: &Net", "/* both */ "),
        (r#""set_docs", "function": "one", "docs": "One.\n\n    code\n""#, "", ""),
        (
            r#""set_docs", "function": "one", "docs": "Two.\n  a""#,
            "/// One.\r\n    ///\r\n    ///     code",
            "/// Two.\r\n    ///   a",
        ),
    ] {
        let after = edited(MACHINE, &on(edit)).expect(edit);
        let after = if edit.contains("\"two\"") && edit.contains("set_initial") {
            after.replacen("#[state(initial)]\r\n    fn two", "#[state]\r\n    fn two", 1)
        } else {
            after
        };
        assert_eq!(after, MACHINE.replacen(from, to, 1), "{edit}");
    }
    for text in [MACHINE, &MACHINE.replace("\"{ball:?}\"", "r#\"{ball:?}\"#")] {
        let refused = edited(text, &on(r#""remove_child", "function": "one", "child": "Ball""#));
        assert_eq!(refused.unwrap_err(), "the code of `one` uses `ball`: remove that use first");
    }
    let docs = edited(MACHINE, &on(r#""set_docs", "function": "two", "docs": "a\rb""#)).unwrap();
    assert!(docs.contains("    /// a\r\n    /// b\r\n    #[state]\r\n    fn two"), "{docs}");
    let open = MACHINE.replacen("_ = format", "_ = { format", 1);
    let refused = edited(&open, &on(r#""add_state", "name": "three", "after": "one""#));
    assert_eq!(refused.unwrap_err(), "the braces of this block are not complete: close them first");
    let docs = Document::new(MACHINE).model().components[0].states[0].function.docs.clone();
    assert_eq!(docs.text, "One.\n\n    code");
    assert_eq!(Span::new(docs.span.unwrap().end, docs.span.unwrap().end + 2).of(MACHINE), "\r\n");
}

const NAMESAKES: &str = "mod one {\n    use crate::parts::Net;\n\n    pub struct A;\n\n    #[component]\n    impl A {\n        \
    fn step(&mut self) {}\n    }\n}\n\nmod two {\n    pub struct A;\n\n    #[component]\n    impl A {\n        \
    fn step(&mut self) {}\n    }\n\n    #[cfg(test)]\n    #[component]\n    impl A {\n        fn step(&mut self) {}\n    }\n}\n";

#[test]
fn components_of_one_name_are_edited_separately() {
    let keys: Vec<String> = Document::new(NAMESAKES).model().components.iter().map(|one| one.key.clone()).collect();
    assert_eq!(keys, ["one::A", "two::A", "two::A#2"]);
    let mut rest = NAMESAKES;
    for key in &keys {
        let body = edited(
            NAMESAKES,
            &format!(r#"{{"edit": "set_body", "component": "{key}", "function": "step", "body": "go();"}}"#),
        )
        .unwrap();
        let at = NAMESAKES.len() - rest.len() + rest.find("{}").unwrap() + 1;
        rest = &NAMESAKES[at..];
        assert_eq!(body, format!("{}\n            go();\n        {}", &NAMESAKES[..at], &NAMESAKES[at..]), "{key}");
    }
    let refusal = edited(NAMESAKES, r#"{"edit": "set_docs", "component": "A", "docs": "Which?"}"#).unwrap_err();
    assert!(refusal.contains("there is `one::A`, `two::A`, `two::A#2`"), "{refusal}");
    let child = |key: &str| {
        let edit = r#"{"edit": "add_child", "function": "step", "child": "Ball", "kind": "requirement", "import": "crate::parts", "#;
        edited(NAMESAKES, &format!(r#"{edit}"component": "{key}"}}"#)).unwrap()
    };
    assert!(child("one::A").contains("mod one {\n    use crate::parts::{Ball, Net};\n"), "{}", child("one::A"));
    assert!(
        child("two::A").contains("mod two {\n    use crate::parts::Ball;\n\n    pub struct A;"),
        "{}",
        child("two::A")
    );
}
