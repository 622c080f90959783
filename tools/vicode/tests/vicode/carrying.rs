//! Found values of transitions, and before hooks.

use bica_vicode::compare::{Version, compare};
use bica_vicode::draw::{Diagram, Node, dot, mermaid};
use bica_vicode::model::{HookRole, Input, LinkKind};
use bica_vicode::{Document, Edit, Layout, read};
use serde_json::json;

const TEXT: &str = "#[component]
impl A {
    #[state(initial)]
    fn look(&mut self) {}

    #[state]
    fn kick(&mut self) {}

    #[before(look | kick)]
    fn plan(&mut self, ball: &Ball) {}

    #[transition(look -> kick)]
    fn near(&self, ball: &Ball) -> Option<plan::Kick<2>> {
        ball.kick()
    }

    #[transition(kick -> look, after_ms = 500)]
    fn kicked(&self) -> bool {
        true
    }

    #[entry(kick)]
    fn choose(&mut self, kick: Found<plan::Kick<2>>) {}
}
";

/// The text after an edit.
fn edited(edit: serde_json::Value) -> String {
    let mut document = Document::new(TEXT);
    let edit: Edit = serde_json::from_value(edit).unwrap();
    document.apply(&[edit]).unwrap();
    document.text().to_owned()
}

#[test]
fn carried_types_and_hooks_before_are_read() {
    let model = read(TEXT);
    assert_eq!(model.problems, []);
    let component = &model.components[0];
    let carried: Vec<_> = component.transitions.iter().map(|one| one.function.carries.as_ref()).collect();
    assert_eq!(carried[0].map(|of| (&*of.text, of.span.of(TEXT))), Some(("plan::Kick<2>", "plan::Kick<2>")));
    assert_eq!(carried[1], None);
    assert_eq!((component.takes("kick"), component.takes("look")), (Some("plan::Kick<2>"), None));
    let [plan, choose] = &component.hooks[..] else { panic!("two hooks") };
    assert_eq!((plan.role, plan.states.len()), (HookRole::Before, 2));
    assert_eq!(choose.function.arguments[0].input, Input::Found { of: "plan::Kick<2>".to_owned() });
    let links: Vec<_> = component.links().into_iter().map(|link| (link.state, link.child, link.kind)).collect();
    let ball = |state| (Some(state), "Ball".to_owned(), LinkKind::Requirement);
    assert_eq!(links, [ball(0), ball(1)], "also of the state whose transitions do not read it");
}

#[test]
fn drawings_show_what_a_state_takes() {
    let component = &read(TEXT).components[0];
    let diagram = Diagram::of(component, &Layout::default());
    assert_eq!(diagram.nodes.iter().map(Node::title).collect::<Vec<_>>(), ["look", "kick ← plan::Kick<2>"]);
    assert!(diagram.nodes[0].lines().contains(&"before / plan".to_owned()));
    assert!(dot(component).contains("kick ← plan::Kick<2>"));
    assert!(mermaid(component).contains("state \"kick ← plan#58;#58;Kick#60;2#62;\" as kick"));
}

#[test]
fn a_new_transition_carries_what_its_state_takes() {
    let transition = |to: &str| {
        edited(json!({"edit": "add_transition", "component": "A", "name": "again", "from": ["kick"], "to": to}))
    };
    assert!(transition("kick").contains("fn again(&self) -> Option<plan::Kick<2>> {\n        None\n    }"));
    assert!(transition("look").contains("fn again(&self) -> bool {\n        false\n    }"));
    let both = transition("kick");
    assert_eq!(read(&both).problems, []);
}

#[test]
fn renaming_and_deleting_reach_hooks_before() {
    let renamed = edited(json!({"edit": "rename", "component": "A", "function": "look", "to": "seek"}));
    assert!(renamed.contains("#[before(seek | kick)]"));
    let deleted = edited(json!({"edit": "delete", "component": "A", "function": "kick"}));
    assert!(deleted.contains("#[before(look)]") && !deleted.contains("Found"), "{deleted}");
    let hook = json!({"edit": "set_hook_states", "component": "A", "hook": "plan", "states": ["kick"]});
    assert!(edited(hook).contains("#[before(kick)]"));
}

#[test]
fn a_changed_type_is_a_difference() {
    let after = TEXT.replace("Option<plan::Kick<2>>", "Option<Pass>").replace("Found<plan::Kick<2>>", "Found<Pass>");
    let (old, new) = (read(TEXT), read(&after));
    let found = compare(Version { text: TEXT, model: &old }, Version { text: &after, model: &new });
    let text = format!("{found:?}");
    assert!(text.contains("carries") && text.contains("Pass"), "{text}");
}
