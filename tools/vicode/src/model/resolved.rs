//! States, transitions and links with all names resolved, by the macro's own code.

use bica_syntax::component::links::{Kind, merged};
use bica_syntax::component::model::Machine;
use bica_syntax::component::resolve::{Named, Written};

use super::{Component, Function, HookRole, LinkKind, Name};

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
    /// The state machine by indices of states; what names an unknown state is left out.
    #[must_use]
    pub fn machine(&self) -> Machine<&Function> {
        let hooks = |role| {
            let of_role = self.hooks.iter().filter(move |hook| hook.role == role);
            of_role.map(|hook| (&hook.function, &*hook.states)).collect()
        };
        let arrows = self.transitions.iter().flat_map(|one| {
            let condition = &one.function;
            one.arrows.iter().map(move |arrow| (condition, &arrow.from, &arrow.to, arrow.after_ms.map(|(ms, _)| ms)))
        });
        let written = Written {
            states: self.states.iter().map(|state| (&state.function, state.last)).collect(),
            entries: hooks(HookRole::Entry),
            exits: hooks(HookRole::Exit),
            hooks_before: hooks(HookRole::Before),
            arrows: arrows.collect(),
        };
        let (states, edges) = written.resolve(|_| ());
        Machine { initial: self.states.iter().position(|state| state.initial).unwrap_or(0), states, edges }
    }

    /// The links of each state and of the transitions that leave it, or of the step.
    #[must_use]
    pub fn links(&self) -> Vec<Link> {
        if !self.is_machine() {
            return links(None, self.step.iter());
        }
        let machine = self.machine();
        let of_state = |state: usize| {
            let conditions = machine.edges_from(state).map(|edge| edge.condition);
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
