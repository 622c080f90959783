//! Route of each link through the layers.

use bica_wire::model::Description;

use super::{Item, Layers, Segment};

/// Returns, for each component and each of its links, the segments of its route as indices of [`Layers::segments`].
#[must_use]
pub fn routes(tree: &Description, layers: &Layers) -> Vec<Vec<Vec<usize>>> {
    let of_node = |from: usize| {
        let links = tree.components[from].links.iter();
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
    (0..tree.components.len()).map(of_node).collect()
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
