//! Links as they are drawn.

use crate::graph::{Link, LinkKind, Node, Roles, State};

/// All links of a component with the same end and kind.
#[derive(Clone, Copy, Debug)]
pub struct Arrow<'a> {
    node: &'a Node,
    first: Link,
}

impl<'a> Arrow<'a> {
    /// Index of the activated component.
    #[must_use]
    pub fn to(&self) -> usize {
        self.first.to
    }

    /// Read or written.
    #[must_use]
    pub fn kind(&self) -> LinkKind {
        self.first.kind
    }

    /// Whether the arrow holds in all states.
    #[must_use]
    pub fn is_always(&self) -> bool {
        self.links().any(|link| link.state.is_none()) || (0..self.node.states.len()).all(|state| self.holds(state))
    }

    /// The states in which the arrow holds, if it does not in all.
    pub fn states(&self) -> impl Iterator<Item = &'a State> {
        let arrow = *self;
        let listed = if self.is_always() { 0 } else { self.node.states.len() };
        (0..listed).filter(move |&state| arrow.holds(state)).map(move |state| &arrow.node.states[state])
    }

    /// The roles by which the component asks for the activated one, in any state.
    #[must_use]
    pub fn roles(&self) -> Roles {
        self.links().fold(Roles::NONE, |roles, link| roles.and(link.roles))
    }

    fn holds(&self, state: usize) -> bool {
        self.links().any(|link| link.state == Some(state))
    }

    fn links(&self) -> impl Iterator<Item = &'a Link> {
        let Link { to, kind, .. } = self.first;
        self.node.links.iter().filter(move |link| link.to == to && link.kind == kind)
    }
}

/// The arrows that start at a component, in the order of its links.
pub fn arrows(node: &Node) -> impl Iterator<Item = Arrow<'_>> {
    node.links.iter().enumerate().filter_map(|(index, &first)| {
        let drawn = node.links[..index].iter().any(|link| link.to == first.to && link.kind == first.kind);
        (!drawn).then_some(Arrow { node, first })
    })
}
