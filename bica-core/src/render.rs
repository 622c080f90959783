//! Drawings of a tree and of its state machines for other programs, written without a heap.
//!
//! | What | For | Requirement | Modulation | Age or outcome |
//! |---|---|---|---|---|
//! | [`Graph::dot`], [`Node::dot`] | Graphviz | dashed | solid | dotted, to a dot |
//! | [`Graph::mermaid`], [`Node::mermaid`] | Mermaid, which many Markdown viewers draw | dashed | solid | dashed, to a dot |
//!
//! In the drawings of a tree a link that does not hold in all states of its component is labelled with those in which it
//! does, and with the roles by which it is written; links with the same ends and kind are one arrow. Names and docs may hold any
//! characters: they are escaped, and control characters, which no picture can show, become spaces.

use core::fmt::{Display, from_fn};

use crate::graph::{Graph, Node};

mod arrow;
mod dot;
mod label;
mod mermaid;

pub use arrow::{Arrow, arrows};

impl Graph {
    /// The tree in the language of Graphviz, a `digraph`.
    #[must_use]
    pub fn dot(&self) -> impl Display {
        from_fn(|f| dot::tree(self, f))
    }

    /// The tree in the language of Mermaid, a `flowchart`.
    #[must_use]
    pub fn mermaid(&self) -> impl Display {
        from_fn(|f| mermaid::tree(self, f))
    }
}

impl Node {
    /// The state machine in the language of Graphviz, a `digraph`; without states an empty one.
    #[must_use]
    pub fn dot(&self) -> impl Display {
        from_fn(|f| dot::machine(self, f))
    }

    /// The state machine in the language of Mermaid, a `stateDiagram-v2`; without states an empty one.
    #[must_use]
    pub fn mermaid(&self) -> impl Display {
        from_fn(|f| mermaid::machine(self, f))
    }
}
