//! Attributes of states, transitions and hooks.

use bica_syntax::component::guard;

use super::context::{Context, arrow as arrow_of, arrows, state, transition};
use super::layout::attribute_removal;
use super::request::{Edit, Refusal};
use super::splice::Splice;
use super::style::indentation;
use crate::model::{Arrow, Component, Span, State};
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
            splices.push(words(text, found, true, found.end_word()));
            Ok(splices)
        }
        Edit::SetLast { component, state: name, last } => {
            end(text, find(context.component(component)?, name)?, last.then_some("last"))
        }
        Edit::SetEnd { component, state: name, end: word } => {
            end(text, find(context.component(component)?, name)?, word.as_deref())
        }
        Edit::AddArrow { component, transition: name, from, to, after_ms, when } => {
            let component = context.component(component)?;
            let list = arrow(component, from, to, *after_ms)? + &waits(when.as_deref())?;
            if component.state(name).is_some() {
                on_its_state(name, from)?;
            }
            let attribute = component.state(name).map(|state| state.attribute);
            let Some(last) = arrows(component, name)?.last().map(|last| last.span).or(attribute) else {
                return Err(Refusal::new(format!("correct the attribute of transition `{name}` first")));
            };
            let (newline, indent) = (context.style(component).newline, indentation(text, last.start));
            Ok(vec![Splice::insert(last.end, format!("{newline}{indent}#[transition({list})]"))])
        }
        Edit::RemoveArrow { component, transition: name, arrow } => {
            let component = context.component(component)?;
            if component.state(name).is_none() && transition(component, name)?.arrows.len() < 2 {
                return Err(Refusal::new(format!("this is the only arrow of `{name}`: delete the transition instead")));
            }
            Ok(vec![Splice::remove(attribute_removal(text, arrow_of(component, name, *arrow)?.span))])
        }
        Edit::SetSources { component, transition: name, arrow, from } => {
            let component = context.component(component)?;
            if component.state(name).is_some() {
                on_its_state(name, from)?;
            }
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
            let timer = arrow.place("after_ms").or(arrow.place("after"));
            Ok(vec![key(text, arrow, timer, "after_ms", after_ms.map(|ms| ms.to_string()).as_deref())])
        }
        Edit::SetWait { component, transition: name, arrow, key: word, value } => {
            let arrow = arrow_of(context.component(component)?, name, *arrow)?;
            let place = if word == "after" { arrow.place("after_ms") } else { None };
            let splice = key(text, arrow, arrow.place(word).or(place), word, value.as_deref());
            waits_of(word, value.as_deref())?;
            Ok(vec![splice])
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

/// Sets the word that marks a state as an end.
fn end(text: &str, state: &State, word: Option<&str>) -> Result<Vec<Splice>, Refusal> {
    if let Some(word) = word.filter(|word| !["last", "done", "failed"].contains(word)) {
        return Err(Refusal::new(format!("there is no end `{word}`: there is `last`, `done` and `failed`")));
    }
    let is_same = state.end_word() == word;
    Ok(if is_same { Vec::new() } else { vec![words(text, state, state.initial, word)] })
}

/// Sets or removes a key behind an arrow; `place` is that of the old value.
fn key(text: &str, arrow: &Arrow, place: Option<Span>, word: &str, value: Option<&str>) -> Splice {
    let new = value.map_or_else(String::new, |value| format!(", {word} = {value}"));
    let end =
        ["after_ms", "after", "when", "times"].into_iter().filter_map(|key| arrow.place(key)).map(|span| span.end);
    let end = end.max().unwrap_or(arrow.to.span.end);
    Splice::keeping_comments(text, place.unwrap_or(Span::at(end)), new)
}

/// Refuses a value that no transition can have.
fn waits_of(word: &str, value: Option<&str>) -> Result<(), Refusal> {
    let Some(value) = value else { return Ok(()) };
    if !["after", "when", "times"].contains(&word) {
        return Err(Refusal::new(format!("a transition has no `{word}`: there is `after`, `when` and `times`")));
    }
    // A result has to be there where its answers are counted.
    let around = if word == "times" { ", when = failed(Child)" } else { "" };
    let read = guard(&format!(", {word} = {value}{around}"));
    read.map(|_| ()).map_err(|mistake| Refusal::new(mistake.to_string()))
}

/// `, when = failed(Reach)`
fn waits(when: Option<&str>) -> Result<String, Refusal> {
    waits_of("when", when)?;
    Ok(when.map_or_else(String::new, |when| format!(", when = {when}")))
}

/// Refuses other states before a transition on a state.
fn on_its_state(name: &str, from: &[String]) -> Result<(), Refusal> {
    if from == [name] {
        return Ok(());
    }
    Err(Refusal::new(format!("a transition on a state leaves that state: only `{name}` can be its source")))
}

/// Removes the word `initial` from all states.
pub(super) fn no_longer_initial(text: &str, component: &Component) -> Vec<Splice> {
    let initial = component.states.iter().filter(|state| state.initial);
    initial.map(|state| words(text, state, false, state.end_word())).collect()
}

/// Writes the attribute of a state.
pub(super) fn words(text: &str, state: &State, initial: bool, word: Option<&str>) -> Splice {
    let attribute = state.attribute.of(text);
    let start = attribute.find("state").map_or(0, |at| at + "state".len());
    let end = attribute.rfind(']').unwrap_or(attribute.len()).max(start);
    let span = Span::new(state.attribute.start + start, state.attribute.start + end);
    let words: Vec<&str> = initial.then_some("initial").into_iter().chain(word).collect();
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
