//! A component without places, and the meaning of edits on it: what the model must be afterwards.

use std::collections::BTreeMap;

use bica_vicode::Edit;
use bica_vicode::model::{Component, Function, HookRole, LinkKind, Sources};

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Role {
    State { initial: bool, last: bool },
    Transition(Vec<(Vec<String>, String, Option<u32>)>),
    Hook(HookRole, Vec<String>),
    Other,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Item {
    pub(crate) name: String,
    pub(crate) role: Role,
    docs: String,
    links: Vec<(LinkKind, String)>,
    body: String,
}

/// Functions in the order of the text, and options.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Abstract {
    pub(crate) items: Vec<Item>,
    options: BTreeMap<String, String>,
    docs: String,
}

fn squeezed(code: &str) -> String {
    code.chars().filter(|character| !character.is_whitespace()).collect()
}

impl Abstract {
    pub(crate) fn of(component: &Component, text: &str) -> Self {
        let mut items: Vec<(usize, Item)> = Vec::new();
        let mut add = |function: &Function, role| {
            let links = function.links().map(|(_, kind, child)| (kind, child.to_owned())).collect();
            let body = squeezed(function.body.map(|body| body.of(text)).unwrap_or_default());
            let item = Item { name: function.name.text.clone(), role, docs: function.docs.text.clone(), links, body };
            items.push((function.span.start, item));
        };
        for state in &component.states {
            add(&state.function, Role::State { initial: state.initial, last: state.last });
        }
        for transition in &component.transitions {
            let arrows = transition.arrows.iter().map(|arrow| {
                let from = match &arrow.from {
                    Sources::Any => vec!["*".to_owned()],
                    Sources::These(names) => names.iter().map(|name| name.text.clone()).collect(),
                };
                (from, arrow.to.as_ref().unwrap().text.clone(), arrow.after_ms.map(|(value, _)| value))
            });
            add(&transition.function, Role::Transition(arrows.collect()));
        }
        for hook in &component.hooks {
            add(&hook.function, Role::Hook(hook.role, hook.states.iter().map(|name| name.text.clone()).collect()));
        }
        component.others.iter().chain(&component.step).for_each(|function| add(function, Role::Other));
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

    /// Where a new function of a role goes.
    fn place(&self, roles: &[fn(&Role) -> bool]) -> usize {
        let last = roles.iter().find_map(|role| self.items.iter().rposition(|item| role(&item.role)));
        last.map_or(self.items.len(), |last| last + 1)
    }

    fn add(&mut self, at: usize, name: &str, role: Role, docs: &str, body: &str) {
        let item = Item { name: name.to_owned(), role, docs: docs.to_owned(), links: Vec::new(), body: squeezed(body) };
        self.items.insert(at, item);
    }

    /// Applies an edit that the library accepted.
    pub(crate) fn apply(&mut self, edit: &Edit) {
        let state: fn(&Role) -> bool = |role| matches!(role, Role::State { .. });
        let transition: fn(&Role) -> bool = |role| matches!(role, Role::Transition(_));
        let hook: fn(&Role) -> bool = |role| matches!(role, Role::Hook(..));
        match edit {
            Edit::AddState { name, docs, initial, last, body, .. } => {
                if *initial {
                    self.none_initial();
                }
                let at = self.place(&[state]);
                self.add(at, name, Role::State { initial: *initial, last: *last }, docs, body);
            }
            Edit::AddTransition { name, from, to, after_ms, body, docs, .. } => {
                let body = if body.is_empty() { if after_ms.is_some() { "true" } else { "false" } } else { body };
                let at = self.place(&[transition, state]);
                self.add(at, name, Role::Transition(vec![(from.clone(), to.clone(), *after_ms)]), docs, body);
            }
            Edit::AddHook { name, role, states, body, docs, .. } => {
                let at = self.place(&[hook, transition, state]);
                self.add(at, name, Role::Hook(*role, states.clone()), docs, body);
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
                let mut copy = Item { name: name.clone(), ..self.items[at].clone() };
                if let Role::State { initial, .. } = &mut copy.role {
                    *initial = false;
                }
                self.items.insert(at + 1, copy);
            }
            Edit::SetBody { function, body, .. } => self.item(function).body = squeezed(body),
            Edit::SetDocs { function, docs, .. } => match function {
                Some(function) => self.item(function).docs.clone_from(docs),
                None => self.docs.clone_from(docs),
            },
            Edit::SetOption { option, value, .. } => {
                self.options.remove(option);
                self.options.extend(value.clone().map(|value| (option.clone(), value)));
            }
            _ => self.apply_to_parts(edit),
        }
    }

    fn apply_to_parts(&mut self, edit: &Edit) {
        match edit {
            Edit::SetInitial { state, .. } => {
                self.none_initial();
                if let Role::State { initial, .. } = &mut self.item(state).role {
                    *initial = true;
                }
            }
            Edit::SetLast { state, last: new, .. } => {
                if let Role::State { last, .. } = &mut self.item(state).role {
                    *last = *new;
                }
            }
            Edit::AddArrow { transition, from, to, after_ms, .. } => {
                self.arrows(transition).push((from.clone(), to.clone(), *after_ms));
            }
            Edit::RemoveArrow { transition, arrow, .. } => drop(self.arrows(transition).remove(*arrow)),
            Edit::SetSources { transition, arrow, from, .. } => self.arrows(transition)[*arrow].0.clone_from(from),
            Edit::SetTarget { transition, arrow, to, .. } => self.arrows(transition)[*arrow].1.clone_from(to),
            Edit::SetTimer { transition, arrow, after_ms, .. } => self.arrows(transition)[*arrow].2 = *after_ms,
            Edit::SetHookStates { hook, states, .. } => {
                if let Role::Hook(_, of) = &mut self.item(hook).role {
                    of.clone_from(states);
                }
            }
            Edit::AddChild { function, child, kind, .. } => self.item(function).links.push((*kind, child.clone())),
            Edit::RemoveChild { function, child, .. } => self.item(function).links.retain(|(_, known)| known != child),
            Edit::SetChildKind { function, child, kind, .. } => {
                self.item(function)
                    .links
                    .iter_mut()
                    .filter(|(_, known)| known == child)
                    .for_each(|link| link.0 = *kind);
            }
            _ => {}
        }
    }

    fn none_initial(&mut self) {
        for item in &mut self.items {
            if let Role::State { initial, .. } = &mut item.role {
                *initial = false;
            }
        }
    }

    fn arrows(&mut self, name: &str) -> &mut Vec<(Vec<String>, String, Option<u32>)> {
        match &mut self.item(name).role {
            Role::Transition(arrows) => arrows,
            _ => panic!("{name} is no transition"),
        }
    }

    fn rename(&mut self, from: &str, to: &str) {
        let is_state = matches!(self.item(from).role, Role::State { .. });
        to.clone_into(&mut self.item(from).name);
        for item in &mut self.items {
            let (call, called) = (format!("self.{from}("), format!("self.{to}("));
            item.body = item.body.replace(&call, &called);
            let names: Vec<&mut String> = match &mut item.role {
                Role::Transition(arrows) => {
                    arrows.iter_mut().flat_map(|(from, to, _)| from.iter_mut().chain([to])).collect()
                }
                Role::Hook(_, states) => states.iter_mut().collect(),
                _ => Vec::new(),
            };
            names.into_iter().filter(|name| is_state && *name == from).for_each(|name| to.clone_into(name));
        }
    }

    fn delete(&mut self, name: &str) {
        let at = self.at(name);
        let is_state = matches!(self.items.remove(at).role, Role::State { .. });
        if !is_state {
            return;
        }
        self.items.retain_mut(|item| match &mut item.role {
            Role::Transition(arrows) => {
                arrows.retain_mut(|(from, to, _)| {
                    from.retain(|one| one != name);
                    !from.is_empty() && to != name
                });
                !arrows.is_empty()
            }
            Role::Hook(_, states) if !states.is_empty() => {
                states.retain(|one| one != name);
                !states.is_empty()
            }
            _ => true,
        });
    }
}
