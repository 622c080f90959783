//! The graph that this program describes.

use bica::Tree;
use bica::graph::{Graph, Node};
use bica_player::Forward;

/// The forward's components, links, states and transitions. Parameters, information and modulations are left out: nothing
/// here can use them, and their descriptions would occupy flash.
pub(crate) static GRAPH: Graph = Graph { nodes: &NODES, ..Forward::GRAPH };

static NODES: [Node; Forward::COUNT] = {
    let mut nodes = [Node::new(""); Forward::COUNT];
    let mut index = 0;
    while index < nodes.len() {
        nodes[index] = Node { params: &[], info: &[], modulations: &[], ..Forward::GRAPH.nodes[index] };
        index += 1;
    }
    nodes
};
