//! Activation cycles, and the topological order.

use super::{CAPACITY, Path, Set};
use crate::graph::Node;

/// Returns the rank of each node in a topological order: a permutation in which every activator comes before what it activates,
/// and nodes without an order between them keep that of the list. Entries after the last node are `N`.
///
/// With an activation cycle the nodes on it and after it come last.
///
/// # Panics
/// If `nodes` has more than `N` entries.
#[must_use]
pub const fn ranks<const N: usize>(nodes: &[Node]) -> [usize; N] {
    let mut activators = activators::<N>(nodes);
    let mut ranks = [N; N];
    let mut rank = 0;
    while rank < nodes.len() {
        let next = next_free(nodes.len(), &ranks, &activators);
        ranks[next] = rank;
        let mut link = 0;
        while link < nodes[next].links.len() {
            activators[nodes[next].links[link].to] -= 1;
            link += 1;
        }
        rank += 1;
    }
    ranks
}

/// Returns the number of links that end at each node.
///
/// # Panics
/// If `nodes` has more than `N` entries.
#[must_use]
pub const fn activators<const N: usize>(nodes: &[Node]) -> [usize; N] {
    assert!(nodes.len() <= N, "more nodes than ranks");
    let mut count = [0; N];
    let mut node = 0;
    while node < nodes.len() {
        let mut link = 0;
        while link < nodes[node].links.len() {
            count[nodes[node].links[link].to] += 1;
            link += 1;
        }
        node += 1;
    }
    count
}

/// The first node without a rank (`N`) that waits for no activator, or the first without a rank if all wait.
const fn next_free<const N: usize>(len: usize, ranks: &[usize; N], activators: &[usize; N]) -> usize {
    let mut waiting = N;
    let mut node = 0;
    while node < len {
        if ranks[node] == N && activators[node] == 0 {
            return node;
        }
        if ranks[node] == N && waiting == N {
            waiting = node;
        }
        node += 1;
    }
    waiting
}

/// Returns a path from a component over links back to itself, with that component at both ends; `None` if there is none.
///
/// The path starts at the one of its components that is listed first.
///
/// # Panics
/// If there are more than [`CAPACITY`] nodes.
#[must_use]
pub const fn cycle(nodes: &[Node]) -> Option<Path> {
    let ended = ended(nodes);
    let mut start = 0;
    while start < nodes.len() && ended.contains(start) {
        start += 1;
    }
    if start == nodes.len() {
        return None;
    }
    let mut seen = Set::EMPTY;
    while !seen.contains(start) {
        seen = seen.with(start);
        start = onward(nodes, &ended, start);
    }
    Some(closed(nodes, &ended, start))
}

/// The nodes from which every path ends.
const fn ended(nodes: &[Node]) -> Set {
    let mut ended = Set::EMPTY;
    let mut changed = true;
    while changed {
        changed = false;
        // Activators are mostly listed before what they activate.
        let mut node = nodes.len();
        while node > 0 {
            node -= 1;
            if !ended.contains(node) && onward(nodes, &ended, node) == CAPACITY {
                ended = ended.with(node);
                changed = true;
            }
        }
    }
    ended
}

/// The target of the first link of `node` from which a path does not end, or `CAPACITY` if there is none.
const fn onward(nodes: &[Node], ended: &Set, node: usize) -> usize {
    let mut link = 0;
    while link < nodes[node].links.len() {
        let to = nodes[node].links[link].to;
        if !ended.contains(to) {
            return to;
        }
        link += 1;
    }
    CAPACITY
}

/// The cycle that goes through `on_cycle`, from its first listed component round to itself.
const fn closed(nodes: &[Node], ended: &Set, on_cycle: usize) -> Path {
    let mut start = on_cycle;
    let mut node = onward(nodes, ended, on_cycle);
    while node != on_cycle {
        if node < start {
            start = node;
        }
        node = onward(nodes, ended, node);
    }
    let mut path = Path::EMPTY;
    path.push(start);
    node = onward(nodes, ended, start);
    while node != start {
        path.push(node);
        node = onward(nodes, ended, node);
    }
    path.push(start);
    path
}
