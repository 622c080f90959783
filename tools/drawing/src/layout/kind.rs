//! Kinds of components by their links, and these for a drawing.

use bica_wire::model::{Component, Description, LinkKind};
use serde::Serialize;

use super::tree::Link;

/// Kind of a component.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// A state machine.
    Machine,
    /// Modulates other components, or is the root.
    Controller,
    /// Modulates no other component.
    Perception,
    /// Modulated; without links to other components.
    Actuation,
}

/// Largest number of components and of links of a received tree. The time of a layout grows with their square.
const MAX_COMPONENTS: usize = 256;
const MAX_LINKS: usize = 4 * MAX_COMPONENTS;

/// Returns the kind of each component; empty if the tree is too large to draw, or if its root or a link has an invalid index.
#[must_use]
pub fn kinds(tree: &Description) -> Vec<Kind> {
    let (count, links) = (tree.components.len(), tree.components.iter().flat_map(|component| &component.links));
    let queries = tree.components.iter().enumerate();
    let queries = queries.flat_map(|(from, component)| component.queries.iter().map(move |query| (from, query.of)));
    let are_known =
        links.clone().all(|link| link.to < count) && queries.clone().all(|(from, of)| of < count && of != from);
    let is_valid = tree.root < count && count <= MAX_COMPONENTS && are_known;
    if !is_valid || links.count() + queries.count() > MAX_LINKS {
        return Vec::new();
    }
    (0..count).map(|index| Kind::of(tree, index)).collect()
}

/// Distance of the lines of reads, and of those of writes, from the middles of the boxes, px.
const SIDE: f64 = 6.0;

/// The links of a tree, those of each component together. What a component reads has one trunk, what it writes another one.
#[must_use]
pub fn links(tree: &Description) -> Vec<Link> {
    let of = |(from, component): (usize, &Component)| {
        let link = move |link: &bica_wire::model::Link| {
            let writes = link.kind == LinkKind::Modulation;
            Link { from, to: link.to, trunk: 2 * from + usize::from(writes), side: if writes { SIDE } else { -SIDE } }
        };
        component.links.iter().map(link).collect::<Vec<_>>()
    };
    tree.components.iter().enumerate().flat_map(of).collect()
}

impl Kind {
    /// All kinds, in the order of a legend.
    pub const ALL: [Self; 4] = [Self::Machine, Self::Controller, Self::Perception, Self::Actuation];

    /// Returns the kind of the component with this index.
    #[must_use]
    pub fn of(tree: &Description, index: usize) -> Self {
        let node = &tree.components[index];
        let is_modulation = |kind: LinkKind| kind == LinkKind::Modulation;
        let written =
            tree.components.iter().flat_map(|node| &node.links).any(|l| l.to == index && is_modulation(l.kind));
        let writes = node.links.iter().any(|link| is_modulation(link.kind));
        if !node.states.is_empty() {
            Self::Machine
        } else if node.links.is_empty() && written {
            Self::Actuation
        } else if !writes && index != tree.root {
            Self::Perception
        } else {
            Self::Controller
        }
    }

    /// The name in a legend.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Machine => "state machine",
            Self::Controller => "controller",
            Self::Perception => "perception",
            Self::Actuation => "actuation",
        }
    }

    /// Colours of fill and border, `#rrggbb`.
    #[must_use]
    pub const fn colours(self) -> (&'static str, &'static str) {
        match self {
            Self::Machine => ("#fde3b0", "#d4860b"),
            Self::Controller => ("#cfe3ff", "#3b7dd8"),
            Self::Perception => ("#cdeed6", "#2f9e52"),
            Self::Actuation => ("#f9d3da", "#cf4a63"),
        }
    }
}
