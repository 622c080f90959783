//! Roles in place of children.

use bica_vicode::model::LinkKind;
use bica_vicode::{Document, Edit, read};
use serde_json::json;

const TEXT: &str = "use crate::roles::Ball;

#[role]
pub trait Legs {
    fn walk(&mut self);
}

#[component]
impl Follow {
    fn step(&mut self, ball: &impl Ball, legs: &mut impl Legs) {
        legs.walk();
    }
}

activation_tree! {
    pub struct Robot {
        root: Follow,
        cycle_hz: 50,
        roles: { Ball: Eye, Legs: Body },
        components: [Follow, Eye, Body],
    }
}
";

/// The text after an edit, or why it is refused.
fn edited(edit: serde_json::Value) -> Result<String, String> {
    let mut document = Document::new(TEXT);
    let edit: Edit = serde_json::from_value(edit).unwrap();
    document.apply(&[edit]).map_err(|refusal| refusal.to_string())?;
    Ok(document.text().to_owned())
}

#[test]
fn a_role_is_read_as_a_child() {
    let model = read(TEXT);
    assert_eq!(model.problems, []);
    let links: Vec<_> = model.components[0].links().into_iter().map(|link| (link.child, link.kind)).collect();
    let link = |child: &str, kind| (child.to_owned(), kind);
    assert_eq!(links, [link("impl Ball", LinkKind::Requirement), link("impl Legs", LinkKind::Modulation)]);
}

#[test]
fn mistakes_in_roles_are_reported() {
    let problem = |from: &str, to: &str| {
        let text = TEXT.replace(from, to);
        let problems = read(&text).problems;
        assert_eq!(problems.len(), 1, "{problems:?}");
        problems[0].span.of(&text).to_owned()
    };
    assert_eq!(problem("fn walk(&mut self);", "fn walk();"), "walk");
    assert_eq!(problem("Ball: Eye,", "Legs: Eye,"), "Legs");
    assert_eq!(problem("&impl Ball", "&impl Ball<f32>"), "impl Ball<f32>");
}

#[test]
fn children_by_role_are_added_changed_and_removed() {
    let add = json!({
        "edit": "add_child", "component": "Follow", "function": "step", "child": "impl Goal", "kind": "requirement",
        "import": "crate::roles"
    });
    let text = edited(add).unwrap();
    assert!(text.contains("legs: &mut impl Legs, goal: &impl Goal)"), "{text}");
    assert!(text.contains("use crate::roles::{Ball, Goal};"), "{text}");
    let change = |kind: &str| {
        edited(
            json!({"edit": "set_child_kind", "component": "Follow", "function": "step", "child": "impl Ball", "kind": kind}),
        )
    };
    assert!(change("modulation").unwrap().contains("ball: &mut impl Ball,"));
    assert!(change("rate").unwrap_err().contains("`Ball` is a role"));
    let remove =
        edited(json!({"edit": "remove_child", "component": "Follow", "function": "step", "child": "impl Ball"}))
            .unwrap();
    assert!(remove.contains("fn step(&mut self, legs: &mut impl Legs)"), "{remove}");
    assert!(remove.contains("use crate::roles::Ball;"), "the tree names it: {remove}");
}
