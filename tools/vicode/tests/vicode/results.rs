//! Results of children, transitions on states, and timers that are parameters.

use bica_vicode::compare::{Version, compare};
use bica_vicode::draw::{Diagram, Node, dot};
use bica_vicode::trial::{Step, Trial};
use bica_vicode::{Document, Edit, Layout, read};
use serde_json::json;

const TEXT: &str = "/// Times.
#[derive(Params)]
struct Picking {
    /// Pause.
    #[param(default = 0.5, range = 0.0..=9.0, unit = \"s\")]
    pause: f32,
}

#[component]
impl Picker {
    #[state(initial)]
    #[transition(reach -> held, when = done(Reach))]
    #[transition(reach -> wait, when = failed(Reach), times = 2)]
    #[transition(reach -> lost, when = failed(Reach))]
    fn reach(&mut self, reach: &mut Reach) {}

    #[state]
    #[transition(wait -> reach, after = Picking::pause)]
    fn wait(&mut self) {}

    #[state(done)]
    fn held(&mut self) {}

    #[state(failed)]
    fn lost(&mut self) {}
}
";

/// The text after an edit, or why it is refused.
fn edited(mut edit: serde_json::Value) -> Result<String, String> {
    let mut document = Document::new(TEXT);
    edit["component"] = json!("Picker");
    let edit: Edit = serde_json::from_value(edit).unwrap();
    document.apply(&[edit]).map_err(|refusal| refusal.to_string())?;
    Ok(document.text().to_owned())
}

#[test]
fn drawings_show_results_and_retries() {
    let model = read(TEXT);
    assert_eq!(model.problems, []);
    let diagram = Diagram::of(&model.components[0], &Layout::default());
    assert_eq!(
        diagram.nodes.iter().map(Node::title).collect::<Vec<_>>(),
        ["reach", "wait", "held [done]", "lost [failed]"]
    );
    let labels: Vec<_> = diagram.edges.iter().flat_map(|edge| &edge.labels).map(|label| &*label.text).collect();
    let expected = ["done(Reach)", "failed(Reach) 2 times", "failed(Reach)", "timer after Picking::pause"];
    assert_eq!(labels, expected);
    assert!(dot(&model.components[0]).contains("failed(Reach) 2 times"));
}

#[test]
fn drawings_show_ages_and_outcomes() {
    let asking = TEXT.replace("fn reach(&mut self, reach", "fn reach(&mut self, age: &Age<impl Ball>, reach").replace(
        "    #[state]\n",
        "    #[transition(reach -> wait)]\n    fn stops(&self, reach: &Outcome<Reach>) -> bool { reach.is_failed() }\n\n    #[state]\n",
    );
    let model = read(&asking);
    assert_eq!(model.problems, []);
    let diagram = Diagram::of(&model.components[0], &Layout::default());
    assert_eq!(diagram.nodes[0].lines(), ["> Reach", "? age of impl Ball"]);
    assert!(dot(&model.components[0]).contains("[label=\"stops (outcome of Reach)\"]"));
}

#[test]
fn results_are_edited_and_follow_names() {
    let arrow = |edit: &str, more: serde_json::Value| {
        let mut all = json!({"edit": edit, "transition": "reach"});
        all.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        edited(all)
    };
    let times = arrow("set_wait", json!({"arrow": 1, "key": "times", "value": "5"})).unwrap();
    assert!(times.contains("failed(Reach), times = 5)"));
    let timer = arrow("set_wait", json!({"arrow": 0, "key": "after", "value": "Picking::pause"})).unwrap();
    assert!(timer.contains("when = done(Reach), after = Picking::pause)"), "{timer}");
    let constant = edited(json!({"edit": "set_timer", "transition": "wait", "after_ms": 7})).unwrap();
    assert!(constant.contains("(wait -> reach, after_ms = 7)"), "{constant}");
    let added = json!({"from": ["reach"], "to": "held", "after_ms": 900, "when": "failed(Reach)"});
    assert!(
        arrow("add_arrow", added)
            .unwrap()
            .contains("#[transition(reach -> held, after_ms = 900, when = failed(Reach))]\n")
    );
    let end = |word| edited(json!({"edit": "set_end", "state": "lost", "end": word})).unwrap();
    assert!(end("done").contains("#[state(done)]\n    fn lost") && end("last").contains("#[state(last)]\n    fn lost"));
    let renamed = edited(json!({"edit": "rename", "function": "wait", "to": "rest"})).unwrap();
    assert!(renamed.contains("(reach -> rest, when") && renamed.contains("(rest -> reach, after"), "{renamed}");
    let deleted = edited(json!({"edit": "delete", "function": "wait"})).unwrap();
    assert!(!deleted.contains("times = 2") && read(&deleted).problems.is_empty(), "{deleted}");
    let copied = edited(json!({"edit": "copy", "function": "reach", "name": "again"})).unwrap();
    assert!(copied.contains("#[transition(again -> wait, when = failed(Reach), times = 2)]"), "{copied}");
}

#[test]
fn what_no_transition_can_wait_for_is_refused() {
    for (edit, message) in [
        (json!({"edit": "set_wait", "transition": "reach", "key": "times", "value": "0"}), "from 1 to 126"),
        (
            json!({"edit": "set_wait", "transition": "reach", "key": "when", "value": "ready(Reach)"}),
            "`done` and `failed`",
        ),
        (json!({"edit": "set_wait", "transition": "wait", "key": "after", "value": "900"}), "after_ms = 1500"),
        (json!({"edit": "set_sources", "transition": "reach", "from": ["wait"]}), "only `reach`"),
        (json!({"edit": "set_end", "state": "lost", "end": "stuck"}), "`failed`"),
    ] {
        let refusal = edited(edit).unwrap_err();
        assert!(refusal.contains(message), "{refusal}");
    }
}

#[test]
fn a_trial_counts_and_waits_as_the_tree() {
    let model = read(TEXT);
    let steps = [Step::Switch { condition: "failed(Reach)".to_owned(), on: true }, Step::Run(5000)];
    let trial = Trial::run(&model.components[0], TEXT, 100.0, &steps).unwrap();
    let visits: Vec<_> = trial.visits.iter().map(|visit| (&*visit.state, visit.from_us / 1000)).collect();
    let expected = [("reach", 0), ("wait", 0), ("reach", 500), ("wait", 510), ("reach", 1010), ("lost", 1020)];
    assert_eq!(visits, expected);
}

#[test]
fn a_changed_retry_is_a_difference() {
    let after = TEXT.replace("times = 2", "times = 3").replace("#[state(failed)]", "#[state(last)]");
    let (old, new) = (read(TEXT), read(&after));
    let found = compare(Version { text: TEXT, model: &old }, Version { text: &after, model: &new });
    let text = format!("{found:?}");
    assert!(text.contains("times") && text.contains("ends"), "{text}");
}
