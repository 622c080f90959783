//! States, transitions and links with all names resolved, by the macro's own code.

use bica_syntax::component::guard;
use bica_syntax::component::links::{Kind, merged};
use bica_syntax::component::model::{End, Guard, Machine};
use bica_syntax::component::resolve::{Named, Written};

use super::{Arrow, Component, Function, HookRole, LinkKind, Name, State};

/// A link of a component or of one of its states.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Link {
    /// The state; `None` without a machine.
    pub state: Option<usize>,
    /// Type of the child.
    pub child: String,
    /// Requirement or modulation; a rate is a modulation.
    pub kind: LinkKind,
}

impl Component {
    /// Returns the state machine with indices of states. Hooks and transitions that name an unknown state are left out.
    #[must_use]
    pub fn machine(&self) -> Machine<&Function> {
        let hooks = |role| {
            let of_role = self.hooks.iter().filter(move |hook| hook.role == role);
            of_role.map(|hook| (&hook.function, &*hook.states)).collect()
        };
        let end = |state: &State| state.end.map(|end| if end == "done" { End::Done } else { End::Failed });
        let mut arrows: Vec<_> = self.arrows().collect();
        arrows.sort_by_key(|(.., arrow)| arrow.span.start);
        let arrows = arrows.into_iter().map(|(function, bare, arrow)| {
            let guard = Guard { bare, ..guard(&arrow.waits()).unwrap_or_default() };
            (function, &arrow.from, &arrow.to, guard)
        });
        let written = Written {
            states: self.states.iter().map(|state| (&state.function, state.last, end(state))).collect(),
            entries: hooks(HookRole::Entry),
            exits: hooks(HookRole::Exit),
            hooks_before: hooks(HookRole::Before),
            arrows: arrows.collect(),
        };
        let (states, edges) = written.resolve(|_| ());
        Machine { initial: self.states.iter().position(|state| state.initial).unwrap_or(0), states, edges }
    }

    /// The attributes `#[transition]`, each with its function, and whether that is the state.
    pub fn arrows(&self) -> impl Iterator<Item = (&Function, bool, &Arrow)> {
        let of_states = self.states.iter().flat_map(|one| one.arrows.iter().map(|arrow| (&one.function, true, arrow)));
        let of_conditions =
            self.transitions.iter().flat_map(|one| one.arrows.iter().map(|arrow| (&one.function, false, arrow)));
        of_states.chain(of_conditions)
    }

    /// The links of each state and of the transitions that leave it, or of the step.
    #[must_use]
    pub fn links(&self) -> Vec<Link> {
        if !self.is_machine() {
            return links(None, self.step.iter());
        }
        let machine = self.machine();
        let of_state = |state: usize| {
            let conditions = machine.edges_from(state).filter(|edge| !edge.guard.bare).map(|edge| edge.condition);
            links(Some(state), machine.states[state].functions().copied().chain(conditions))
        };
        (0..machine.states.len()).flat_map(of_state).collect()
    }
}

/// The links of functions that run together: each child once, those that are read first.
pub(crate) fn links<'a>(state: Option<usize>, functions: impl Iterator<Item = &'a Function>) -> Vec<Link> {
    let all = functions.flat_map(Function::links).map(|(_, kind, child)| (kind, child));
    let kind = |kind| if kind == LinkKind::Rate { LinkKind::Modulation } else { kind };
    let merged = merged(all, |child| (*child).to_owned()).into_iter();
    merged.map(|(of, child)| Link { state, child: child.to_owned(), kind: kind(of) }).collect()
}

impl Named for Name {
    fn text(&self) -> String {
        self.text.clone()
    }
}

impl Named for Function {
    fn text(&self) -> String {
        self.name.text.clone()
    }
}

impl From<LinkKind> for Kind {
    fn from(kind: LinkKind) -> Self {
        match kind {
            LinkKind::Requirement => Self::Read,
            LinkKind::Modulation => Self::Write,
            LinkKind::Rate => Self::Rate,
        }
    }
}
