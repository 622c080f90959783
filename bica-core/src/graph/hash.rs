//! A hash over the description of a tree.

use super::{Graph, InForce, LinkKind, Node};
use crate::params::{Kind, Param};

/// Hash of a tree's description, FNV-1a with 64 bits: names, rates, links, states, transitions, outputs, modulations, and
/// parameters with their units and kinds.
///
/// The function of work counts if there is one: its name, and whether it runs in slices. So does `writers = last`.
///
/// What changes no meaning of an index is left out: doc comments, `tunable`, budgets, defaults and ranges of parameters, what transitions
/// carry, which ages and outcomes are asked, which states have a `#[before]`, roles, whether a modulation is a stop, and the time that
/// work takes. So programs of one tree with other default values have one hash.
#[must_use]
pub const fn hash(graph: &Graph) -> u64 {
    let mut hash = Fnv::new().text(graph.name).f32(Some(graph.cycle_hz)).number(graph.root as u64);
    hash = hash.number(graph.nodes.len() as u64);
    let mut index = 0;
    while index < graph.nodes.len() {
        hash = node(hash, &graph.nodes[index]);
        index += 1;
    }
    hash.0
}

const fn node(hash: Fnv, node: &Node) -> Fnv {
    let hash = hash.text(node.name).f32(node.hz).number(node.resume as u64);
    // A component that does not say so counts as it always did.
    let hash = if matches!(node.writers, Some(InForce::Last)) { hash.number(1) } else { hash };
    work(operator(params(machine(links(hash, node), node), node), node), node)
}

const fn links(mut hash: Fnv, node: &Node) -> Fnv {
    hash = hash.number(node.links.len() as u64);
    let mut index = 0;
    while index < node.links.len() {
        let link = node.links[index];
        let state = match link.state {
            Some(state) => state as u64 + 1,
            None => 0,
        };
        hash = hash.number(link.to as u64).number(matches!(link.kind, LinkKind::Modulation) as u64).number(state);
        index += 1;
    }
    hash
}

const fn machine(mut hash: Fnv, node: &Node) -> Fnv {
    hash = hash.number(node.states.len() as u64);
    let mut index = 0;
    while index < node.states.len() {
        let state = node.states[index];
        // A state without a result counts as it always did.
        let last = match state.end {
            None => state.last as u64,
            Some(end) => 2 + end as u64,
        };
        hash = hash.text(state.name).number(state.initial as u64).number(last);
        index += 1;
    }
    hash = hash.number(node.transitions.len() as u64);
    index = 0;
    while index < node.transitions.len() {
        let edge = node.transitions[index];
        let after = match (edge.after, edge.after_ms) {
            // The default of a parameter does not count.
            (Some(parameter), _) => u64::MAX - parameter as u64,
            (None, Some(ms)) => ms as u64 + 1,
            (None, None) => 0,
        };
        hash = hash.text(edge.name).number(edge.from as u64).number(edge.to as u64).number(after);
        if let Some(when) = edge.when {
            hash = hash.number(when.child as u64).number(when.end as u64);
        }
        if let Some(times) = edge.times {
            hash = hash.number(times as u64);
        }
        index += 1;
    }
    hash
}

const fn params(mut hash: Fnv, node: &Node) -> Fnv {
    hash = hash.number(node.params.len() as u64);
    let mut group = 0;
    while group < node.params.len() {
        hash = list(hash.text(node.params[group].name), node.params[group].params);
        group += 1;
    }
    hash
}

const fn operator(mut hash: Fnv, node: &Node) -> Fnv {
    hash = hash.number(node.outputs.len() as u64);
    let mut index = 0;
    while index < node.outputs.len() {
        let output = node.outputs[index];
        hash = unit(hash.text(output.name).text(output.ty), output.unit);
        index += 1;
    }
    hash = hash.number(node.modulations.len() as u64);
    index = 0;
    while index < node.modulations.len() {
        hash = list(hash.text(node.modulations[index].name), node.modulations[index].arguments);
        index += 1;
    }
    hash
}

/// Nothing without work: such trees keep the hash that they had before there was work.
const fn work(hash: Fnv, node: &Node) -> Fnv {
    match node.work {
        Some(work) => hash.text("work").text(work.name).number(work.slices as u64),
        None => hash,
    }
}

const fn unit(hash: Fnv, unit: Option<&str>) -> Fnv {
    match unit {
        Some(unit) => hash.number(1).text(unit),
        None => hash.number(0),
    }
}

const fn list(mut hash: Fnv, params: &[Param]) -> Fnv {
    hash = hash.number(params.len() as u64);
    let mut index = 0;
    while index < params.len() {
        hash = param(hash, &params[index]);
        index += 1;
    }
    hash
}

const fn param(hash: Fnv, param: &Param) -> Fnv {
    kind(unit(hash.text(param.name), param.unit), &param.kind)
}

const fn kind(hash: Fnv, kind: &Kind) -> Fnv {
    let mut hash = hash.text(kind.name());
    if let Kind::Choice { variants } = *kind {
        let mut index = 0;
        hash = hash.number(variants.len() as u64);
        while index < variants.len() {
            hash = hash.text(variants[index].name);
            index += 1;
        }
    }
    hash
}

/// FNV-1a.
#[derive(Clone, Copy)]
struct Fnv(u64);

impl Fnv {
    const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    const fn byte(self, byte: u8) -> Self {
        Self((self.0 ^ byte as u64).wrapping_mul(0x0000_0100_0000_01b3))
    }

    /// A number, its least significant byte first.
    const fn number(mut self, number: u64) -> Self {
        let bytes = number.to_le_bytes();
        let mut index = 0;
        while index < bytes.len() {
            self = self.byte(bytes[index]);
            index += 1;
        }
        self
    }

    /// A text and its length, so that the border between two texts counts.
    const fn text(self, text: &str) -> Self {
        let bytes = text.as_bytes();
        let (mut hash, mut index) = (self.number(bytes.len() as u64), 0);
        while index < bytes.len() {
            hash = hash.byte(bytes[index]);
            index += 1;
        }
        hash
    }

    /// The bits of a number, and whether there is one.
    const fn f32(self, number: Option<f32>) -> Self {
        match number {
            Some(number) => self.number(1).number(number.to_bits() as u64),
            None => self.number(0),
        }
    }
}
