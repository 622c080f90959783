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

/// A file with a role, a tree and comments at odd places, with these names.
fn odd(role: &str, member: &str, provider: &str, (gap, comma): (&str, &str)) -> String {
    format!(
        "use crate::{{roles::{role}, eye::Ball2}};\n\n/// Sees as [`{role}`] and [`{role}::position`] say; Ball is a word.\n\
         #[component]\nimpl Follow {{\n    fn step(&mut self, ball: &impl{gap}{role}, age: &Age<impl {role}>) {{ \"Ball left\"; }}\n}}\n\
         impl {role}{gap} for Eye {{}}\nimpl roles::{role} for Fake {{}}\n\
         activation_tree! {{\n    pub struct Robot {{ root: Follow, cycle_hz: 50,{gap}\n        roles: {{{gap}{role}{gap}:{gap}{provider}{comma} }},\n        \
         components: [Follow,{gap}Eye,{gap}{member}{gap}={gap}Leg<0>,{gap} right = Leg<1>{comma}] }}\n}}\n"
    )
}

const GAPS: [(&str, &str); 4] = [(" ", ""), ("\n", ","), (" /* Ball, left = */ ", ""), (" // Eye }\n", " ,")];

/// The text after an edit of the tree or of a role.
fn changed(text: &str, edit: serde_json::Value) -> Result<String, String> {
    let mut document = Document::new(text);
    assert_eq!(document.model().problems, [], "{text}");
    document.apply(&[serde_json::from_value(edit).unwrap()]).map_err(|refusal| refusal.to_string())?;
    assert_eq!(document.model().problems, [], "{}", document.text());
    let after = document.text().to_owned();
    document.undo().expect("a step");
    assert_eq!(document.text(), text);
    Ok(after)
}

#[test]
fn a_tree_has_its_members_and_providers() {
    for gap in GAPS {
        let trees = read(&odd("Ball", "left", "Eye", gap)).trees;
        let member = |name: Option<&str>, ty: &str| json!({"name": name, "ty": ty});
        let members = [
            member(None, "Follow"),
            member(None, "Eye"),
            member(Some("left"), "Leg<0>"),
            member(Some("right"), "Leg<1>"),
        ];
        let roles = [json!({"role": "Ball", "provider": "Eye"})];
        assert_eq!(json!(trees), json!([{"name": "Robot", "members": members, "roles": roles}]));
    }
    assert_eq!(read("in_macro! { activation_tree! { struct Robot { components: [Eye] } } }").trees, []);
}

#[test]
fn renames_in_trees_keep_all_other_bytes() {
    for gap in GAPS {
        let text = odd("Ball", "left", "Eye", gap);
        let member = json!({"edit": "rename_member", "tree": "Robot", "member": "left", "to": "front"});
        assert_eq!(changed(&text, member), Ok(odd("Ball", "front", "Eye", gap)));
        let role = json!({"edit": "rename_role", "role": "Ball", "to": "Sphere"});
        assert_eq!(changed(&text, role), Ok(odd("Sphere", "left", "Eye", gap)));
        let provider = json!({"edit": "set_provider", "tree": "Robot", "role": "Ball", "provider": "Leg<1>"});
        assert_eq!(changed(&text, provider), Ok(odd("Ball", "left", "Leg<1>", gap)));
    }
}

#[test]
fn entries_of_trees_are_removed_with_their_commas() {
    let delete = |text: &str, member: &str| {
        changed(text, json!({"edit": "rename_member", "tree": "Robot", "member": member, "to": null})).unwrap()
    };
    for gap in GAPS {
        let text = odd("Ball", "left", "Eye", gap);
        for member in ["left", "right"] {
            let rest = delete(&text, member);
            assert!(!rest.contains(&format!("{member} =")) || gap.0.contains("left ="), "{rest}");
            let comments = |text: &str| [text.matches("/*").count(), text.matches("//").count()];
            assert_eq!(comments(&rest), comments(&text), "comments stay: {rest}");
            let kept = if member == "left" { "Leg<1>" } else { "Leg<0>" };
            assert!(rest.contains(kept) && rest.matches("Leg<").count() == 1, "{rest}");
        }
        let none = json!({"edit": "set_provider", "tree": "Robot", "role": "Ball", "provider": null});
        let rest = changed(&text, none).unwrap();
        let roles = rest.split_once("roles: {").unwrap().1;
        assert!(!roles.replace("Ball, left", "").contains("Ball"), "{rest}");
    }
}

#[test]
fn edits_of_trees_and_roles_say_why_they_are_refused() {
    let text = &odd("Ball", "left", "Eye", (" ", ","));
    let refused = |text: &str, edit: serde_json::Value| changed(text, edit).unwrap_err();
    let member = |member: &str, to: &str| {
        refused(text, json!({"edit": "rename_member", "tree": "Robot", "member": member, "to": to}))
    };
    assert_eq!(member("front", "left"), "`Robot` has no component with the name `front`: there is `left`, `right`");
    assert_eq!(member("left", "right"), "`Robot` has a component `right` already: choose another name");
    assert_eq!(member("left", "Left"), "`Left` looks like a type: begin the name with a small letter");
    assert!(member("left", "fn").contains("keyword"));
    let role = |text: &str, role: &str, to: &str| refused(text, json!({"edit": "rename_role", "role": role, "to": to}));
    assert_eq!(role(text, "Goal", "Net"), "this file has no role `Goal`");
    assert_eq!(role(text, "Ball", "Follow"), "line 5: this file has a `Follow` already: choose another name");
    assert!(role(text, "Ball", "Time").contains("means something else"));
    for other in ["enum Kind { Ball }", "struct Ball;", "fn f<Ball>() {}", "fn f() { other::Ball::new() }"] {
        let message = role(&format!("{text}{other}\n"), "Ball", "Sphere");
        assert!(message.contains("this `Ball` may be no role: rename it in the code"), "{other}: {message}");
    }
    let provider = |role: &str, provider: serde_json::Value| {
        refused(text, json!({"edit": "set_provider", "tree": "Robot", "role": role, "provider": provider}))
    };
    assert!(provider("Goal", json!("Eye")).starts_with("`Robot` has no role `Goal`: there is `Ball`"));
    assert!(provider("Ball", json!("Nose")).contains("has no component `Nose`: there is `Follow`, `Eye`"));
    let tree = json!({"edit": "rename_member", "tree": "Rob", "member": "left", "to": "front"});
    assert_eq!(refused(text, tree), "no tree `Rob` is in this file: there is `Robot`");
    let serves = odd("Ball", "left", "Leg<0>", (" ", ""));
    let delete = json!({"edit": "rename_member", "tree": "Robot", "member": "left", "to": null});
    assert_eq!(refused(&serves, delete), "`Leg<0>` provides `Ball`: name another provider first");
}
