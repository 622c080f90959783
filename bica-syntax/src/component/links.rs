//! The links of a component, or of one of its states, as its signatures write them.

use syn::Type;

use super::model::{Argument, Function, Machine};
use super::role::role_of;
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

/// The links of functions that run together, each child once, by the text of its type; reads come first, as they are visited first.
///
/// A child that one of the functions writes is visited after all of them, also if another one reads it. A rate adds nothing to
/// another link.
pub fn merged<K: Copy + Into<Kind>, C>(
    links: impl Iterator<Item = (K, C)>,
    text: impl Fn(&C) -> String,
) -> Vec<(K, C)> {
    let mut all: Vec<(K, C)> = links.collect();
    all.sort_by_key(|(kind, _)| match (*kind).into() {
        Kind::Write => 0,
        Kind::Read => 1,
        Kind::Rate => 2,
    });
    let mut merged: Vec<(K, C)> = Vec::new();
    for (kind, child) in all {
        if !merged.iter().any(|(_, known)| text(known) == text(&child)) {
            merged.push((kind, child));
        }
    }
    merged.sort_by_key(|(kind, _)| (*kind).into() != Kind::Read);
    merged
}

/// The children of functions that run together, each type once if it is written alike.
///
/// Two paths can name one type, and a tree can name it for a role. Only the compiler can decide that; generated code then drops the
/// link of lower rank.
#[derive(Default)]
pub struct Links {
    list: Vec<(Kind, Type)>,
    /// Whether two of the links may turn out to be one: of names within one function that is a mistake, and reported as such.
    pub may_coincide: bool,
}

impl Links {
    /// The links of functions that run together.
    pub fn of<'a>(functions: impl Iterator<Item = &'a Function> + Clone) -> Self {
        let links = functions.clone().flat_map(|function| &function.arguments).filter_map(|argument| match argument {
            Argument::Read(child) => Some((Kind::Read, child.clone())),
            Argument::Write(child) => Some((Kind::Write, child.clone())),
            Argument::Rate(child) => Some((Kind::Rate, child.clone())),
            _ => None,
        });
        let list = merged(links, text::written);
        let linking = functions.filter(|function| !function.arguments.is_empty()).count();
        let others = list.iter().any(|(kind, child)| *kind == Kind::Rate || role_of(child).is_some());
        Self { may_coincide: list.len() > 1 && (linking > 1 || others), list }
    }

    /// The links of a state: of its body, of its hooks, and of the transitions that leave it.
    #[must_use]
    pub fn of_state(machine: &Machine, index: usize) -> Self {
        let conditions = machine.edges_from(index).filter(|edge| !edge.guard.bare).map(|edge| &edge.condition);
        Self::of(machine.states[index].functions().chain(conditions).collect::<Vec<_>>().into_iter())
    }

    /// All links, those that read first.
    pub fn iter(&self) -> impl Iterator<Item = &(Kind, Type)> {
        self.list.iter()
    }
}
