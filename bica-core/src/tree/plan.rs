//! The plans of a tree: what is known of a tick before the program runs.
//!
//! A tree has one plan for each state of its root, or one if the root has no states. In a plan a component is *fixed* if
//! every cycle visits it as long as the root stays in that state, and the same link always leads to it first. Only the
//! components that another machine reaches, and that were not visited before it, are not fixed.
//!
//! In a *steady* tick every fixed component was active in the previous cycle and is not held latent. So it needs no test
//! whether it is latent, and the links to it that are not the first need no test whether it was visited. All other
//! components are visited as in any cycle.
//!
//! If every component is fixed, and the root has no states, a steady tick visits no other components. Then it keeps the parity
//! of the previous cycle, so that the components need not record their visits.

use crate::check::{CAPACITY, Set};
use crate::graph::{Graph, Link, LinkKind, Node};

/// Largest number of plans; a root with more states has none. A microcontroller has no plans, which would make its program
/// larger.
const MOST: usize = if cfg!(target_os = "none") { 0 } else { 16 };
/// In place of a component: no link of a fixed component leads here.
const NONE: u16 = u16::MAX;

/// The plans of a tree.
#[derive(Clone, Copy)]
pub struct Plans {
    /// Number of components.
    count: usize,
    first: &'static [u16],
    fixed: &'static [Set],
    /// The root has no states, and every component is fixed.
    whole: bool,
}

impl Plans {
    /// No plan: every tick tests each component.
    pub const NONE: Self = Self { count: 0, first: &[], fixed: &[], whole: false };

    /// Whether there is a plan.
    #[must_use]
    pub const fn exist(&self) -> bool {
        !self.fixed.is_empty()
    }

    /// Whether every component is fixed in every tick. Then no visit of a steady tick needs the parity of the cycle.
    #[must_use]
    pub const fn is_whole(&self) -> bool {
        self.whole
    }

    /// Whether in plan `plan` the link from the fixed component `from` is the first one to `to`.
    #[must_use]
    pub const fn is_first(&self, plan: usize, from: usize, to: usize) -> bool {
        plan < self.fixed.len() && to < self.count && self.first[plan * self.count + to] as usize == from
    }

    /// Whether a component is fixed in plan `plan`.
    #[must_use]
    pub const fn is_fixed(&self, plan: usize, component: usize) -> bool {
        plan < self.fixed.len() && component < self.count && self.fixed[plan].contains(component)
    }
}

/// The plans of a tree of `N` components, while they are computed.
pub struct Planned<const N: usize> {
    /// The component whose link is the first one to each component.
    first: [[u16; N]; MOST],
    fixed: [Set; MOST],
    /// Number of plans.
    len: usize,
    /// The root has no states, and every component is fixed.
    whole: bool,
}

impl<const N: usize> Planned<N> {
    /// Computes the plans of a graph. `rates` are for each component the ones whose rates its functions borrow.
    #[must_use]
    pub const fn of(graph: &Graph, rates: &[&[usize]]) -> Self {
        let mut planned = Self { first: [[NONE; N]; MOST], fixed: [Set::EMPTY; MOST], len: 0, whole: false };
        // A larger tree, or one with another number of nodes, is reported by the check of its graph.
        if N > CAPACITY || graph.nodes.len() != N || graph.root >= N {
            return planned;
        }
        let unusual = unusual(graph.nodes, rates);
        let states = graph.nodes[graph.root].states.len();
        let count = if states == 0 { 1 } else { states };
        if count > MOST || unusual.contains(graph.root) {
            return planned;
        }
        while planned.len < count {
            let walk = Walk::<N>::of(graph, planned.len, &unusual);
            planned.first[planned.len] = walk.first;
            planned.fixed[planned.len] = walk.fixed;
            planned.whole = states == 0 && contains_all(&walk.fixed, N);
            planned.len += 1;
        }
        planned
    }

    /// The result.
    #[must_use]
    pub const fn plans(&'static self) -> Plans {
        let fixed = self.fixed.split_at(self.len).0;
        Plans { count: N, first: self.first.as_flattened(), fixed, whole: self.whole }
    }
}

