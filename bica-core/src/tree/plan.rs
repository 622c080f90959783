//! The plan of a steady tick: what is known of a tick before the program runs.
//!
//! A component is *fixed* if every cycle visits it as long as the root is visited: only components without states, and
//! state machines without links, lead to it. In a steady tick nothing that depends on requests is different from the
//! declaration: no fixed component is held, each has its declared rate, and all with the same rate run in the same
//! cycles. Then no fixed component needs to be marked as visited, which link is the first that leads to it is known here,
//! and one decision for each rate replaces one for each component.
//!
//! All other components are visited as in any cycle.

use crate::check::{CAPACITY, Set};
use crate::graph::{Graph, LinkKind, Node};

/// Largest number of different rates in a plan; components with further rates are not fixed. A microcontroller has no
/// plans, which would make its program larger.
pub(crate) const GROUPS: usize = if cfg!(target_os = "none") { 0 } else { 8 };
/// In place of a group: the component runs in every cycle.
const EVERY_CYCLE: u8 = u8::MAX - 1;
/// In place of a group: the component is not fixed.
const NOT_FIXED: u8 = u8::MAX;

/// In place of a component: no visit of a steady tick leads here first.
const NONE: u16 = u16::MAX;

/// The plan of a tree.
#[derive(Clone, Copy)]
pub struct Plan {
    /// Whether the root is fixed.
    exists: bool,
    /// Whether every component is fixed.
    is_whole: bool,
    parents: &'static [u16],
    rates: &'static [f32],
    groups: &'static [u8],
}

impl Plan {
    /// No plan: every tick visits each component.
    pub const NONE: Self = Self { exists: false, is_whole: false, parents: &[], rates: &[], groups: &[] };

    /// Whether there is a plan.
    #[must_use]
    pub const fn exists(&self) -> bool {
        self.exists
    }

    /// Whether every component is fixed.
    pub(crate) const fn is_whole(&self) -> bool {
        self.is_whole
    }

    /// Whether the visit of the fixed component `from` is the first of a steady tick that leads to `to`.
    #[must_use]
    pub const fn is_first(&self, from: usize, to: usize) -> bool {
        to < self.parents.len() && self.parents[to] as usize == from
    }

    /// Returns the declared rate of each group, 1/s.
    pub(crate) const fn rates(&self) -> &'static [f32] {
        self.rates
    }

    /// Returns the group of a fixed component that has a rate.
    pub(crate) const fn group(&self, component: usize) -> Option<usize> {
        if component < self.groups.len() && (self.groups[component] as usize) < GROUPS {
            return Some(self.groups[component] as usize);
        }
        None
    }

    /// Whether a component is fixed.
    #[must_use]
    pub const fn is_fixed(&self, component: usize) -> bool {
        component < self.groups.len() && self.groups[component] != NOT_FIXED
    }
}

/// The plan of a tree of `N` components, while it is computed.
pub struct Planned<const N: usize> {
    parents: [u16; N],
    /// Fixed components.
    fixed: [bool; N],
    count: usize,
    rates: [f32; GROUPS],
    rates_len: usize,
    groups: [u8; N],
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

impl<const N: usize> Planned<N> {
    /// Computes the plan of a graph. `order` are the components, activators before what they activate; `rates` are for
    /// each component the ones whose rates its functions borrow.
    #[must_use]
    pub const fn of(graph: &Graph, order: &[u16], rates: &[&[usize]]) -> Self {
        let mut planned = Self {
            parents: [NONE; N],
            fixed: [false; N],
            count: 0,
            rates: [0.0; GROUPS],
            rates_len: 0,
            groups: [NOT_FIXED; N],
        };
        // A larger tree, or one with another number of nodes, is reported by the check of its graph.
        if GROUPS > 0 && N <= CAPACITY && graph.nodes.len() == N && graph.root < N {
            planned.set_groups(graph.nodes);
            let visited = planned.visited(graph.nodes, order, rates);
            if !visited.contains(graph.root) {
                planned.walk(graph, &visited);
            }
        }
        planned.forget_visited();
        planned
    }

    /// The result.
    #[must_use]
    pub const fn plan(&'static self) -> Plan {
        Plan {
            exists: self.count > 0,
            is_whole: self.count == N,
            parents: &self.parents,
            rates: self.rates.split_at(self.rates_len).0,
            groups: &self.groups,
        }
    }

    /// Assigns each component to the group of its rate as long as there are groups.
    const fn set_groups(&mut self, nodes: &[Node]) {
        let mut component = 0;
        while component < N {
            self.groups[component] = match nodes[component].hz {
                None => EVERY_CYCLE,
                Some(hz) => self.group(hz),
            };
            component += 1;
        }
    }

    const fn group(&mut self, hz: f32) -> u8 {
        let mut group = 0;
        while group < self.rates_len {
            if self.rates[group].to_bits() == hz.to_bits() {
                return group as u8;
            }
            group += 1;
        }
        if group == GROUPS {
            return NOT_FIXED;
        }
        self.rates[group] = hz;
        self.rates_len += 1;
        group as u8
    }

    /// Returns the components that are not fixed if they are reached: those whose children depend on their state, whose rate
    /// is borrowed or has no group, and all to which a path leads from one of these.
    const fn visited(&self, nodes: &[Node], order: &[u16], rates: &[&[usize]]) -> Set {
        let mut visited = Set::EMPTY;
        let mut component = 0;
        while component < N {
            let has_choice = !nodes[component].states.is_empty() && !nodes[component].links.is_empty();
            if has_choice || self.groups[component] == NOT_FIXED {
                visited = visited.with(component);
            }
            let mut borrowed = 0;
            while borrowed < rates[component].len() {
                visited = visited.with(rates[component][borrowed]);
                borrowed += 1;
            }
            component += 1;
        }
        let mut place = 0;
        while place < N {
            let from = order[place] as usize;
            let mut link = 0;
            while visited.contains(from) && link < nodes[from].links.len() {
                visited = visited.with(nodes[from].links[link].to);
                link += 1;
            }
            place += 1;
        }
        visited
    }

    /// Follows the links depth first, as visits do. It keeps its own stack, because a path may be longer than the compiler
    /// lets a constant function call itself.
    const fn walk(&mut self, graph: &Graph, visited: &Set) {
        let mut seen = Set::EMPTY.with(graph.root);
        let mut open = [Open { component: graph.root, link: 0, ran: false }; N];
        let mut depth = 1;
        self.fix(graph.root);
        while depth > 0 {
            let top = &mut open[depth - 1];
            let links = graph.nodes[top.component].links;
            if top.link == links.len() {
                if top.ran {
                    depth -= 1;
                } else {
                    (top.ran, top.link) = (true, 0);
                }
                continue;
            }
            let link = links[top.link];
            top.link += 1;
            if matches!(link.kind, LinkKind::Modulation) != top.ran || seen.contains(link.to) {
                continue;
            }
            seen = seen.with(link.to);
            self.parents[link.to] = top.component as u16;
            if !visited.contains(link.to) {
                self.fix(link.to);
                open[depth] = Open { component: link.to, link: 0, ran: false };
                depth += 1;
            }
        }
    }

    const fn fix(&mut self, component: usize) {
        self.fixed[component] = true;
        self.count += 1;
    }

    /// Leaves a group only to fixed components.
    const fn forget_visited(&mut self) {
        let mut component = 0;
        while component < N {
            if !self.fixed[component] {
                self.groups[component] = NOT_FIXED;
            }
            component += 1;
        }
    }
}
