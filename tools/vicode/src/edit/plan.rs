//! Translation of edits into splices.

use super::context::Context;
use super::request::{Edit, Refusal};
use super::splice::{Splice, applied, ordered};
use super::{children, delete, docs, functions, imports, machine, options, rename, role, table, tree};
use crate::model::{Model, Reporter};
use crate::read::read;

/// Returns the splices of an edit, in order, with text and model afterwards; `width` is the longest line of new code, characters.
///
/// # Errors
/// If the edit does not fit the text, or would add mistakes.
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

/// Refuses an edit that adds mistakes.
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

/// Returns whether an edit is refused if it adds a mistake of the macros. Other edits may leave a machine incomplete until the next edit.
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
            | Edit::RenameMember { .. }
            | Edit::SetProvider { .. }
            | Edit::RenameRole { .. }
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
        | Edit::SetEnd { .. }
        | Edit::SetWait { .. }
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
        Edit::RenameMember { tree, member, to } => tree::member(context, tree, member, to.as_deref()),
        Edit::SetProvider { tree, role, provider } => tree::provider(context, tree, role, provider.as_deref()),
        Edit::RenameRole { role, to } => role::rename(context, role, to),
        Edit::Replace { span, text } => Ok(vec![Splice::new(*span, text)]),
    }
}
