//! Drawings of a tree and of its state machines for other programs, written without a heap.
//!
//! | What | For | Requirement | Modulation |
//! |---|---|---|---|
//! | [`Graph::dot`], [`Node::dot`] | Graphviz | dashed | solid |
//! | [`Graph::mermaid`], [`Node::mermaid`] | Mermaid, which many Markdown viewers draw | dashed | solid |
//! | [`Graph::json`] | programs | `"requirement"` | `"modulation"` |
//!
//! In the drawings of a tree a link that does not hold in all states of its component is labelled with those in which it
//! does; links with the same ends and kind are one arrow. Names and docs may hold any characters: they are escaped, and
//! control characters, which no picture can show, become spaces.
//!
//! # JSON
//! One object with the fields of [`Graph`], and `hash`: [`hash`](crate::graph::hash) as 16 hexadecimal digits. In it arrays
//! of objects with the fields of [`Node`], [`Link`](crate::graph::Link), [`State`](crate::graph::State),
//! [`Transition`](crate::graph::Transition) and [`ParamGroup`](crate::params::ParamGroup), all of them, under their names in
//! Rust. Indices and numbers are numbers, `None` is `null`, and so is a number that JSON has no way to write (infinite,
//! NaN). `kind` of a link is `"requirement"` or `"modulation"`.
//!
//! An output has `name`, `doc`, `unit` and `type`; a modulation `name`, `doc` and `arguments`, described as parameters.
//!
//! A parameter has `name`, `doc`, `unit`, `kind` ([`Kind::name`](crate::params::Kind::name)), for numbers `min`, `max` and
//! `step`, for a choice `variants` (`name`, `doc`), and `default`: a number, `true` or `false`, or the name of a variant.
//!
//! ```json
//! {"name": "Forward", "doc": "", "cycle_hz": 100, "budget_ms": 200, "tunable": true,
//!  "hash": "6b1e0f5a2c9d4788", "root": 0, "nodes": [
//!   {"name": "Player", "doc": "", "hz": 10, "budget_us": 20, "resume": false,
//!    "links": [{"to": 1, "kind": "modulation", "state": 0}],
//!    "states": [{"name": "look_for_ball", "doc": "", "initial": true, "last": false}],
//!    "transitions": [{"name": "again", "doc": "", "from": 0, "to": 0, "after_ms": 1500}],
//!    "params": [{"name": "Patience", "doc": "", "params": [
//!      {"name": "pause", "doc": "", "unit": "s", "kind": "f32", "min": 0, "max": 5, "step": null, "default": 0.5}]}],
//!    "info": [], "modulations": []},
//!   {"name": "SearchBall", "doc": "", "hz": null, "budget_us": null, "resume": false,
//!    "links": [], "states": [], "transitions": [], "params": [], "info": [], "modulations": []}
//! ]}
//! ```

use core::fmt::{Display, from_fn};

use crate::graph::{Graph, Node};

mod arrow;
mod dot;
mod json;
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

    /// All of the tree as JSON; see [the schema](crate::render#json).
    #[must_use]
    pub fn json(&self) -> impl Display {
        from_fn(|f| json::tree(self, f))
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
