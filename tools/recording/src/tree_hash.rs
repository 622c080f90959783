//! Hash of a tree's description.

use bica::graph::{Graph, LinkKind};

/// Returns a hash (FNV-1a, 64 bits) of what decides how a tree runs: names, rates, links, states and transitions. Doc comments
/// and time budgets are left out.
#[must_use]
pub fn tree_hash(graph: &Graph) -> u64 {
    let mut hash = Fnv::new();
    hash.text(graph.name);
    hash.number(u64::from(graph.cycle_hz.to_bits()));
    hash.number(graph.root as u64);
    for node in graph.nodes {
        hash.text(node.name);
        hash.number(node.hz.map_or(u64::MAX, |hz| hz.to_bits().into()));
        hash.number(u64::from(node.resume));
        for link in node.links {
            hash.number(link.to as u64);
            hash.number(u64::from(link.kind == LinkKind::Modulation));
            hash.number(link.state.map_or(u64::MAX, |state| state as u64));
        }
        for state in node.states {
            hash.text(state.name);
            hash.number(u64::from(state.initial));
        }
        for transition in node.transitions {
            hash.text(transition.name);
            hash.number(transition.from as u64);
            hash.number(transition.to as u64);
            hash.number(transition.after_ms.map_or(u64::MAX, u64::from));
        }
    }
    hash.0
}

/// FNV-1a hash of 64 bits (parameters of G. Fowler, L. Noll and K.-P. Vo).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Fnv(pub(crate) u64);

impl Fnv {
    pub(crate) const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    pub(crate) fn bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    fn number(&mut self, number: u64) {
        self.bytes(&number.to_le_bytes());
    }

    /// Adds a text and its length, so that two texts in a row are not another split of one text.
    fn text(&mut self, text: &str) {
        self.number(text.len() as u64);
        self.bytes(text.as_bytes());
    }
}

#[cfg(test)]
mod tests {
    use bica::graph::{Graph, Node, State, Transition};

    use super::tree_hash;

    const NODE: Node = Node::new("A");
    const GRAPH: Graph =
        Graph { name: "T", doc: "", cycle_hz: 100.0, budget_ms: None, tunable: false, root: 0, nodes: &[NODE] };
    const STATE: State = State { name: "s", doc: "", initial: true, last: false };
    const LATE: Transition = Transition { name: "t", doc: "", from: 0, to: 0, after_ms: Some(1) };

    #[test]
    fn what_decides_how_a_tree_runs_changes_the_hash_and_docs_do_not() {
        let hash = tree_hash(&GRAPH);
        assert_eq!(hash, tree_hash(&Graph { doc: "d", budget_ms: Some(1.0), ..GRAPH }));
        assert_eq!(hash, tree_hash(&Graph { nodes: &[Node { doc: "d", budget_us: Some(1.0), ..NODE }], ..GRAPH }));
        let others = [
            Graph { name: "U", ..GRAPH },
            Graph { cycle_hz: 50.0, ..GRAPH },
            Graph { nodes: &[Node { name: "B", ..NODE }], ..GRAPH },
            Graph { nodes: &[Node { hz: Some(30.0), ..NODE }], ..GRAPH },
            Graph { nodes: &[Node { resume: true, ..NODE }], ..GRAPH },
            Graph { nodes: &[Node { states: &[STATE], ..NODE }], ..GRAPH },
            Graph { nodes: &[Node { transitions: &[LATE], ..NODE }], ..GRAPH },
            Graph { nodes: &[Node { transitions: &[Transition { after_ms: Some(2), ..LATE }], ..NODE }], ..GRAPH },
            Graph { nodes: &[NODE, NODE], ..GRAPH },
        ];
        let mut hashes: Vec<u64> = others.iter().map(tree_hash).chain([hash]).collect();
        hashes.sort_unstable();
        hashes.dedup();
        assert_eq!(hashes.len(), others.len() + 1);
    }
}
