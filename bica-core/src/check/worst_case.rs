//! Search for the combination of states with the largest sum.
//!
//! A tick is one call chain, so what can run in one cycle is the set of components that it visits, each once. Which they
//! are depends on the machines among them: in one cycle a machine is in one state, with its links, or takes one
//! transition, with the requirements of the state that it leaves and all links of the one that it enters. Links without
//! a state always hold. States that no transition reaches count for nothing, and every combination of states that each
//! machine can reach is taken to be possible.
//!
//! The search goes through the machines from the root on, branches over what each can do if it is active at all, and
//! leaves out branches that cannot exceed what is found already. That is exact. The number of branches is limited
//! ([`steps`]) because the compiler has to go through them; beyond the limit the machines not yet decided are taken to
//! be in all their states at once, which is never less than the truth and sets [`WorstCase::exact`] to false.

use super::reach::{all_links, links_in, states_reached};
use super::weight::{Weight, modulates};
use super::{CAPACITY, Set, ranks};
use crate::graph::{Graph, Node};

/// Returns how many branches the checks search before they take an upper bound: so many that the compiler needs some
/// tenths of a second; 2400 for a tree of twenty components.
#[must_use]
pub const fn steps(graph: &Graph) -> usize {
    50_000 / (graph.nodes.len() + 1)
}

/// What a machine does in a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// Nothing to choose: no machine, or not active.
    None,
    /// Stays in a state, by index in [`Node::states`].
    State(usize),
    /// Takes a transition, by index in [`Node::transitions`].
    Transition(usize),
    /// Not decided within the limit: any of its states and transitions.
    Any,
}

/// The combination of states with the largest sum.
#[derive(Clone, Copy, Debug)]
pub struct WorstCase {
    /// The sum over `active`, in µs of one cycle or as a share of one processor.
    pub sum: f64,
    /// The components that are active.
    pub active: Set,
    /// What each component does, by index in [`Graph::nodes`].
    pub choices: [Choice; CAPACITY],
    /// Whether `sum` can be reached; otherwise it is an upper bound.
    pub exact: bool,
}

/// Returns the longest time that one cycle can take by the declared budgets, in µs: the set of components that can run in one
/// cycle with the largest sum of budgets. A component without a budget counts nothing.
///
/// With an activation cycle in the graph the result has no meaning.
///
/// # Panics
/// If there are more than [`CAPACITY`] nodes, or states in one of them.
#[must_use]
pub const fn longest_chain(graph: &Graph, steps: usize) -> WorstCase {
    Search::new(graph, Weight::Time, steps).run()
}

/// Returns the largest share of a processor that the tree can need while its machines stay in their states: Σ budget × rate of
/// the active components, 1 being all of it. A component without a rate runs in every cycle; one without a budget counts
/// nothing.
///
/// With an activation cycle in the graph the result has no meaning.
///
/// # Panics
/// If there are more than [`CAPACITY`] nodes, or states in one of them.
#[must_use]
pub const fn load(graph: &Graph, steps: usize) -> WorstCase {
    Search::new(graph, Weight::Load, steps).run()
}

/// Returns the combination in which most components modulate `child` in one cycle; the sum is their number.
///
/// With an activation cycle in the graph the result has no meaning.
///
/// # Panics
/// If there are more than [`CAPACITY`] nodes, or states in one of them.
#[must_use]
pub const fn most_writers(graph: &Graph, child: usize, steps: usize) -> WorstCase {
    Search::new(graph, Weight::Modulates(child), steps).run()
}

/// Returns a combination in which at least two components modulate `child` in one cycle, if there is one.
pub(super) const fn two_writers(graph: &Graph, child: usize, steps: usize) -> WorstCase {
    Search { enough: 2.0, ..Search::new(graph, Weight::Modulates(child), steps) }.run()
}

struct Search<'g> {
    graph: &'g Graph,
    /// A sum with which the search ends.
    enough: f64,
    transitions: bool,
    /// The child whose writers are counted. What a machine counts then depends on its state.
    child: Option<usize>,
    /// The components whose states matter to the sum; others stay in their initial state.
    relevant: Set,
    weights: [f64; CAPACITY],
    /// The nodes, activators first.
    order: [usize; CAPACITY],
    /// The states that each node can be in, and what it activates in any of them.
    states: [Set; CAPACITY],
    all_links: [Set; CAPACITY],
    steps: usize,
    /// The machines decided about; a stack of our own because constants may recurse only a little.
    branches: [Branch; CAPACITY],
    depth: usize,
    choices: [Choice; CAPACITY],
    best: WorstCase,
}

