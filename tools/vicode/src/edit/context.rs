//! Text and model that an edit changes, and the lookup of their parts by name.

use super::request::Refusal;
use super::style::Style;
use crate::model::{Arrow, Component, Function, Model, Transition};

/// Text and model that an edit changes.
pub(super) struct Context<'a> {
    pub(super) text: &'a str,
    pub(super) model: &'a Model,
    /// Maximum line length of new code, characters.
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

/// Returns the function of that name; refuses an unknown or ambiguous one.
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

/// Returns the transition of that name; refuses an unknown one.
pub(super) fn transition<'a>(component: &'a Component, name: &str) -> Result<&'a Transition, Refusal> {
    component.transition(name).ok_or_else(|| {
        let known = list(component.transitions.iter().map(|one| &*one.function.name.text));
        Refusal::new(format!("`{}` has no transition `{name}`: there is {known}", component.name.text))
    })
}

/// Returns the `#[transition]` attributes of a transition or a state.
pub(super) fn arrows<'a>(component: &'a Component, name: &str) -> Result<&'a [Arrow], Refusal> {
    component.state(name).map_or_else(|| transition(component, name).map(|one| &*one.arrows), |one| Ok(&one.arrows))
}

/// Returns one of them.
pub(super) fn arrow<'a>(component: &'a Component, name: &str, index: usize) -> Result<&'a Arrow, Refusal> {
    let arrows = arrows(component, name)?;
    arrows.get(index).ok_or_else(|| {
        Refusal::new(format!("transition `{name}` has {} attributes: there is no number {index}", arrows.len()))
    })
}

/// Refuses the name of an unknown state.
pub(super) fn state(component: &Component, name: &str) -> Result<(), Refusal> {
    if component.state(name).is_some() {
        return Ok(());
    }
    let known = list(component.states.iter().map(|state| &*state.function.name.text));
    Err(Refusal::new(format!("no state is called `{name}`: there is {known}")))
}

/// Formats names in backticks, separated by commas; `none` without any.
pub(super) fn list<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    if names.is_empty() { "none".to_owned() } else { names.join(", ") }
}
