//! The links of a component, or of one of its states, as its signatures write them.

use syn::Type;

use super::model::{Argument, Function, Machine};
use crate::text;

/// The kind of a link, from the argument.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// `&C`
    Read,
    /// `&mut C`
    Write,
    /// `&mut Rate<C>`
    Rate,
}

/// The children of functions that run together, each type once if it is written alike.
///
/// Two paths can name one type. Only the compiler can decide that; generated code then drops the link of lower rank.
#[derive(Default)]
pub struct Links {
    list: Vec<(Kind, Type)>,
    /// Whether two of the links may turn out to be one: within one function that is a mistake, and reported as such.
    pub may_coincide: bool,
}

impl Links {
    /// The links of functions that run together. A child that one of them writes is visited after all of them, also if
    /// another reads it.
    pub fn of<'a>(functions: impl Iterator<Item = &'a Function> + Clone) -> Self {
        let mut links = Self::default();
        let arguments = || functions.clone().flat_map(|function| &function.arguments);
        for argument in arguments() {
            if let Argument::Write(child) = argument {
                links.add(Kind::Write, child);
            }
        }
        for argument in arguments() {
            if let Argument::Read(child) = argument {
                links.add(Kind::Read, child);
            }
        }
        for argument in arguments() {
            if let Argument::Rate(child) = argument {
                links.add(Kind::Rate, child);
            }
        }
        let linking = functions.filter(|function| !function.arguments.is_empty()).count();
        let rates = links.list.iter().any(|(kind, _)| *kind == Kind::Rate);
        links.may_coincide = links.list.len() > 1 && (linking > 1 || rates);
        // Requirements come first, as they are visited first.
        links.list.sort_by_key(|(kind, _)| *kind != Kind::Read);
        links
    }

    /// The links of a state: of its body, of its hooks, and of the transitions that leave it.
    #[must_use]
    pub fn of_state(machine: &Machine, index: usize) -> Self {
        let state = &machine.states[index];
        let hooks = state.entries.iter().chain(&state.exits);
        let conditions = machine.edges_from(index).map(|edge| &edge.condition);
        Self::of([&state.body].into_iter().chain(hooks).chain(conditions).collect::<Vec<_>>().into_iter())
    }

    /// All links, those that read first.
    pub fn iter(&self) -> impl Iterator<Item = &(Kind, Type)> {
        self.list.iter()
    }

    /// Adds a child unless it is there.
    fn add(&mut self, kind: Kind, child: &Type) {
        let name = text::written(child);
        if !self.list.iter().any(|(_, known)| text::written(known) == name) {
            self.list.push((kind, child.clone()));
        }
    }
}
