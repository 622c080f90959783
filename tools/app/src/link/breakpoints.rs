//! Breakpoints of a program, from a file.

use std::fs;
use std::path::Path;

use bica_wire::message::{Stop, StopAt};
use bica_wire::model::{Description, Invalid};

use crate::console::Failure;

/// Reads a file with a state or a transition on each line, as `Player.kick`. `#` begins a comment.
///
/// # Errors
/// If the file cannot be read, has no breakpoint, or names what the tree does not have.
pub(super) fn read(file: &Path, tree: &Description) -> Result<Vec<Stop>, Failure> {
    let shown = file.display();
    let failed = |error| Failure::new(format!("{shown} cannot be read: {error}"), "give a file of breakpoints");
    let text = fs::read_to_string(file).map_err(failed)?;
    let mut stops = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let place = line.split('#').next().unwrap_or_default().trim();
        if !place.is_empty() {
            let at = |invalid: Invalid| Invalid::new(format!("{shown}:{}: {}", number + 1, invalid.what), invalid.help);
            stops.extend(find(place, tree).map_err(at)?);
        }
    }
    if stops.is_empty() {
        return Err(Failure::new(format!("{shown} has no breakpoint"), "write one on each line, as `Player.kick`"));
    }
    Ok(stops)
}

/// Returns a breakpoint at a state, or one for each transition of a name.
fn find(place: &str, tree: &Description) -> Result<Vec<Stop>, Invalid> {
    let form =
        || Invalid::new(format!("`{place}` is no breakpoint"), "write a component and its state, as `Player.kick`");
    let (component, name) = place.split_once('.').ok_or_else(form)?;
    let index = tree.component(component.trim())?;
    let (component, name) = (&tree.components[index], name.trim());
    let states = component.states.iter().map(|state| &*state.name).zip((0..).map(StopAt::State));
    let transitions = component.transitions.iter().map(|one| &*one.name).zip((0..).map(StopAt::Transition));
    let found = states.clone().chain(transitions.clone()).filter(|(one, _)| *one == name);
    let stops: Vec<Stop> = found.map(|(_, at)| Stop { component: index as u16, at, pauses: true }).collect();
    if !stops.is_empty() {
        return Ok(stops);
    }
    let mut names: Vec<&str> = states.chain(transitions).map(|(name, _)| name).collect();
    names.dedup();
    let what = format!("`{}` has no state and no transition `{name}`", component.name);
    Err(Invalid::new(
        what,
        if names.is_empty() { "it is no state machine".to_owned() } else { format!("it has {}", names.join(", ")) },
    ))
}
