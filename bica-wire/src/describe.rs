//! The graph of a tree as a sequence of messages.

use core::iter::FusedIterator;

#[cfg(feature = "std")]
use bica_core::Place;
#[cfg(feature = "std")]
use bica_core::action::Action;
#[cfg(feature = "std")]
use bica_core::check::writers;
use bica_core::graph::{self, Graph, LinkKind, Node};
#[cfg(feature = "std")]
use bica_core::graph::{Roles, WorkFunction};
use bica_core::params::{Kind, Param, Variant};

use crate::message::{GraphItem, Value};
use crate::text::truncate;

/// Largest size of a part of a doc comment, bytes.
const DOC_BYTES: usize = 512;
/// Largest size of the name of a type, bytes. A longer one is cut.
const TYPE_BYTES: usize = 512;

/// Describes a tree: the tree, its components, then for each component its links, states, transitions, parameters, outputs and
/// modulations, then the actions of its world, then [`GraphItem::End`]. A doc comment follows the item that it documents;
/// variants and arguments follow their owner.
#[must_use]
pub const fn describe(graph: &Graph) -> GraphItems<'_> {
    GraphItems {
        graph,
        list: List::Tree,
        node: 0,
        index: 0,
        doc: "",
        variants: &[],
        arguments: &[],
        #[cfg(feature = "std")]
        place: None,
        #[cfg(feature = "std")]
        roles: (Roles::NONE, 0),
        #[cfg(feature = "std")]
        others: None,
        #[cfg(feature = "std")]
        kind: None,
        #[cfg(feature = "std")]
        work: None,
        #[cfg(feature = "std")]
        actions: &[],
        count: 0,
    }
}

/// The items that describe a tree. It is a plain cursor, because a chain of iterators needs kilobytes of stack.
#[derive(Clone, Debug)]
pub struct GraphItems<'g> {
    graph: &'g Graph,
    list: List,
    /// Index of the component.
    node: usize,
    /// Index in the list.
    index: usize,
    /// Rest of the doc comment of the last item.
    doc: &'static str,
    /// Variants that follow the last item.
    variants: &'static [Variant],
    /// Arguments that follow the last item.
    arguments: &'static [Param],
    /// Place of the last argument. A microcontroller sends none: the code for it would occupy its memory.
    #[cfg(feature = "std")]
    place: Option<Place<'static>>,
    /// Roles of the last link, and the index among the tree's roles from which the search for the next one continues.
    #[cfg(feature = "std")]
    roles: (Roles, usize),
    /// Number of the queries and writers of the last component that were listed; `None` after the last of them.
    #[cfg(feature = "std")]
    others: Option<usize>,
    /// Type of the last component.
    #[cfg(feature = "std")]
    kind: Option<&'static str>,
    /// Function of the last component that runs beside the loop.
    #[cfg(feature = "std")]
    work: Option<&'static WorkFunction>,
    /// Actions that follow.
    #[cfg(feature = "std")]
    actions: &'static [Action],
    /// Number of items so far.
    count: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum List {
    Tree,
    Components,
    Links,
    States,
    Transitions,
    Params,
    Outputs,
    Modulations,
    End,
}

impl List {
    /// Returns the list after this one. The last list of a component is followed by the first list of the next component.
    const fn next(self) -> Self {
        match self {
            Self::Tree => Self::Components,
            Self::Components | Self::Modulations => Self::Links,
            Self::Links => Self::States,
            Self::States => Self::Transitions,
            Self::Transitions => Self::Params,
            Self::Params => Self::Outputs,
            Self::Outputs => Self::Modulations,
            Self::End => Self::End,
        }
    }
}

impl FusedIterator for GraphItems<'_> {}

impl Iterator for GraphItems<'_> {
    type Item = GraphItem<'static>;

    fn next(&mut self) -> Option<GraphItem<'static>> {
        let item = self.attachment().or_else(|| self.listed());
        #[cfg(feature = "std")]
        let item = item.or_else(|| self.action());
        if let Some(item) = item {
            self.count += 1;
            return Some(item);
        }
        let ends = self.list != List::End;
        self.list = List::End;
        ends.then_some(GraphItem::End { items: self.count })
    }
}

