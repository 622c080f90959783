//! Attributes of states, transitions and hooks.

use super::context::{Context, arrow as arrow_of, state, transition};
use super::layout::attribute_removal;
use super::request::{Edit, Refusal};
use super::splice::Splice;
use super::style::indentation;
use crate::model::{Component, Span, State};
use crate::read::is_keyword;

/// Changes an attribute.
pub(super) fn change(context: &Context<'_>, edit: &Edit) -> Result<Vec<Splice>, Refusal> {
    let text = context.text;
    match edit {
        Edit::SetInitial { component, state: name } => {
            let component = context.component(component)?;
            let found = find(component, name)?;
            if found.initial {
                return Ok(Vec::new());
            }
            let mut splices = no_longer_initial(text, component);
            splices.push(words(text, found, true, found.last));
            Ok(splices)
        }
        Edit::SetLast { component, state: name, last } => {
            let found = find(context.component(component)?, name)?;
            Ok(if found.last == *last { Vec::new() } else { vec![words(text, found, found.initial, *last)] })
        }
        Edit::AddArrow { component, transition: name, from, to, after_ms } => {
            let component = context.component(component)?;
            let list = arrow(component, from, to, *after_ms)?;
            let transition = transition(component, name)?;
            let Some(last) = transition.arrows.last() else {
                return Err(Refusal::at(
                    transition.function.name.span,
                    "correct the attribute of this transition first",
                ));
            };
            let (newline, indent) = (context.style(component).newline, indentation(text, last.span.start));
            Ok(vec![Splice::insert(last.span.end, format!("{newline}{indent}#[transition({list})]"))])
        }
        Edit::RemoveArrow { component, transition: name, arrow } => {
            let component = context.component(component)?;
            if transition(component, name)?.arrows.len() < 2 {
                return Err(Refusal::new(format!("this is the only arrow of `{name}`: delete the transition instead")));
            }
            Ok(vec![Splice::remove(attribute_removal(text, arrow_of(component, name, *arrow)?.span))])
        }
        Edit::SetSources { component, transition: name, arrow, from } => {
            let component = context.component(component)?;
            let old = arrow_of(component, name, *arrow)?.from_span;
            Ok(vec![Splice::keeping_comments(text, old, sources(component, from)?)])
        }
        Edit::SetTarget { component, transition: name, arrow, to } => {
            let component = context.component(component)?;
            state(component, to)?;
            Ok(vec![Splice::new(arrow_of(component, name, *arrow)?.to.span, written(to))])
        }
        Edit::SetTimer { component, transition: name, arrow, after_ms } => {
            let arrow = arrow_of(context.component(component)?, name, *arrow)?;
            let new = after_ms.map_or_else(String::new, |ms| format!(", after_ms = {ms}"));
            let at = arrow.after_ms.map_or(Span::at(arrow.to.span.end), |(_, span)| span);
            Ok(vec![Splice::keeping_comments(text, at, new)])
        }
        Edit::SetHookStates { component, hook, states } => {
            hook_states(text, context.component(component)?, hook, states)
        }
        _ => Ok(Vec::new()),
    }
}

fn hook_states(text: &str, component: &Component, name: &str, states: &[String]) -> Result<Vec<Splice>, Refusal> {
    let hook = component.hooks.iter().find(|hook| hook.function.name.text == name);
    let hook = hook.ok_or_else(|| Refusal::new(format!("`{}` has no hook `{name}`", component.name.text)))?;
    let Some(list) = hook.list else {
        return Err(Refusal::at(hook.attribute, format!("`{name}` is no hook of states")));
    };
    if states.is_empty() {
        return Err(Refusal::new(format!("hook `{name}` would have no state: delete it")));
    }
    states.iter().try_for_each(|one| state(component, one))?;
    Ok(vec![Splice::keeping_comments(text, list, names(states))])
}

fn find<'a>(component: &'a Component, name: &str) -> Result<&'a State, Refusal> {
    state(component, name)?;
    component.state(name).ok_or_else(|| Refusal::new(format!("no state is called `{name}`")))
}

/// Removes the word `initial` from all states.
pub(super) fn no_longer_initial(text: &str, component: &Component) -> Vec<Splice> {
    let initial = component.states.iter().filter(|state| state.initial);
    initial.map(|state| words(text, state, false, state.last)).collect()
}

/// Writes the attribute of a state.
pub(super) fn words(text: &str, state: &State, initial: bool, last: bool) -> Splice {
    let attribute = state.attribute.of(text);
    let start = attribute.find("state").map_or(0, |at| at + "state".len());
    let end = attribute.rfind(']').unwrap_or(attribute.len()).max(start);
    let span = Span::new(state.attribute.start + start, state.attribute.start + end);
    let words: Vec<&str> =
        [(initial, "initial"), (last, "last")].iter().filter(|(on, _)| *on).map(|(_, word)| *word).collect();
    let list = Splice::keeping_comments(text, span, words.join(", ")).text;
    if words.is_empty() {
        let comments = if list.is_empty() { list } else { format!(" {list}") };
        return Splice::new(span, comments);
    }
    Splice::new(span, format!("({list})"))
}

/// `a | b -> c, after_ms = N`
pub(super) fn arrow(
    component: &Component,
    from: &[String],
    to: &str,
    after_ms: Option<u32>,
) -> Result<String, Refusal> {
    state(component, to)?;
    let timer = after_ms.map_or_else(String::new, |ms| format!(", after_ms = {ms}"));
    Ok(format!("{} -> {}{timer}", sources(component, from)?, written(to)))
}

/// `a | b`, or `*`
fn sources(component: &Component, from: &[String]) -> Result<String, Refusal> {
    if from == ["*"] {
        return Ok("*".to_owned());
    }
    if from.is_empty() {
        return Err(Refusal::new("a transition leaves at least one state: name it, or write `*` for all"));
    }
    from.iter().try_for_each(|one| state(component, one))?;
    if let Some((at, twice)) = from.iter().enumerate().find(|(at, one)| from[..*at].contains(one)) {
        return Err(Refusal::new(format!("state `{twice}` is named twice, the second time as number {}", at + 1)));
    }
    Ok(names(from))
}

/// `a | b`
pub(super) fn names(states: &[String]) -> String {
    states.iter().map(|name| written(name)).collect::<Vec<_>>().join(" | ")
}

/// Formats a name, with `r#` if it is a keyword.
pub(super) fn written(name: &str) -> String {
    if is_keyword(name) { format!("r#{name}") } else { name.to_owned() }
}
