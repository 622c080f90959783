//! Quick fixes: edits that mend a mistake.

use bica_syntax::code::Code;
use serde::Serialize;

use crate::model::{Component, Model, Problem};
use crate::{Document, Edit};

/// Largest number of mistakes for which fixes are searched.
const MAX_MISTAKES: usize = 20;

/// An edit that mends a mistake.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Fix {
    /// Text of its button.
    pub label: String,
    /// The edit.
    pub edit: Edit,
}

/// Returns the fixes of each mistake, in the order of `Model::problems`. Each was tried on the text: it removes the mistake and
/// adds none.
#[must_use]
pub fn fixes(document: &Document) -> Vec<Vec<Fix>> {
    let model = document.model();
    let tried = |(index, problem): (usize, &Problem)| {
        let wished = if index < MAX_MISTAKES { candidates(document.text(), model, problem) } else { Vec::new() };
        wished.into_iter().filter(|fix| mends(document, problem, fix)).collect()
    };
    model.problems.iter().enumerate().map(tried).collect()
}

/// Returns whether an edit removes a mistake and adds none.
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
    let Some(code) = &problem.code else { return Vec::new() };
    let replacement = code.meant().map(|meant| {
        let edit = Edit::Replace { span: problem.span, text: meant.to_owned() };
        Fix { label: format!("Replace `{}` by `{meant}`", problem.span.of(text)), edit }
    });
    let owner = model.components.iter().find(|component| component.span.contains(problem.span));
    replacement.into_iter().chain(owner.into_iter().flat_map(|component| of_machine(component, code))).collect()
}

/// Returns edits that may mend a mistake in a machine.
fn of_machine(of: &Component, code: &Code) -> Vec<Fix> {
    let component = of.key.clone();
    let initial = of.states.iter().find(|one| one.initial).map(|one| &*one.function.name.text);
    let fix = |label, edit| Fix { label, edit };
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
    let set_last = |state: &String, last| Edit::SetLast { component: component.clone(), state: state.clone(), last };
    match code {
        Code::UnknownState { found, .. } => {
            let edit = Edit::AddState {
                component: component.clone(),
                name: found.clone(),
                docs: String::new(),
                initial: false,
                // No transition leaves the new state; if it were not last, it would be a dead end.
                last: true,
                body: String::new(),
                after: None,
            };
            vec![fix(format!("Add last state `{found}`"), edit)]
        }
        Code::NoInitial { first } => {
            let edit = Edit::SetInitial { component: component.clone(), state: first.clone() };
            vec![fix(format!("Start in `{first}`"), edit)]
        }
        Code::Unreachable { state } => {
            let from = initial.map(|from| fix(format!("Add a transition from `{from}`"), transition(from, state)));
            let delete = Edit::Delete { component: component.clone(), function: state.clone() };
            from.into_iter().chain([fix(format!("Remove `{state}`"), delete)]).collect()
        }
        Code::DeadEnd { state } => {
            let to = initial.map(|to| fix(format!("Add a transition to `{to}`"), transition(state, to)));
            [fix(format!("Mark `{state}` as last"), set_last(state, true))].into_iter().chain(to).collect()
        }
        Code::LastButLeft { state, .. } => vec![fix(format!("`{state}` is not last"), set_last(state, false))],
        Code::MisspeltAttribute { .. } | Code::UnknownKey { .. } => Vec::new(),
    }
}