#[cfg(feature = "std")]
impl GraphItems<'_> {
    /// Lists the actions of a world alone, without [`GraphItem::End`].
    pub(crate) fn of_actions(actions: &'static [Action]) -> Self {
        const NONE: Graph = Graph {
            name: "",
            doc: "",
            cycle_hz: 0.0,
            budget_ms: None,
            tunable: false,
            version: None,
            commit: None,
            root: 0,
            nodes: &[],
            roles: &[],
        };
        Self { list: List::End, ..describe(&NONE) }.with_actions(actions)
    }

    /// Adds the actions of the tree's world.
    #[must_use]
    pub fn with_actions(self, actions: &'static [Action]) -> Self {
        Self { actions, ..self }
    }

    /// Returns the next role of the last link.
    fn role(&mut self) -> Option<GraphItem<'static>> {
        let (roles, next) = &mut self.roles;
        let found = (*next..self.graph.roles.len()).find(|role| roles.contains(*role));
        *next = found.map_or(self.graph.roles.len(), |role| role + 1);
        found.map(|role| GraphItem::Role { name: self.graph.roles[role] })
    }

    /// Returns the next query or writer of the last component.
    fn other(&mut self) -> Option<GraphItem<'static>> {
        let (listed, component) = (self.others.take()?, self.index - 1);
        let queries = self.graph.nodes[component].queries.distinct();
        let queries = queries.map(|query| GraphItem::Query { of: query.of as u16, kind: query.kind });
        let writers = writers(self.graph, component);
        let writers = writers.iter().flat_map(|writers| {
            let writer = |of| GraphItem::Writer { by: of as u16, in_force: of == writers.in_force() };
            writers.order.iter().map(writer)
        });
        let item = queries.chain(writers).nth(listed);
        self.others = item.is_some().then_some(listed + 1);
        item
    }

    fn action(&mut self) -> Option<GraphItem<'static>> {
        let (Action { call, moves }, rest) = self.actions.split_first()?;
        (self.actions, self.doc, self.arguments) = (rest, call.doc, call.arguments);
        Some(GraphItem::Action { name: call.name, moves: *moves })
    }
}

