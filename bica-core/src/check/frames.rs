//! The frames that outputs place in each other: each has one place, and none lies in itself.

use crate::graph::Graph;
use crate::output::Output;
use crate::params::declare::equal;

/// An output: index of its component, and its index among the outputs of the component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutputIndex(
    /// Index of the component.
    pub usize,
    /// Index of the output.
    pub usize,
);

impl OutputIndex {
    pub(super) const fn of(&self, graph: &Graph) -> &'static Output {
        &graph.nodes[self.0].outputs[self.1]
    }

    pub(super) const fn frame(&self, graph: &Graph) -> Option<&'static str> {
        match self.of(graph).placement {
            Some(placement) => Some(placement.frame),
            None => None,
        }
    }

    pub(super) const fn child(&self, graph: &Graph) -> Option<&'static str> {
        match self.of(graph).placement {
            Some(placement) => placement.child,
            None => None,
        }
    }

    /// The next output of the tree, whether it exists or not.
    const fn next(&self) -> Self {
        Self(self.0, self.1 + 1)
    }
}

/// Returns the first output from `from` that is the place of a frame, of `wanted` if it is given.
const fn place(graph: &Graph, wanted: Option<&str>, from: OutputIndex) -> Option<OutputIndex> {
    let mut output = from;
    while output.0 < graph.nodes.len() {
        if output.1 >= graph.nodes[output.0].outputs.len() {
            output = OutputIndex(output.0 + 1, 0);
            continue;
        }
        match (output.child(graph), wanted) {
            (Some(child), Some(wanted)) if equal(child, wanted) => return Some(output),
            (Some(_), None) => return Some(output),
            _ => output = output.next(),
        }
    }
    None
}

/// Returns two outputs that are the place of one frame.
pub(super) const fn two_places(graph: &Graph) -> Option<(OutputIndex, OutputIndex)> {
    let mut at = place(graph, None, OutputIndex(0, 0));
    while let Some(first) = at {
        if let Some(second) = place(graph, first.child(graph), first.next()) {
            return Some((first, second));
        }
        at = place(graph, None, first.next());
    }
    None
}

/// Returns the output that places the frame in which the value of this one is given.
pub(super) const fn parent(graph: &Graph, output: OutputIndex) -> Option<OutputIndex> {
    place(graph, output.frame(graph), OutputIndex(0, 0))
}

/// Returns the first output whose frame lies in itself. Each frame must have one place.
pub(super) const fn frame_cycle(graph: &Graph) -> Option<OutputIndex> {
    let (mut at, mut frames) = (place(graph, None, OutputIndex(0, 0)), 0_usize);
    while let Some(first) = at {
        frames += 1;
        at = place(graph, None, first.next());
    }
    at = place(graph, None, OutputIndex(0, 0));
    while let Some(first) = at {
        let (mut here, mut steps) = (parent(graph, first), 0);
        while let Some(reached) = here {
            if reached.0 == first.0 && reached.1 == first.1 {
                return Some(first);
            }
            steps += 1;
            // A walk longer than the number of frames is in a cycle without `first`.
            here = if steps > frames { None } else { parent(graph, reached) };
        }
        at = place(graph, None, first.next());
    }
    None
}
