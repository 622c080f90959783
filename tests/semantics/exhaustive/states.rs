//! All trees with the same rates at once: the graph of the states in which they can be between two cycles.
//!
//! A cycle reads the links of a machine in the state in which its run begins, and in the state that it enters. So the links of a
//! state are chosen in all ways when the machine enters it, and discarded when the machine leaves it. The trees that are
//! explored in this way change their links each time; those that keep them are among them, with machines of any number of
//! states.
//!
//! A node of the graph is a state of the engine, the state of the model, and the links of the active components. Its edges
//! are all cycles: whether each machine that runs takes a transition, and the links of each state that is entered; and all
//! requests to hold a component. Links that a cycle does not read are not varied. Each node is reached once, and all its
//! edges are compared, so that every sequence of cycles is covered, of any length.
//!
//! The index of a state is not part of a node. Engine and model only store it and report it, and both reports are compared. Trees
//! with constant links and states of all indices are tested at random.

use std::fmt::Debug;
use std::ops::AddAssign;

use bica_core::{Hold, Instant, Tree};

use super::choice::{Choice, each_choice};
use super::key::{Known, key};
use super::model::Model;
use super::shape::{COMPONENTS, NO_LINKS, Row, STATES, Shape};
use super::subject::{Exploration, Recorder, Subject};
use crate::semantics::rules::Event;

/// Exploration of all trees with the rates of a shape, whose other data is not used.
pub(crate) struct States {
    /// Largest number of components that are held active or latent at once. Between two cycles any may be held or released.
    pub(crate) held: usize,
}

/// Numbers of what was explored.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Counts {
    pub(crate) states: u64,
    /// Number of cycles that were compared.
    pub(crate) cycles: u64,
    /// Number of cycles after which no further state is found.
    pub(crate) depth: u64,
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.states += other.states;
        self.cycles += other.cycles;
        self.depth = self.depth.max(other.depth);
    }
}

/// State between two cycles.
struct Node<T> {
    tree: T,
    model: Model,
    /// Links of each active component in its state.
    rows: [Row; COMPONENTS],
    /// Number of cycles before.
    cycle: u64,
}

impl Exploration for States {
    type Found = Counts;

    fn of<T: Subject>(self, shape: &Shape) -> Counts {
        let first = Node { tree: T::of(shape), model: Model::default(), rows: [NO_LINKS; COMPONENTS], cycle: 0 };
        let mut graph = Graph { shape, known: Known::default(), open: Vec::new(), counts: Counts::default() };
        graph.reach(first);
        let (mut subject, mut buffers) = (T::of(shape), Buffers::default());
        while let Some(level) = graph.next_level() {
            for node in &level {
                graph.hold(node, self.held);
                graph.cycles(node, &mut subject, &mut buffers);
            }
        }
        graph.counts
    }
}

/// Events of one cycle.
#[derive(Default)]
struct Buffers {
    seen: Recorder,
    expected: Vec<Event>,
}

struct Graph<'a, T> {
    shape: &'a Shape,
    known: Known,
    /// Nodes whose edges are still to be compared.
    open: Vec<Node<T>>,
    counts: Counts,
}

impl<T: Subject> Graph<'_, T> {
    fn next_level(&mut self) -> Option<Vec<Node<T>>> {
        (!self.open.is_empty()).then(|| std::mem::take(&mut self.open))
    }

    /// Adds a node unless it is known.
    fn reach(&mut self, node: Node<T>) {
        if self.known.insert(key(self.shape, &node.tree, &node.model, &node.rows)) {
            self.counts.states += 1;
            self.counts.depth = self.counts.depth.max(node.cycle);
            self.open.push(node);
        }
    }

    fn copy(&self, tree: &T) -> T {
        let mut copy = T::of(self.shape);
        copy.engine_mut().copy_state_from(tree.engine());
        copy
    }

    /// Requests each hold of each component, as long as at most `most` components are held.
    fn hold(&mut self, node: &Node<T>, most: usize) {
        for index in 0..self.shape.len {
            for hold in [Hold::Tree, Hold::Active, Hold::Latent] {
                let mut model = node.model;
                model.components[index].hold = hold;
                let held = model.components.iter().filter(|memory| memory.hold != Hold::Tree).count();
                if held <= most && node.model.components[index].hold != hold {
                    let mut tree = self.copy(&node.tree);
                    tree.hold_at(index, hold).unwrap();
                    self.reach(Node { tree, model, ..*node });
                }
            }
        }
    }

    /// Compares all cycles that can follow.
    fn cycles(&mut self, node: &Node<T>, subject: &mut T, buffers: &mut Buffers) {
        let mut shape = *self.shape;
        each_choice(&shape.clone(), &node.model, &node.rows, &mut |choice: &Choice| {
            let answers = choice.apply(&node.model, &mut shape.links);
            let mut model = node.model;
            model.tick(&shape, answers, &mut buffers.expected);
            subject.engine_mut().copy_state_from(node.tree.engine());
            subject.link(&shape.links);
            subject.answer(answers);
            buffers.seen.0.clear();
            subject.tick_with(Instant::from_millis(10 * node.cycle), &mut buffers.seen);
            self.counts.cycles += 1;
            compare(subject, &model, &buffers.seen.0, &buffers.expected, (&shape, &answers, node.cycle));
            let rows = choice.rows_after(&model);
            if !self.known.contains(&key(self.shape, subject, &model, &rows)) {
                self.reach(Node { tree: self.copy(subject), model, rows, cycle: node.cycle + 1 });
            }
        });
    }
}

/// Number of trees of `len` components with given rates: each component has one to three states, and in each state no link, a
/// requirement or a modulation to each later component.
pub(crate) fn trees(len: usize) -> u64 {
    let rows = |index: usize| 3_u64.pow((len - 1 - index) as u32);
    (0..len).map(|index| (1..=STATES as u32).map(|states| rows(index).pow(states)).sum::<u64>()).product()
}

/// Compares the events and the reported status with the model.
fn compare<T: Tree>(tree: &T, model: &Model, seen: &[Event], expected: &[Event], case: (&Shape, &impl Debug, u64)) {
    assert_eq!(seen, expected, "{case:#?}\nbefore: {model:#?}");
    for (index, memory) in model.components.iter().enumerate() {
        let status = tree.status(index).expect("a component of the tree");
        let expected = (memory.active, memory.hold, memory.state);
        assert_eq!((status.active, status.held, status.state), expected, "{index}: {case:#?}");
    }
}
