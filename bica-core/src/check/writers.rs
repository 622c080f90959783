//! Several components that write one child in one cycle.

use super::worst_case::{modulates_by, most_writers, two_writers};
use super::{CAPACITY, Choice, Path, Set, WorstCase, steps};
use crate::graph::{Graph, InForce, Link, LinkKind};

/// Components that modulate one child in one cycle.
#[derive(Clone, Copy, Debug)]
pub struct Writers {
    /// The components, in the order in which they run: by `&mut C` or `&mut Rate<C>`.
    pub order: Path,
    /// How many of them run before the child.
    pub before: usize,
    /// What the machines do in that cycle.
    pub case: WorstCase,
}

impl Writers {
    /// Index of the component whose values are in force: the last one that runs before the child. If none does, it is the last one of the
    /// cycle before.
    ///
    /// # Panics
    /// If the list is empty, which [`writers`] never returns.
    #[must_use]
    pub const fn in_force(&self) -> usize {
        self.order.get(if self.before == 0 { self.order.len() } else { self.before } - 1)
    }
}

/// Returns the largest set of components that can modulate a child in one cycle; `None` if never more than one does. States of one machine
/// exclude each other.
///
/// # Panics
/// If there are more than [`CAPACITY`](super::CAPACITY) nodes, or states in one of them.
#[must_use]
pub const fn writers(graph: &Graph, child: usize) -> Option<Writers> {
    if activators(graph, child) < 2 {
        return None;
    }
    let case = most_writers(graph, child, steps(graph));
    if case.sum < 2.0 { None } else { Some(in_case(graph, child, &case)) }
}

/// Returns the writers of a case in which several write a child that does not say which of them counts.
pub(super) const fn meeting(graph: &Graph, child: usize) -> Option<Writers> {
    if graph.nodes[child].writers.is_some() || activators(graph, child) < 2 {
        return None;
    }
    let case = two_writers(graph, child, steps(graph));
    if case.sum < 2.0 { None } else { Some(in_case(graph, child, &case)) }
}

/// Returns the first child that several components can write in one cycle and that does not say which of them counts.
pub(super) const fn unordered(graph: &Graph) -> Option<usize> {
    let mut child = 0;
    while child < graph.nodes.len() {
        if meeting(graph, child).is_some() {
            return Some(child);
        }
        child += 1;
    }
    None
}

/// The writers in a case.
const fn in_case(graph: &Graph, child: usize, case: &WorstCase) -> Writers {
    let runs = Runs::of(graph, case);
    let (mut order, mut before, mut place) = (Path::EMPTY, 0, 0);
    while place < runs.order.len() {
        let index = runs.order.get(place);
        if index == child {
            before = order.len();
        } else if modulates_by(&graph.nodes[index], case.choices[index], child) {
            order.push(index);
        }
        place += 1;
    }
    Writers { order, before, case: *case }
}

/// Number of components that modulate a child in any state.
const fn activators(graph: &Graph, child: usize) -> usize {
    let (mut index, mut count) = (0, 0);
    while index < graph.nodes.len() {
        count += modulates_by(&graph.nodes[index], Choice::Any, child) as usize;
        index += 1;
    }
    count
}

/// A component of which some children are visited.
#[derive(Clone, Copy)]
struct Open {
    component: usize,
    /// Index of the next link.
    link: usize,
    pass: Pass,
}

/// What a visit is about to visit.
#[derive(Clone, Copy)]
enum Pass {
    /// What the state requires in which the cycle begins.
    Required,
    /// What the state requires that is entered.
    Entered,
    /// What is written.
    Written,
}

/// The runs of a cycle in which each machine does what a case says, and all components are due.
struct Runs<'a> {
    graph: &'a Graph,
    case: &'a WorstCase,
    visited: Set,
    put_off: Set,
    order: Path,
    /// A stack of our own because constants may recurse only a little.
    open: [Open; CAPACITY],
    depth: usize,
}

impl<'a> Runs<'a> {
    const fn of(graph: &'a Graph, case: &'a WorstCase) -> Self {
        let open = [Open { component: 0, link: 0, pass: Pass::Required }; CAPACITY];
        let mut runs =
            Self { graph, case, visited: Set::EMPTY, put_off: Set::EMPTY, order: Path::EMPTY, open, depth: 0 };
        runs.visit(graph.root);
        let (order, mut place) = (super::worst_case::order(graph.nodes), 0);
        while place < graph.nodes.len() {
            if runs.put_off.contains(order[place]) {
                runs.visit(order[place]);
            }
            place += 1;
        }
        runs
    }

    /// Visits a component and what it activates.
    const fn visit(&mut self, component: usize) {
        self.open(component);
        while self.depth > 0 {
            let top = &mut self.open[self.depth - 1];
            let (component, pass, links) = (top.component, top.pass, self.graph.nodes[top.component].links);
            if top.link < links.len() {
                let link = links[top.link];
                top.link += 1;
                if self.holds(component, pass, &link) {
                    self.activate(link.to);
                }
                continue;
            }
            top.link = 0;
            match pass {
                Pass::Required => top.pass = Pass::Entered,
                Pass::Entered => {
                    top.pass = Pass::Written;
                    self.order.push(component);
                }
                Pass::Written => self.depth -= 1,
            }
        }
    }

    const fn activate(&mut self, component: usize) {
        if self.graph.nodes[component].is_last() {
            self.put_off = self.put_off.with(component);
        } else {
            self.open(component);
        }
    }

    const fn open(&mut self, component: usize) {
        if !self.visited.contains(component) {
            self.visited = self.visited.with(component);
            self.open[self.depth] = Open { component, link: 0, pass: Pass::Required };
            self.depth += 1;
        }
    }

    /// Whether a link leads to a visit.
    const fn holds(&self, component: usize, pass: Pass, link: &Link) -> bool {
        let (from, to) = match self.case.choices[component] {
            Choice::State(state) => (Some(state), Some(state)),
            Choice::Transition(transition) => {
                let transition = &self.graph.nodes[component].transitions[transition];
                (Some(transition.from), Some(transition.to))
            }
            Choice::None | Choice::Any => (None, None),
        };
        let (kind, state) = match pass {
            Pass::Required => (LinkKind::Requirement, from),
            Pass::Entered => (LinkKind::Requirement, to),
            Pass::Written => (LinkKind::Modulation, to),
        };
        matches!(link.kind, LinkKind::Requirement) == matches!(kind, LinkKind::Requirement)
            && match (link.state, state) {
                (Some(of), Some(state)) => of == state,
                _ => true,
            }
    }
}

impl InForce {
    /// The word in the source: `"first"` or `"last"`.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::First => "first",
            Self::Last => "last",
        }
    }
}
