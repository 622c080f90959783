//! Assembly of a description from graph items: those of a tree of this program, or those that a robot sends.

use std::borrow::ToOwned;
use std::format;
use std::string::String;
use std::vec::Vec;

use bica_core::Value;
use bica_core::action::Action;
use bica_core::graph::{Graph, LinkKind, hash};
use bica_core::params::Kind;

use super::{
    Component, Description, Link, Modulation, Output, Param, Placement, Query, State, Transition, Variant, Variants,
    When, Work, Writer,
};
use crate::describe::{GraphItems, describe};
use crate::message::GraphItem;

impl Description {
    /// Describes a tree of this program.
    #[must_use]
    pub fn of(graph: &Graph) -> Self {
        let mut builder = Builder::default();
        // The items of a graph are complete and in order.
        let described = describe(graph).find_map(|item| builder.add(&item).ok().flatten()).unwrap_or_default();
        Self { hash: format!("{:016x}", hash(graph)), ..described }
    }

    /// Adds the actions of the world.
    #[must_use]
    pub fn with_actions(self, actions: &'static [Action]) -> Self {
        let mut builder = Builder { description: self, ..Builder::default() };
        for item in GraphItems::of_actions(actions) {
            // An argument and a doc comment follow their action.
            let _ = builder.put(&item);
        }
        builder.description
    }
}

/// Item to which the next doc comment belongs.
#[derive(Clone, Copy, Debug, Default)]
enum Last {
    #[default]
    Tree,
    Component(usize),
    Work(usize),
    State(usize),
    Transition(usize),
    Param(usize),
    ParamVariant(usize),
    Output(usize),
    Call(Owner),
    Argument(Owner),
    ArgumentVariant(Owner),
    Link(usize),
}

/// Owner of the last modulation or action.
#[derive(Clone, Copy, Debug)]
enum Owner {
    Component(usize),
    World,
}

/// Builds a description from [`GraphItem`]s.
#[derive(Clone, Debug, Default)]
pub struct Builder {
    description: Description,
    last: Last,
    items: u32,
}

