//! All sequences of cycles of one tree, in the framework and in the model.

use std::fmt::Debug;

use bica_core::{ComponentId, Hold, Instant, Tree};

use super::model::Model;
use super::shape::{COMPONENTS, Shape};
use super::subject::{Exploration, Recorder, Subject, with_flags};
use crate::rules::Event;

/// Number of cycles of a sequence.
const CYCLES: u64 = 6;

/// Requests that are explored in addition to transitions.
#[derive(Clone, Copy)]
pub(crate) struct Scope {
    /// Whether before each cycle any component may be held active, held latent or released.
    pub(crate) holds: bool,
}

/// Explores a tree; returns the number of compared cycles.
pub(crate) fn sequences(shape: &Shape, scope: Scope) -> u64 {
    with_flags(shape, (1..shape.len).any(|index| shape.is_shared(index)), Explore { scope })
}

struct Explore {
    scope: Scope,
}

impl Exploration for Explore {
    type Found = u64;

    fn of<T: Subject>(self, shape: &Shape) -> u64 {
        explore::<T>(shape, self.scope)
    }
}

/// Requests and transitions of one cycle.
#[derive(Clone, Copy, Debug)]
struct Step {
    hold: Option<(usize, Hold)>,
    answers: [u8; COMPONENTS],
}

/// Explores the sequences level by level. Two sequences that lead to the same state of the model and of the engine have
/// the same continuations, so only one of them is continued.
fn explore<T: Subject>(shape: &Shape, scope: Scope) -> u64 {
    let mut level = vec![(T::of(shape), Model::default())];
    let (mut compared, mut expected, mut seen) = (0, Vec::new(), Recorder::default());
    for cycle in 0..CYCLES {
        let mut next: Vec<(T, Model)> = Vec::new();
        for (tree, model) in &level {
            for step in steps(shape, model, scope) {
                let mut model = *model;
                if let Some((index, hold)) = step.hold {
                    model.components[index].hold = hold;
                }
                model.tick(shape, step.answers, &mut expected);
                if is_redundant(shape, &step, &expected) {
                    continue;
                }
                let mut tree = continuation(tree, shape, &step);
                seen.0.clear();
                tree.tick_with(Instant::from_millis(10 * cycle), &mut seen);
                compared += 1;
                compare(&tree, &model, &seen.0, &expected, (shape, &step, cycle));
                if !next.iter().any(|(other, known)| *known == model && other.engine().behaves_as(tree.engine())) {
                    next.push((tree, model));
                }
            }
        }
        level = next;
    }
    compared
}

/// Creates a tree with the state of another one, and applies the requests before the cycle.
fn continuation<T: Subject>(from: &T, shape: &Shape, step: &Step) -> T {
    let mut tree = T::of(shape);
    tree.engine_mut().copy_state_from(from.engine());
    if let Some((index, hold)) = step.hold {
        tree.hold_at(ComponentId::new(index), hold);
    }
    tree.answer(step.answers);
    tree
}

/// Returns all requests and transitions that are possible in the next cycle.
fn steps(shape: &Shape, model: &Model, scope: Scope) -> Vec<Step> {
    let mut holds = vec![None];
    for index in (0..shape.len).filter(|_| scope.holds) {
        let other = |hold: &Hold| *hold != model.components[index].hold;
        let changes = [Hold::Tree, Hold::Active, Hold::Latent].into_iter().filter(other);
        holds.extend(changes.map(|hold| Some((index, hold))));
    }
    let count: usize = shape.states.iter().product();
    let answers = (0..count).map(|mut code| {
        shape.states.map(|states| {
            let answer = code % states;
            code /= states;
            answer as u8
        })
    });
    answers.flat_map(|answers| holds.iter().map(move |&hold| Step { hold, answers })).collect()
}

/// Whether a machine that did not run had another next state than 0: the case with next state 0 is explored too.
fn is_redundant(shape: &Shape, step: &Step, events: &[Event]) -> bool {
    (0..shape.len).any(|index| step.answers[index] != 0 && !events.contains(&Event::Run(index)))
}

/// Compares the events and the reported status with the model.
pub(crate) fn compare<T: Tree>(
    tree: &T,
    model: &Model,
    seen: &[Event],
    expected: &[Event],
    case: (&Shape, &impl Debug, u64),
) {
    assert_eq!(seen, expected, "{case:#?}\nbefore: {model:#?}");
    for (index, memory) in model.components.iter().enumerate() {
        let status = tree.status(ComponentId::new(index)).expect("a component of the tree");
        let expected = (memory.active, memory.hold, memory.state);
        assert_eq!((status.active, status.held, status.state), expected, "{index}: {case:#?}");
    }
}
