//! Reference model of edits: a component without spans, and the effect of each edit on it.

use std::collections::BTreeMap;

use bica_vicode::Edit;
use bica_vicode::model::{Component, Function, HookRole, LinkKind, Sources};

/// Role of a function. A new function is inserted after the last one of its role, or of an earlier role.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
enum Role {
    State,
    Transition,
    Hook,
    #[default]
    Other,
}

/// States that are left, state that is entered, timer.
type Arrow = (Vec<String>, String, Option<u32>);

#[derive(Clone, Debug, Default, PartialEq)]
struct Item {
    name: String,
    role: Role,
    docs: String,
    links: Vec<(LinkKind, String)>,
    body: String,
    initial: bool,
    last: bool,
    arrows: Vec<Arrow>,
    hook: Option<HookRole>,
    states: Vec<String>,
}

/// Functions in the order of the text, and options.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Abstract {
    items: Vec<Item>,
    options: BTreeMap<String, String>,
    docs: String,
}

fn squeezed(code: &str) -> String {
    code.chars().filter(|character| !character.is_whitespace()).collect()
}

impl Abstract {
    pub(crate) fn of(component: &Component, text: &str) -> Self {
        let mut items: Vec<(usize, Item)> = Vec::new();
        let mut add = |function: &Function, item: Item| {
            let links = function.links().map(|(_, kind, child)| (kind, child.to_owned())).collect();
            let body = squeezed(function.body.map(|body| body.of(text)).unwrap_or_default());
            let (name, docs) = (function.name.text.clone(), function.docs.text.clone());
            items.push((function.span.start, Item { name, docs, links, body, ..item }));
        };
        for state in &component.states {
            let (initial, last) = (state.initial, state.last);
            add(&state.function, Item { role: Role::State, initial, last, ..Item::default() });
        }
        for transition in &component.transitions {
            let arrows = transition.arrows.iter().map(|arrow| {
                let from = match &arrow.from {
                    Sources::Any => vec!["*".to_owned()],
                    Sources::These(names) => names.iter().map(|name| name.text.clone()).collect(),
                };
                (from, arrow.to.text.clone(), arrow.after_ms.map(|(value, _)| value))
            });
            let arrows = arrows.collect();
            add(&transition.function, Item { role: Role::Transition, arrows, ..Item::default() });
        }
        for hook in &component.hooks {
            let states = hook.states.iter().map(|name| name.text.clone()).collect();
            add(&hook.function, Item { role: Role::Hook, hook: Some(hook.role), states, ..Item::default() });
        }
        component.others.iter().chain(&component.step).for_each(|function| add(function, Item::default()));
        items.sort_by_key(|(at, _)| *at);
        let options = component.options.settings.iter();
        let options = options
            .map(|one| (one.key.text.clone(), one.value.as_ref().map(|value| value.text.clone()).unwrap_or_default()));
        Self {
            items: items.into_iter().map(|(_, item)| item).collect(),
            options: options.collect(),
            docs: component.docs.span.map(|_| component.docs.text.clone()).unwrap_or_default(),
        }
    }

    fn at(&self, name: &str) -> usize {
        self.items.iter().position(|item| item.name == name).unwrap()
    }

    fn item(&mut self, name: &str) -> &mut Item {
        let at = self.at(name);
        &mut self.items[at]
    }

    fn add(&mut self, name: &str, docs: &str, body: &str, item: Item) {
        let last = |role| self.items.iter().rposition(|item| item.role == role);
        let roles = [Role::Hook, Role::Transition, Role::State].into_iter().filter(|role| *role <= item.role);
        let at = roles.into_iter().find_map(last).map_or(self.items.len(), |last| last + 1);
        self.items.insert(at, Item { name: name.to_owned(), docs: docs.to_owned(), body: squeezed(body), ..item });
    }

