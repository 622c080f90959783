//! The tree of this image, and its graph.

use bica::Tree;
use bica::graph::Graph;
#[cfg(not(feature = "monitor"))]
use bica::graph::Node;

#[cfg(not(feature = "monitor"))]
pub(crate) use bica_player::Forward;
#[cfg(feature = "monitor")]
pub(crate) use bica_player::tunable::Forward;

/// The graph that this program describes: all but the doc comments, which would occupy flash.
#[cfg(feature = "monitor")]
pub(crate) static GRAPH: Graph = Forward::GRAPH;

/// The graph that this program describes: components, links, states and transitions. Roles, parameters, outputs and
/// modulations are omitted: this program cannot use them, and their descriptions would occupy flash.
#[cfg(not(feature = "monitor"))]
pub(crate) static GRAPH: Graph = Graph { nodes: &NODES, roles: &[], ..Forward::GRAPH };

#[cfg(not(feature = "monitor"))]
static NODES: [Node; Forward::COUNT] = {
    let mut nodes = [Node::new(""); Forward::COUNT];
    let mut index = 0;
    while index < nodes.len() {
        nodes[index] = Node { params: &[], outputs: &[], modulations: &[], ..Forward::GRAPH.nodes[index] };
        index += 1;
    }
    nodes
};
