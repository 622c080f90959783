//! From an edit to splices.

use super::request::{Edit, Refusal};
use super::splice::{Splice, applied, ordered};
use super::style::Style;
use super::{children, delete, docs, functions, imports, machine, options, rename, table};
use crate::model::{Arrow, Component, Function, Model, Reporter, Transition};
use crate::read::read;

/// What an edit works on.
pub(super) struct Context<'a> {
    pub(super) text: &'a str,
    pub(super) model: &'a Model,
    pub(super) width: usize,
}

impl<'a> Context<'a> {
    pub(super) fn component(&self, name: &str) -> Result<&'a Component, Refusal> {
        self.model.component(name).ok_or_else(|| {
            let known = list(self.model.components.iter().map(|component| &*component.key));
            Refusal::new(format!("no component `{name}` is in this file: there is {known}"))
        })
    }

    pub(super) fn style(&self, component: &Component) -> Style {
        Style::of(self.text, Some(component), self.width)
    }
}

/// The function of that name, or why not.
pub(super) fn function<'a>(component: &'a Component, name: &str) -> Result<&'a Function, Refusal> {
    let mut named = component.functions().filter(|function| function.name.text == name);
    match (named.next(), named.next()) {
        (Some(function), None) => Ok(function),
        (Some(_), Some(second)) => Err(Refusal::at(
            second.name.span,
            format!("`{name}` is written twice in this block: change it in the code"),
        )),
        (None, _) => {
            let known = list(component.functions().map(|function| &*function.name.text));
            Err(Refusal::new(format!("`{}` has no function `{name}`: there is {known}", component.name.text)))
        }
    }
}

/// The transition of that name, or why not.
pub(super) fn transition<'a>(component: &'a Component, name: &str) -> Result<&'a Transition, Refusal> {
    component.transition(name).ok_or_else(|| {
        let known = list(component.transitions.iter().map(|one| &*one.function.name.text));
        Refusal::new(format!("`{}` has no transition `{name}`: there is {known}", component.name.text))
    })
}

/// One `#[transition]` of several.
pub(super) fn arrow<'a>(component: &'a Component, name: &str, index: usize) -> Result<&'a Arrow, Refusal> {
    let arrows = &transition(component, name)?.arrows;
    arrows.get(index).ok_or_else(|| {
        Refusal::new(format!("transition `{name}` has {} attributes: there is no number {index}", arrows.len()))
    })
}

/// Refuses a name without a state.
pub(super) fn state(component: &Component, name: &str) -> Result<(), Refusal> {
    if component.state(name).is_some() {
        return Ok(());
    }
    let known = list(component.states.iter().map(|state| &*state.function.name.text));
    Err(Refusal::new(format!("no state is called `{name}`: there is {known}")))
}

/// `a`, `b`, `c`
pub(super) fn list<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    if names.is_empty() { "none".to_owned() } else { names.join(", ") }
}

/// The splices of an edit of a text, in order, and the text after them; `width` is the longest line of new code.
///
/// # Errors
/// If the edit does not fit the text, or if the text would be worse Rust afterwards.
pub fn plan(text: &str, model: &Model, edit: &Edit, width: usize) -> Result<(Vec<Splice>, String, Model), Refusal> {
    let context = Context { text, model, width };
    let splices = splices(&context, edit)?;
    let splices = ordered(text, splices).ok_or_else(|| Refusal::new("this part of the text does not exist"))?;
    let after = applied(text, &splices);
    let changed = read(&after);
    if !matches!(edit, Edit::Replace { .. }) {
        accepted(model, &changed, edit)?;
    }
    Ok((splices, after, changed))
}

/// Refuses an edit after which more is wrong than before.
fn accepted(before: &Model, after: &Model, edit: &Edit) -> Result<(), Refusal> {
    for (from, why) in [(Reporter::Syntax, "the file would no longer be Rust: "), (Reporter::Macro, "")] {
        let of = |model: &Model| -> Vec<String> {
            let all = model.problems.iter().filter(|problem| problem.from == from);
            all.map(|problem| problem.message.clone()).collect()
        };
        let (old, new) = (of(before), of(after));
        let count = |messages: &[String], message: &String| messages.iter().filter(|one| *one == message).count();
        let added = new.iter().find(|message| count(&new, message) > count(&old, message));
        if let (Some(message), true, true) = (added, new.len() > old.len(), from == Reporter::Syntax || is_local(edit))
        {
            return Err(Refusal::new(format!("{why}{message}")));
        }
    }
    Ok(())
}

/// Whether the edit alone decides if the macro accepts its result. A machine that is being drawn is incomplete for a while.
const fn is_local(edit: &Edit) -> bool {
    matches!(
        edit,
        Edit::AddChild { .. }
            | Edit::RemoveChild { .. }
            | Edit::SetChildKind { .. }
            | Edit::SetDefault { .. }
            | Edit::SetOption { .. }
            | Edit::SetTimer { .. }
            | Edit::SetBody { .. }
            | Edit::SetDocs { .. }
            | Edit::Rename { .. }
            | Edit::Move { .. }
    )
}

fn splices(context: &Context<'_>, edit: &Edit) -> Result<Vec<Splice>, Refusal> {
    match edit {
        Edit::AddState { .. } | Edit::AddTransition { .. } | Edit::AddHook { .. } | Edit::InsertCode { .. } => {
            functions::add(context, edit)
        }
        Edit::Rename { component, function, to } => rename::rename(context, component, function, to),
        Edit::Delete { component, function } => delete::delete(context, component, function),
        Edit::Move { component, function, before } => functions::shift(context, component, function, before.as_deref()),
        Edit::Copy { component, function, name } => functions::copy(context, component, function, name),
        Edit::SetBody { component, function, body } => functions::body(context, component, function, body),
        Edit::SetInitial { .. }
        | Edit::SetLast { .. }
        | Edit::AddArrow { .. }
        | Edit::RemoveArrow { .. }
        | Edit::SetSources { .. }
        | Edit::SetTarget { .. }
        | Edit::SetTimer { .. }
        | Edit::SetHookStates { .. } => machine::change(context, edit),
        Edit::SetDocs { component, function, docs } => docs::set(context, component, function.as_deref(), docs),
        Edit::SetOption { component, option, value } => options::set(context, component, option, value.as_deref()),
        Edit::AddChild { .. } | Edit::RemoveChild { .. } | Edit::SetChildKind { .. } => children::change(context, edit),
        Edit::AddImport { import, name } => imports::name(context, import, name),
        Edit::SetDefault { parameters, parameter, value } => options::default(context, parameters, parameter, value),
        Edit::SetNumbers { table, numbers } => table::set(context, table, numbers),
        Edit::InsertRow { table, before, copy, code } => table::insert(context, table, *before, *copy, code),
        Edit::DeleteRow { table, row } => table::delete(context, table, *row),
        Edit::Replace { span, text } => Ok(vec![Splice::new(*span, text)]),
    }
}
