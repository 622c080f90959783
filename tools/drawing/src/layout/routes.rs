//! Route of each link through the layers.

use bica::graph::Graph;

use super::{Item, Layers, Segment};

/// Returns, for each component and each of its links, the segments of its route as indices of [`Layers::segments`].
#[must_use]
pub fn routes(graph: &Graph, layers: &Layers) -> Vec<Vec<Vec<usize>>> {
    let of_node = |from: usize| {
        let links = graph.nodes[from].links.iter();
        links
            .map(|link| {
                let leaves = |segment: &Segment| segment.upper == from && segment.kind == link.kind;
                let starts = (0..layers.segments.len()).filter(|&index| leaves(&layers.segments[index]));
                let mut routes = starts.map(|start| follow(layers, start));
                routes
                    .find(|route| route.last().is_some_and(|&end| layers.segments[end].lower == link.to))
                    .unwrap_or_default()
            })
            .collect()
    };
    (0..graph.nodes.len()).map(of_node).collect()
}

/// Returns a segment and those that continue it down to a component.
fn follow(layers: &Layers, start: usize) -> Vec<usize> {
    let mut route = vec![start];
    let mut end = layers.segments[start].lower;
    while layers.items[end] == Item::Dummy {
        let Some(next) = layers.segments.iter().position(|segment| segment.upper == end) else { break };
        route.push(next);
        end = layers.segments[next].lower;
    }
    route
}

#[cfg(test)]
mod tests {
    use super::*;
    use bica::Tree;
    use bica::graph::{Link, LinkKind, Node};
    use bica_player::Forward;

    const fn node(name: &'static str, links: &'static [Link]) -> Node {
        Node { links, ..Node::new(name) }
    }

    /// `Top` reads and modulates `Low`, past `Middle`.
    const BOTH: Graph = {
        const READ: LinkKind = LinkKind::Requirement;
        const WRITE: LinkKind = LinkKind::Modulation;
        const fn link(to: usize, kind: LinkKind, state: usize) -> Link {
            Link { to, kind, state: Some(state) }
        }
        let nodes = &[
            node("Top", &[link(2, READ, 0), link(2, WRITE, 1), link(1, READ, 0)]),
            node("Middle", &[link(2, WRITE, 0)]),
            node("Low", &[]),
        ];
        Graph { name: "Both", doc: "", cycle_hz: 100.0, budget_ms: None, tunable: false, root: 0, nodes }
    };

    #[test]
    fn routes_lead_from_owner_to_target() {
        for graph in [&Forward::GRAPH, &BOTH] {
            let layers = Layers::new(graph);
            for (from, (node, ways)) in graph.nodes.iter().zip(routes(graph, &layers)).enumerate() {
                for (link, way) in node.links.iter().zip(ways) {
                    let mut at = from;
                    for segment in way.iter().map(|&index| layers.segments[index]) {
                        assert_eq!((segment.upper, segment.kind), (at, link.kind), "{} to {}", node.name, link.to);
                        at = segment.lower;
                    }
                    assert_eq!(at, link.to, "{}", node.name);
                }
            }
        }
    }
}