impl GraphItems<'_> {
    /// Returns the next item that belongs to the last listed item, such as its doc comment.
    fn attachment(&mut self) -> Option<GraphItem<'static>> {
        if !self.doc.is_empty() {
            let text = truncate(self.doc, DOC_BYTES);
            self.doc = self.doc.get(text.len()..).unwrap_or_default();
            return Some(GraphItem::Doc { text });
        }
        #[cfg(feature = "std")]
        if let Some(place) = self.place.take() {
            return Some(GraphItem::Place(place));
        }
        #[cfg(feature = "std")]
        if let Some(role) = self.role() {
            return Some(role);
        }
        #[cfg(feature = "std")]
        if let Some(other) = self.other() {
            return Some(other);
        }
        #[cfg(feature = "std")]
        if let Some(kind) = self.kind.take() {
            return Some(GraphItem::Kind { name: truncate(kind, TYPE_BYTES) });
        }
        #[cfg(feature = "std")]
        if let Some(&WorkFunction { name, doc, takes_ms, slices, result }) = self.work.take() {
            self.doc = doc;
            return Some(GraphItem::Work { name, takes_ms, slices, result: truncate(result, TYPE_BYTES) });
        }
        if let Some((variant, rest)) = self.variants.split_first() {
            (self.variants, self.doc) = (rest, variant.doc);
            return Some(GraphItem::Variant { name: variant.name });
        }
        let (argument, rest) = self.arguments.split_first()?;
        self.arguments = rest;
        #[cfg(feature = "std")]
        {
            self.place = argument.hint.place();
        }
        let (kind, default) = self.begin_param(argument);
        Some(GraphItem::Argument { name: argument.name, unit: argument.unit, kind, default })
    }

    /// Returns the next item of the lists; `None` at the end.
    fn listed(&mut self) -> Option<GraphItem<'static>> {
        while self.list != List::End {
            if let Some(item) = self.in_list() {
                self.index += 1;
                return Some(item);
            }
            if self.list == List::Modulations {
                self.node += 1;
            }
            (self.list, self.index) = (self.list.next(), 0);
            if self.list == List::Links && self.node >= self.graph.nodes.len() {
                return None;
            }
        }
        None
    }

    /// Returns the item at the index in the list; `None` after the last one.
    fn in_list(&mut self) -> Option<GraphItem<'static>> {
        let (index, component) = (self.index as u16, self.node as u16);
        match self.list {
            List::Tree => return (self.index == 0).then(|| self.tree()),
            List::Components => {
                let node = self.graph.nodes.get(self.index)?;
                let Node { name, hz, budget_us, resume, .. } = *node;
                self.doc = node.doc;
                #[cfg(feature = "std")]
                {
                    (self.others, self.kind, self.work) = (Some(0), node.kind, node.work);
                }
                let root = self.graph.root == self.index;
                return Some(GraphItem::Component { index, name, hz, budget_us, root, resume });
            }
            _ => {}
        }
        let node = self.graph.nodes.get(self.node)?;
        Some(match self.list {
            List::Links => {
                let link = node.links.get(self.index)?;
                #[cfg(feature = "std")]
                {
                    self.roles = (link.roles, 0);
                }
                GraphItem::Link {
                    from: component,
                    to: link.to as u16,
                    modulation: link.kind == LinkKind::Modulation,
                    state: link.state.map(|state| state as u16),
                }
            }
            List::States => {
                let state = node.states.get(self.index)?;
                self.doc = state.doc;
                let graph::State { name, initial, last, end, before, .. } = *state;
                GraphItem::State { component, index, name, initial, last, end, before }
            }
            List::Transitions => {
                let transition = node.transitions.get(self.index)?;
                self.doc = transition.doc.text();
                let (from, to) = (transition.from as u16, transition.to as u16);
                let graph::Transition { name, after_ms, after, times, .. } = *transition;
                let when = transition.when.map(|when| (u16::from(when.child), when.end));
                let carries = transition.carries.map(|of| truncate(of, TYPE_BYTES));
                GraphItem::Transition { component, from, to, name, after_ms, after, when, times, carries }
            }
            List::Params => {
                let (_, param) = node.find_param(self.index)?;
                let group = group(node, self.index)?;
                let (kind, default) = self.begin_param(param);
                GraphItem::Param { component, index, group, name: param.name, unit: param.unit, kind, default }
            }
            List::Outputs => {
                let output = node.outputs.get(self.index)?;
                self.doc = output.doc.text();
                let type_name = truncate(output.ty, TYPE_BYTES);
                let placement = output.placement.copied();
                GraphItem::Output { component, index, name: output.name, unit: output.unit, type_name, placement }
            }
            List::Modulations => {
                let modulation = node.modulations.get(self.index)?;
                (self.doc, self.arguments) = (modulation.doc, modulation.arguments);
                let (name, stops, drives) = (modulation.name, modulation.stops, modulation.drives);
                GraphItem::Modulation { component, index, name, stops, drives }
            }
            List::Tree | List::Components | List::End => return None,
        })
    }

    fn tree(&mut self) -> GraphItem<'static> {
        let Graph { name, doc, cycle_hz, budget_ms, tunable, nodes, .. } = *self.graph;
        self.doc = doc;
        GraphItem::Tree { name, cycle_hz, budget_ms, tunable, components: nodes.len() as u16 }
    }

    /// Prepares the items that follow a parameter or argument; returns its kind and default.
    fn begin_param(&mut self, param: &Param) -> (Kind<u16>, Value) {
        self.doc = param.doc.text();
        if let Kind::Choice { variants } = param.kind {
            self.variants = variants;
        }
        (param.kind.map(|variants| variants.len() as u16), param.default)
    }
}

/// Name of the struct that contains the parameter at an index.
fn group(node: &Node, index: usize) -> Option<&'static str> {
    let mut before = 0;
    node.params.iter().find_map(|group| {
        before += group.params.len();
        (index < before).then_some(group.name)
    })
}
