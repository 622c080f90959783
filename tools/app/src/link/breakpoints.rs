//! Breakpoints of a program, from a file.

use std::fs;
use std::path::Path;

use bica_wire::message::{Stop, StopAt};
use bica_wire::model::{Description, Invalid};

use crate::console::Failure;

/// Reads a file with a state or a transition on each line, as `Lamp.lit`. `#` begins a comment.
///
/// # Errors
/// If the file cannot be read, has no breakpoint, or names what the tree does not have.
pub(super) fn read(file: &Path, tree: &Description) -> Result<Vec<Stop>, Failure> {
    let shown = file.display();
    let failed = |error| Failure::new(format!("{shown} cannot be read: {error}"), "give a file of breakpoints");
    parse(&fs::read_to_string(file).map_err(failed)?, tree, &shown.to_string()).map_err(Failure::from)
}

/// Reads the text of a file that is shown by this name.
fn parse(text: &str, tree: &Description, shown: &str) -> Result<Vec<Stop>, Invalid> {
    let mut stops = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let place = line.split('#').next().unwrap_or_default().trim();
        if !place.is_empty() {
            let at = |invalid: Invalid| Invalid::new(format!("{shown}:{}: {}", number + 1, invalid.what), invalid.help);
            stops.extend(find(place, tree).map_err(at)?);
        }
    }
    if stops.is_empty() {
        return Err(Invalid::new(
            format!("{shown} has no breakpoint"),
            "write COMPONENT.STATE or COMPONENT.TRANSITION on each line",
        ));
    }
    Ok(stops)
}

/// Returns a breakpoint at a state, or one for each transition of a name.
fn find(place: &str, tree: &Description) -> Result<Vec<Stop>, Invalid> {
    let form = || Invalid::new(format!("`{place}` is no breakpoint"), "write COMPONENT.STATE or COMPONENT.TRANSITION");
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

#[cfg(test)]
mod tests {
    use bica_wire::model::{Component, State, Transition};

    use super::*;

    #[test]
    fn states_and_all_transitions_of_a_name_are_found() {
        let state = |name: &str| State { name: name.to_owned(), ..State::default() };
        let transition = |from, to| Transition { name: "pressed".to_owned(), from, to, ..Transition::default() };
        let states = ["dark", "lit"].map(state).to_vec();
        let transitions = vec![transition(0, 1), transition(1, 0)];
        let lamp = Component { name: "Lamp".to_owned(), states, transitions, ..Component::default() };
        let motor = Component { name: "Motor".to_owned(), ..Component::default() };
        let tree = Description { components: vec![motor, lamp], ..Description::default() };
        let stop = |at| Stop { component: 1, at, pauses: true };
        let found = parse("# both\n Lamp.lit # a state\n\nLamp . pressed\n", &tree, "f").expect("a file");
        let expected = [StopAt::State(1), StopAt::Transition(0), StopAt::Transition(1)].map(stop);
        assert_eq!(found, expected);
        for (text, error) in [
            ("Lamp.lot", "f:1: `Lamp` has no state and no transition `lot`"),
            ("Lamp.lit\nLump.lit", "f:2: there is no component `Lump`"),
            ("Motor.on", "f:1: `Motor` has no state and no transition `on`"),
            ("lit", "f:1: `lit` is no breakpoint"),
            ("# none", "f has no breakpoint"),
        ] {
            assert_eq!(parse(text, &tree, "f").expect_err(text).what, error);
        }
    }
}