impl Builder {
    /// Adds an item; returns the description after the last one. It has no [hash](Description::hash).
    ///
    /// # Errors
    /// What is wrong with the items.
    pub fn add(&mut self, item: &GraphItem<'_>) -> Result<Option<Description>, &'static str> {
        if let GraphItem::End { items } = *item {
            let Self { description, items: received, .. } = core::mem::take(self);
            return if items == received { Ok(Some(description)) } else { Err("items are missing") };
        }
        self.items += 1;
        self.put(item).ok_or("an item belongs to none before it")?;
        Ok(None)
    }

    fn at(&mut self, component: u16) -> Option<&mut Component> {
        self.description.components.get_mut(usize::from(component))
    }

    fn put(&mut self, item: &GraphItem<'_>) -> Option<()> {
        match *item {
            GraphItem::End { .. } => {}
            GraphItem::Doc { text } => self.doc()?.push_str(text),
            GraphItem::Tree { name, cycle_hz, budget_ms, tunable, .. } => {
                let name = name.to_owned();
                self.description = Description { name, cycle_hz, budget_ms, tunable, ..Description::default() };
                (self.last, self.items) = (Last::Tree, 1);
            }
            GraphItem::Component { name, hz, budget_us, root, resume, .. } => {
                let name = name.to_owned();
                let index = self.description.components.len();
                self.last = Last::Component(index);
                if root {
                    self.description.root = index;
                }
                let component = Component { name, hz, budget_us, resume, ..Component::default() };
                self.description.components.push(component);
            }
            GraphItem::Link { from, to, modulation, state } => {
                let kind = if modulation { LinkKind::Modulation } else { LinkKind::Requirement };
                let link = Link { to: to.into(), kind, state: state.map(usize::from), roles: Vec::new() };
                self.at(from)?.links.push(link);
                self.last = Last::Link(from.into());
            }
            GraphItem::State { component, name, initial, last, end, before, .. } => {
                let (name, before) = (name.to_owned(), before.map(str::to_owned));
                self.at(component)?.states.push(State { name, doc: String::new(), initial, last, end, before });
                self.last = Last::State(component.into());
            }
            GraphItem::Transition { component, from, to, name, after_ms, after, when, times, carries } => {
                let (name, from, to) = (name.to_owned(), from.into(), to.into());
                let (doc, carries) = (String::new(), carries.map(str::to_owned));
                let (after, when) =
                    (after.map(usize::from), when.map(|(child, end)| When { child: child.into(), end }));
                let transition = Transition { name, doc, from, to, after_ms, after, when, times, carries };
                self.at(component)?.transitions.push(transition);
                self.last = Last::Transition(component.into());
            }
            GraphItem::Param { component, group, name, unit, ref kind, default, .. } => {
                self.at(component)?.params.push(param(group, name, unit, kind, default));
                self.last = Last::Param(component.into());
            }
            GraphItem::Variant { name } => self.variant(name)?,
            GraphItem::Output { component, name, unit, type_name, placement, .. } => {
                let (name, unit, type_name) = (name.to_owned(), unit.map(str::to_owned), type_name.to_owned());
                self.at(component)?.outputs.push(Output {
                    name,
                    doc: String::new(),
                    unit,
                    type_name,
                    placement: placement.map(Placement::from),
                    schema: None,
                });
                self.last = Last::Output(component.into());
            }
            GraphItem::Modulation { component, name, stops, drives, .. } => {
                self.at(component)?.modulations.push(Modulation { stops, drives, ..call(name, None) });
                self.last = Last::Call(Owner::Component(component.into()));
            }
            GraphItem::Action { name, moves } => {
                self.description.actions.push(call(name, moves));
                self.last = Last::Call(Owner::World);
            }
            GraphItem::Argument { name, unit, ref kind, default } => {
                let (Last::Call(of) | Last::Argument(of) | Last::ArgumentVariant(of)) = self.last else {
                    return None;
                };
                last_call(&mut self.description, of)?.arguments.push(param("", name, unit, kind, default));
                self.last = Last::Argument(of);
            }
            GraphItem::Role { name } => {
                let Last::Link(of) = self.last else { return None };
                self.description.components.get_mut(of)?.links.last_mut()?.roles.push(name.to_owned());
            }
            GraphItem::Kind { name } => self.last_component()?.kind = Some(name.to_owned()),
            GraphItem::Query { of, kind } => self.last_component()?.queries.push(Query { of: of.into(), kind }),
            GraphItem::Writer { by, in_force } => {
                self.last_component()?.writers.push(Writer { by: by.into(), in_force });
            }
            GraphItem::Work { name, takes_ms, slices, result } => {
                let Last::Component(of) = self.last else { return None };
                let (name, result) = (name.to_owned(), result.to_owned());
                let work = Work { name, doc: String::new(), takes_ms, slices, result };
                self.description.components.get_mut(of)?.work = Some(work);
                self.last = Last::Work(of);
            }
            GraphItem::Place(place) => {
                let Last::Argument(of) = self.last else { return None };
                last_call(&mut self.description, of)?.arguments.last_mut()?.place = Some(place.into());
            }
        }
        Some(())
    }

    /// Returns the component, if it is the last item.
    fn last_component(&mut self) -> Option<&mut Component> {
        let Last::Component(of) = self.last else { return None };
        self.description.components.get_mut(of)
    }

    /// Adds a variant to the last parameter or argument.
    fn variant(&mut self, name: &str) -> Option<()> {
        let (param, last) = match self.last {
            Last::Param(of) | Last::ParamVariant(of) => {
                (self.description.components.get_mut(of)?.params.last_mut()?, Last::ParamVariant(of))
            }
            Last::Argument(of) | Last::ArgumentVariant(of) => {
                (last_call(&mut self.description, of)?.arguments.last_mut()?, Last::ArgumentVariant(of))
            }
            _ => return None,
        };
        let Kind::Choice { variants: Variants(variants) } = &mut param.kind else { return None };
        variants.push(Variant { name: name.to_owned(), doc: String::new() });
        self.last = last;
        Some(())
    }

    fn doc(&mut self) -> Option<&mut String> {
        let description = &mut self.description;
        Some(match self.last {
            Last::Call(of) => &mut last_call(description, of)?.doc,
            Last::Argument(of) => &mut last_call(description, of)?.arguments.last_mut()?.doc,
            Last::ArgumentVariant(of) => last_variant(last_call(description, of)?.arguments.last_mut()?)?,
            Last::Tree => &mut description.doc,
            Last::Component(of) => &mut description.components.get_mut(of)?.doc,
            Last::Work(of) => &mut description.components.get_mut(of)?.work.as_mut()?.doc,
            Last::State(of) => &mut description.components.get_mut(of)?.states.last_mut()?.doc,
            Last::Transition(of) => &mut description.components.get_mut(of)?.transitions.last_mut()?.doc,
            Last::Param(of) => &mut description.components.get_mut(of)?.params.last_mut()?.doc,
            Last::ParamVariant(of) => last_variant(description.components.get_mut(of)?.params.last_mut()?)?,
            Last::Output(of) => &mut description.components.get_mut(of)?.outputs.last_mut()?.doc,
            Last::Link(_) => return None,
        })
    }
}

/// Returns the last modulation or action of its owner.
fn last_call(description: &mut Description, of: Owner) -> Option<&mut Modulation> {
    match of {
        Owner::Component(of) => description.components.get_mut(of)?.modulations.last_mut(),
        Owner::World => description.actions.last_mut(),
    }
}

fn last_variant(param: &mut Param) -> Option<&mut String> {
    match &mut param.kind {
        Kind::Choice { variants: Variants(variants) } => Some(&mut variants.last_mut()?.doc),
        _ => None,
    }
}

fn param(group: &str, name: &str, unit: Option<&str>, kind: &Kind<u16>, default: Value) -> Param {
    Param {
        group: group.to_owned(),
        name: name.to_owned(),
        doc: String::new(),
        unit: unit.map(str::to_owned),
        kind: kind.map(|_| Variants::default()),
        default,
        place: None,
        value: None,
    }
}

fn call(name: &str, moves: Option<&str>) -> Modulation {
    let (name, moves) = (name.to_owned(), moves.map(str::to_owned));
    Modulation { name, doc: String::new(), stops: false, drives: false, arguments: Vec::new(), moves }
}
