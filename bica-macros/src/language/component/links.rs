//! The links of a component, or of one of its states.

use syn::Type;

use super::model::{Argument, Function, Machine};
use crate::language::text;

/// The children that are visited before and after.
#[derive(Default)]
pub(crate) struct Links {
    pub(crate) requirements: Vec<Type>,
    pub(crate) modulations: Vec<Type>,
}

impl Links {
    /// The links of functions that run together. What one of them modulates is visited after all of them, also if
    /// another reads it.
    pub(crate) fn of<'a>(functions: impl Iterator<Item = &'a Function> + Clone) -> Self {
        let mut links = Self::default();
        let arguments = functions.flat_map(|function| &function.arguments);
        for argument in arguments.clone() {
            if let Argument::Write(child) = argument {
                add(&mut links.modulations, &[], child);
            }
        }
        for argument in arguments.clone() {
            if let Argument::Read(child) = argument {
                add(&mut links.requirements, &links.modulations, child);
            }
        }
        for argument in arguments {
            if let Argument::Rate(child) = argument {
                add(&mut links.modulations, &links.requirements, child);
            }
        }
        links
    }

    /// The links of a state: of its body, of its hooks, and of the transitions that leave it.
    pub(crate) fn of_state(machine: &Machine, state: usize) -> Self {
        let place = &machine.states[state];
        let hooks = place.entries.iter().chain(&place.exits);
        let conditions = machine.ways_from(state).map(|way| &way.condition);
        Self::of([&place.body].into_iter().chain(hooks).chain(conditions).collect::<Vec<_>>().into_iter())
    }

    /// All children.
    pub(crate) fn children(&self) -> impl Iterator<Item = &Type> {
        self.requirements.iter().chain(&self.modulations)
    }
}

/// Adds a child unless it is there or in the other list.
fn add(list: &mut Vec<Type>, other: &[Type], child: &Type) {
    let name = text::written(child);
    if !list.iter().chain(other).any(|known| text::written(known) == name) {
        list.push(child.clone());
    }
}