/// Whether a set contains all indices below `count`.
const fn contains_all(set: &Set, count: usize) -> bool {
    let mut index = 0;
    while index < count && set.contains(index) {
        index += 1;
    }
    index == count
}

/// Whether the children of a component depend on its state.
const fn has_choice(node: &Node) -> bool {
    !node.states.is_empty() && !node.links.is_empty()
}

/// Returns the components that may not run in every cycle in which they are visited, though they declare no rate.
const fn unusual(nodes: &[Node], rates: &[&[usize]]) -> Set {
    let (mut unusual, mut component) = (Set::EMPTY, 0);
    while component < rates.len() {
        let mut borrowed = 0;
        while borrowed < rates[component].len() {
            let of = rates[component][borrowed];
            if nodes[of].hz.is_none() {
                unusual = unusual.with(of);
            }
            borrowed += 1;
        }
        component += 1;
    }
    unusual
}

/// A fixed component whose children are being planned.
#[derive(Clone, Copy)]
struct Open {
    component: usize,
    /// Index of the next link.
    link: usize,
    /// Whether the component's own code comes before that link.
    ran: bool,
}

/// One plan, while the links are followed.
struct Walk<const N: usize> {
    first: [u16; N],
    fixed: Set,
    /// Components that a visit of one that is not fixed may reach.
    uncertain: Set,
    open: [Open; N],
    depth: usize,
}

impl<const N: usize> Walk<N> {
    /// Follows the links depth first, as visits do. It keeps its own stack, because a path may be longer than the compiler
    /// lets a constant function call itself.
    const fn of(graph: &Graph, state: usize, unusual: &Set) -> Self {
        let nowhere = Open { component: 0, link: 0, ran: false };
        let mut walk =
            Self { first: [NONE; N], fixed: Set::EMPTY, uncertain: Set::EMPTY, open: [nowhere; N], depth: 0 };
        walk.fix(graph.root);
        while walk.depth > 0 {
            let top = &mut walk.open[walk.depth - 1];
            let (from, links) = (top.component, graph.nodes[top.component].links);
            if top.link == links.len() {
                if top.ran {
                    walk.depth -= 1;
                } else {
                    (top.ran, top.link) = (true, 0);
                }
                continue;
            }
            let (link, ran) = (links[top.link], top.ran);
            top.link += 1;
            if matches!(link.kind, LinkKind::Modulation) == ran && applies(&link, state) {
                walk.visit(graph.nodes, (from, link.to), unusual);
            }
        }
        walk
    }

    const fn visit(&mut self, nodes: &[Node], (from, to): (usize, usize), unusual: &Set) {
        // What is put off is visited after all others, and tests whether they were visited.
        if self.first[to] != NONE || self.fixed.contains(to) || nodes[to].is_last() {
            return;
        }
        self.first[to] = from as u16;
        if has_choice(&nodes[to]) || unusual.contains(to) {
            self.reach(nodes, to);
        } else if !self.uncertain.contains(to) {
            self.fix(to);
        }
    }

    const fn fix(&mut self, component: usize) {
        self.fixed = self.fixed.with(component);
        self.open[self.depth] = Open { component, link: 0, ran: false };
        self.depth += 1;
    }

    /// Marks all that a visit of `component` may reach.
    const fn reach(&mut self, nodes: &[Node], component: usize) {
        let (mut reached, mut count, mut done) = ([0_u16; N], 1, 0);
        reached[0] = component as u16;
        while done < count {
            let links = nodes[reached[done] as usize].links;
            let mut link = 0;
            while link < links.len() {
                let to = links[link].to;
                if !self.uncertain.contains(to) {
                    self.uncertain = self.uncertain.with(to);
                    reached[count] = to as u16;
                    count += 1;
                }
                link += 1;
            }
            done += 1;
        }
    }
}

/// Whether a link of a fixed component counts; only the root has links that depend on a state.
const fn applies(link: &Link, state: usize) -> bool {
    match link.state {
        Some(of) => of == state,
        None => true,
    }
}
