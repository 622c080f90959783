//! What a component is, by its links.

use bica::graph::{Graph, LinkKind};

/// What a component is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Has states.
    Machine,
    /// Writes others; or is the root.
    Controller,
    /// Writes no other.
    Perception,
    /// Is written and activates nothing.
    Actuation,
}

impl Kind {
    pub const ALL: [Self; 4] = [Self::Machine, Self::Controller, Self::Perception, Self::Actuation];

    /// The kind of the component with this index.
    pub fn of(graph: &Graph, index: usize) -> Self {
        let node = &graph.nodes[index];
        let is_modulation = |kind: LinkKind| kind == LinkKind::Modulation;
        let written = graph.nodes.iter().flat_map(|node| node.links).any(|l| l.to == index && is_modulation(l.kind));
        let writes = node.links.iter().any(|link| is_modulation(link.kind));
        if !node.states.is_empty() {
            Self::Machine
        } else if node.links.is_empty() && written {
            Self::Actuation
        } else if !writes && index != graph.root {
            Self::Perception
        } else {
            Self::Controller
        }
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::Machine => "state machine",
            Self::Controller => "controller",
            Self::Perception => "perception",
            Self::Actuation => "actuation",
        }
    }

    /// Fill and border.
    pub fn colours(self) -> (&'static str, &'static str) {
        match self {
            Self::Machine => ("#fde3b0", "#d4860b"),
            Self::Controller => ("#cfe3ff", "#3b7dd8"),
            Self::Perception => ("#cdeed6", "#2f9e52"),
            Self::Actuation => ("#f9d3da", "#cf4a63"),
        }
    }
}