/// A machine to decide about.
#[derive(Clone, Copy)]
struct Branch {
    index: usize,
    /// Place in the order at which the nodes after the machine start.
    place: usize,
    /// What is active whatever the machine does.
    active: Set,
    /// The weight of the machine and of what is active before it.
    sum: f64,
    /// What to try next: the transitions and then the states are counted through.
    next: usize,
}

impl<'g> Search<'g> {
    const fn new(graph: &'g Graph, weight: Weight, steps: usize) -> Self {
        let mut states = [Set::EMPTY; CAPACITY];
        let mut all = [Set::EMPTY; CAPACITY];
        let mut node = 0;
        while node < graph.nodes.len() {
            states[node] = states_reached(&graph.nodes[node]);
            all[node] = all_links(&graph.nodes[node]);
            node += 1;
        }
        let choices = [Choice::None; CAPACITY];
        Self {
            graph,
            enough: f64::INFINITY,
            transitions: !matches!(weight, Weight::Load),
            child: if let Weight::Modulates(child) = weight { Some(child) } else { None },
            relevant: if let Weight::Modulates(child) = weight { leading_to(graph, child) } else { Set::EMPTY },
            weights: weight.of_all(graph),
            order: order(graph.nodes),
            states,
            all_links: all,
            steps,
            branches: [Branch { index: 0, place: 0, active: Set::EMPTY, sum: 0.0, next: 0 }; CAPACITY],
            depth: 0,
            choices,
            best: WorstCase { sum: -1.0, active: Set::EMPTY, choices, exact: true },
        }
    }

    const fn run(mut self) -> WorstCase {
        self.explore(0, Set::EMPTY.with(self.graph.root), 0.0);
        while self.depth > 0 && self.best.sum < self.enough {
            let branch = self.branches[self.depth - 1];
            let (choice, links, next) = if self.steps > 0 {
                self.option(branch.index, branch.next)
            } else {
                self.options(branch.index, branch.next)
            };
            self.choices[branch.index] = choice;
            self.branches[self.depth - 1].next = next;
            if matches!(choice, Choice::None) {
                self.depth -= 1;
            } else {
                let sum = branch.sum + self.weight_of(branch.index, choice);
                self.explore(branch.place, branch.active.union(links), sum);
            }
        }
        self.best
    }

    /// Decides about the machines from `place` in the order on, given what is active because of those before and the
    /// sum of these.
    const fn explore(&mut self, mut place: usize, mut active: Set, mut sum: f64) {
        let (most, limit) = self.limit(place, active, sum);
        let exhausted = self.steps == 0;
        self.steps = self.steps.saturating_sub(1);
        if limit <= self.best.sum {
            return;
        }
        if exhausted {
            return self.give_up(place, most, limit);
        }
        while place < self.graph.nodes.len() {
            let index = self.order[place];
            place += 1;
            if active.contains(index) {
                sum += self.weight(index);
                active = active.union(links_in(&self.graph.nodes[index], None, false));
                if !self.states[index].is_empty() && !self.matters(index) {
                    let initial = initial(&self.graph.nodes[index]);
                    self.choices[index] = Choice::State(initial);
                    active = active.union(links_in(&self.graph.nodes[index], Some(initial), false));
                } else if !self.states[index].is_empty() {
                    self.branches[self.depth] = Branch { index, place, active, sum, next: 0 };
                    self.depth += 1;
                    return;
                }
            }
        }
        self.best = WorstCase { sum, active, choices: self.choices, exact: true };
    }

    /// Whether the states of a machine matter to the sum.
    const fn matters(&self, index: usize) -> bool {
        self.child.is_none() || self.relevant.contains(index)
    }

    /// The weight of a component whatever it does.
    const fn weight(&self, index: usize) -> f64 {
        if self.child.is_some() && !self.states[index].is_empty() { 0.0 } else { self.weights[index] }
    }

    /// The weight of what a machine does.
    const fn weight_of(&self, index: usize, choice: Choice) -> f64 {
        let Some(child) = self.child else { return 0.0 };
        match choice {
            Choice::Any => self.weights[index],
            _ => modulates_by(&self.graph.nodes[index], choice, child) as u8 as f64,
        }
    }