    /// Applies an edit that the library accepted.
    pub(crate) fn apply(&mut self, edit: &Edit) {
        let default = Item::default();
        match edit {
            Edit::AddState { name, docs, initial, last, body, .. } => {
                self.items.iter_mut().for_each(|item| item.initial &= !initial);
                self.add(name, docs, body, Item { role: Role::State, initial: *initial, last: *last, ..default });
            }
            Edit::AddTransition { name, from, to, after_ms, body, docs, .. } => {
                let body = if body.is_empty() { if after_ms.is_some() { "true" } else { "false" } } else { body };
                let arrows = vec![(from.clone(), to.clone(), *after_ms)];
                self.add(name, docs, body, Item { role: Role::Transition, arrows, ..default });
            }
            Edit::AddHook { name, role, states, body, docs, .. } => {
                let item = Item { role: Role::Hook, hook: Some(*role), states: states.clone(), ..default };
                self.add(name, docs, body, item);
            }
            Edit::Rename { function, to, .. } => self.rename(function, to),
            Edit::Delete { function, .. } => self.delete(function),
            Edit::Move { function, before, .. } if before.as_ref() != Some(function) => {
                let at = self.at(function);
                let item = self.items.remove(at);
                let at = before.as_ref().map_or(self.items.len(), |before| self.at(before));
                self.items.insert(at, item);
            }
            Edit::Copy { function, name, .. } => {
                let at = self.at(function);
                self.items.insert(at + 1, Item { name: name.clone(), initial: false, ..self.items[at].clone() });
            }
            Edit::SetBody { function, body, .. } => self.item(function).body = squeezed(body),
            Edit::SetDocs { function: Some(function), docs, .. } => self.item(function).docs.clone_from(docs),
            Edit::SetDocs { docs, .. } => self.docs.clone_from(docs),
            Edit::SetOption { option, value, .. } => {
                self.options.remove(option);
                self.options.extend(value.clone().map(|value| (option.clone(), value)));
            }
            Edit::SetInitial { state, .. } => self.items.iter_mut().for_each(|item| item.initial = item.name == *state),
            Edit::SetLast { state, last, .. } => self.item(state).last = *last,
            Edit::AddArrow { transition, from, to, after_ms, .. } => {
                self.item(transition).arrows.push((from.clone(), to.clone(), *after_ms));
            }
            Edit::RemoveArrow { transition, arrow, .. } => drop(self.item(transition).arrows.remove(*arrow)),
            Edit::SetSources { transition, arrow, from, .. } => self.item(transition).arrows[*arrow].0.clone_from(from),
            Edit::SetTarget { transition, arrow, to, .. } => self.item(transition).arrows[*arrow].1.clone_from(to),
            Edit::SetTimer { transition, arrow, after_ms, .. } => self.item(transition).arrows[*arrow].2 = *after_ms,
            Edit::SetHookStates { hook, states, .. } => self.item(hook).states.clone_from(states),
            Edit::AddChild { function, child, kind, .. } => self.item(function).links.push((*kind, child.clone())),
            Edit::RemoveChild { function, child, .. } => self.item(function).links.retain(|(_, known)| known != child),
            Edit::SetChildKind { function, child, kind, .. } => {
                let links = self.item(function).links.iter_mut();
                links.filter(|(_, known)| known == child).for_each(|link| link.0 = *kind);
            }
            _ => {}
        }
    }

    fn rename(&mut self, from: &str, to: &str) {
        let is_state = self.item(from).role == Role::State;
        to.clone_into(&mut self.item(from).name);
        for item in &mut self.items {
            item.body = item.body.replace(&format!("self.{from}("), &format!("self.{to}("));
            let of_arrows = item.arrows.iter_mut().flat_map(|(from, to, _)| from.iter_mut().chain([to]));
            let names = of_arrows.chain(&mut item.states).filter(|name| is_state && *name == from);
            names.for_each(|name| to.clone_into(name));
        }
    }

    fn delete(&mut self, name: &str) {
        let at = self.at(name);
        if self.items.remove(at).role != Role::State {
            return;
        }
        self.items.retain_mut(|item| {
            let (arrows, states) = (item.arrows.len(), item.states.len());
            item.arrows.iter_mut().for_each(|(from, ..)| from.retain(|one| one != name));
            item.arrows.retain(|(from, to, _)| !from.is_empty() && to != name);
            item.states.retain(|one| one != name);
            (arrows == 0 || !item.arrows.is_empty()) && (states == 0 || !item.states.is_empty())
        });
    }
}
