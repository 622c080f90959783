//! Quick fixes of mistakes: edits that mend what a message is about.

use serde::Serialize;

use crate::model::{Component, Model, Problem};
use crate::{Document, Edit};

/// Most mistakes for which fixes are searched.
const MOST: usize = 20;

/// An edit that mends a mistake.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Fix {
    /// What it does, as words on a button.
    pub label: String,
    /// The edit.
    pub edit: Edit,
}

/// The fixes of each mistake of a text, in the order of `Model::problems`; empty lists for mistakes without one. Each was applied to the
/// text: the mistake is gone afterwards, and there are not more mistakes than before.
#[must_use]
pub fn fixes(document: &Document) -> Vec<Vec<Fix>> {
    let model = document.model();
    let tried = |(index, problem): (usize, &Problem)| {
        let wished = if index < MOST { candidates(document.text(), model, problem) } else { Vec::new() };
        wished.into_iter().filter(|fix| mends(document, problem, fix)).collect()
    };
    model.problems.iter().enumerate().map(tried).collect()
}

/// Whether a mistake is gone after an edit, and there are not more mistakes than before.
fn mends(document: &Document, problem: &Problem, fix: &Fix) -> bool {
    let mut trial = Document::new(document.text());
    let same = |problems: &[Problem]| problems.iter().filter(|one| one.message == problem.message).count();
    let before = &document.model().problems;
    trial.apply(std::slice::from_ref(&fix.edit)).is_ok() && {
        let after = &trial.model().problems;
        same(after) < same(before) && after.len() <= before.len()
    }
}

fn candidates(text: &str, model: &Model, problem: &Problem) -> Vec<Fix> {
    let message = &*problem.message;
    // Names in a message stand in backticks.
    let names: Vec<&str> = message.split('`').skip(1).step_by(2).collect();
    let mut found = Vec::new();
    if let Some((_, meant)) = message.split_once("did you mean `") {
        let meant = meant.split('`').next().unwrap_or_default().trim_start_matches("#[").trim_end_matches(']');
        let edit = Edit::Replace { span: problem.span, text: meant.to_owned() };
        found.push(Fix { label: format!("Replace `{}` by `{meant}`", problem.span.of(text)), edit });
    }
    let owner = model.components.iter().find(|component| component.span.contains(problem.span));
    if let (Some(component), [name, ..]) = (owner, &names[..]) {
        found.extend(of_machine(component, problem, name));
    }
    found
}

/// Fixes of mistakes in a machine; `name` is the first name of the message.
fn of_machine(of: &Component, problem: &Problem, name: &str) -> Vec<Fix> {
    let message = &*problem.message;
    let (component, state) = (of.key.clone(), name.to_owned());
    let initial = of.states.iter().find(|one| one.initial).map(|one| one.function.name.text.clone());
    let transition = |from: &str, to: &str| Edit::AddTransition {
        component: component.clone(),
        name: format!("{from}_to_{to}"),
        from: vec![from.to_owned()],
        to: to.to_owned(),
        after_ms: None,
        body: String::new(),
        docs: String::new(),
        after: None,
    };
    let fix = |label: String, edit| Fix { label, edit };
    let set_last = |last| Edit::SetLast { component: component.clone(), state: state.clone(), last };
    if message.starts_with("no state is called") {
        let edit = Edit::AddState {
            component: component.clone(),
            name: state,
            docs: String::new(),
            initial: false,
            // Without a transition that leaves it, it would be the next mistake.
            last: true,
            body: String::new(),
            after: None,
        };
        return vec![fix(format!("Add last state `{name}`"), edit)];
    }
    if message.starts_with("no state is initial") {
        let edit = Edit::SetInitial { component, state };
        return vec![fix(format!("Start in `{name}`"), edit)];
    }
    if message.ends_with("or remove the state") {
        let from = initial.map(|from| fix(format!("Add a transition from `{from}`"), transition(&from, name)));
        let delete = Edit::Delete { component: component.clone(), function: state };
        return from.into_iter().chain([fix(format!("Remove `{name}`"), delete)]).collect();
    }
    if message.starts_with("no transition leaves state") {
        let to = initial.map(|to| fix(format!("Add a transition to `{to}`"), transition(name, &to)));
        return [fix(format!("Mark `{name}` as last"), set_last(true))].into_iter().chain(to).collect();
    }
    if message.contains("is marked `last`, but this transition leaves it") {
        return vec![fix(format!("`{name}` is not last"), set_last(false))];
    }
    Vec::new()
}