    /// What the machine `index` can do, `next` or the first possible behind, with its links, and what is next then;
    /// nothing at the end.
    ///
    /// Transitions come first: they include the state that they enter.
    const fn option(&self, index: usize, mut next: usize) -> (Choice, Set, usize) {
        let node = &self.graph.nodes[index];
        let transitions = if self.transitions { node.transitions.len() } else { 0 };
        while next < transitions {
            let transition = &node.transitions[next];
            if self.states[index].contains(transition.from) {
                let read = links_in(node, Some(transition.from), true);
                return (Choice::Transition(next), read.union(links_in(node, Some(transition.to), false)), next + 1);
            }
            next += 1;
        }
        while next - transitions < node.states.len() {
            let state = next - transitions;
            if self.states[index].contains(state) {
                return (Choice::State(state), links_in(node, Some(state), false), next + 1);
            }
            next += 1;
        }
        (Choice::None, Set::EMPTY, next)
    }

    /// All that the machine can do from `next` on, at once.
    const fn options(&self, index: usize, next: usize) -> (Choice, Set, usize) {
        let (mut choice, mut links, mut next) = self.option(index, next);
        let mut more = !matches!(choice, Choice::None);
        while more {
            let (another, others, after) = self.option(index, next);
            links = links.union(others);
            next = after;
            more = !matches!(another, Choice::None);
            choice = Choice::Any;
        }
        (choice, links, next)
    }

    /// The upper bound of a branch: the machines from `place` in the order on are in all their states at once.
    const fn limit(&self, mut place: usize, mut active: Set, mut sum: f64) -> (Set, f64) {
        while place < self.graph.nodes.len() {
            let index = self.order[place];
            if active.contains(index) {
                sum += self.weights[index];
                active = active.union(self.all_links[index]);
            }
            place += 1;
        }
        (active, sum)
    }

    /// Takes the upper bound of a branch as its sum.
    const fn give_up(&mut self, mut place: usize, active: Set, sum: f64) {
        self.best = WorstCase { sum, active, choices: self.choices, exact: false };
        while place < self.graph.nodes.len() {
            let index = self.order[place];
            if active.contains(index) && !self.states[index].is_empty() {
                self.best.choices[index] = Choice::Any;
            }
            place += 1;
        }
    }
}

/// Whether a component modulates a child in a cycle in which it does this. A transition calls functions of both states.
pub(super) const fn modulates_by(node: &Node, choice: Choice, child: usize) -> bool {
    match choice {
        Choice::None | Choice::Any => modulates(node, None, child),
        Choice::State(state) => modulates(node, Some(state), child),
        Choice::Transition(transition) => {
            let transition = &node.transitions[transition];
            modulates(node, Some(transition.from), child) || modulates(node, Some(transition.to), child)
        }
    }
}

/// Index of the state in which a machine begins.
const fn initial(node: &Node) -> usize {
    let mut index = 0;
    while index + 1 < node.states.len() && !node.states[index].initial {
        index += 1;
    }
    index
}

/// The components that modulate a child, and those that activate one of them, directly or not.
pub(super) const fn leading_to(graph: &Graph, child: usize) -> Set {
    let (mut leading, mut changed) = (Set::EMPTY, true);
    while changed {
        changed = false;
        // Activators are mostly listed before what they activate.
        let mut index = graph.nodes.len();
        while index > 0 {
            index -= 1;
            let node = &graph.nodes[index];
            if !leading.contains(index) && (modulates(node, None, child) || links_into(node, &leading)) {
                leading = leading.with(index);
                changed = true;
            }
        }
    }
    leading
}

/// Whether a component activates one of a set in any state.
const fn links_into(node: &Node, set: &Set) -> bool {
    let mut link = 0;
    while link < node.links.len() && !set.contains(node.links[link].to) {
        link += 1;
    }
    link < node.links.len()
}

/// The nodes sorted by rank; only the first `nodes.len()` entries count.
pub(super) const fn order(nodes: &[Node]) -> [usize; CAPACITY] {
    let mut order = [0; CAPACITY];
    let ranks: [usize; CAPACITY] = ranks(nodes);
    let mut node = 0;
    while node < nodes.len() {
        order[ranks[node]] = node;
        node += 1;
    }
    order
}
