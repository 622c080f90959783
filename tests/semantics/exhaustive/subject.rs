//! What an exploration needs of a tree: its type, its control and its events.

use bica_core::{ComponentId, Probe, Tree};

use super::shape::{COMPONENTS, Rate, Row, STATES, Shape};
use super::tree::Any;
use crate::semantics::rules::Event;

/// Tree that a test creates and controls.
pub(crate) trait Subject: Tree {
    fn of(shape: &Shape) -> Self;
    /// Sets the state of each machine after its run in the next cycle.
    fn answer(&mut self, answers: [u8; COMPONENTS]);
    /// Sets the links of each component in each state.
    fn link(&mut self, links: &[[Row; STATES]; COMPONENTS]);
}

macro_rules! subject {
    ($($flag:ident)*) => {
        impl<$(const $flag: bool),*> Subject for Any<$($flag),*> {
            fn of(shape: &Shape) -> Self {
                Self::new(shape)
            }

            fn answer(&mut self, answers: [u8; COMPONENTS]) {
                Any::answer(self, answers);
            }

            fn link(&mut self, links: &[[Row; STATES]; COMPONENTS]) {
                Any::link(self, links);
            }
        }
    };
}
subject!(R0 R1 R2 R3 SHARED);

/// Work on a tree of any type.
pub(crate) trait Exploration {
    type Found;

    fn of<T: Subject>(self, shape: &Shape) -> Self::Found;
}

/// Selects the type of a tree by flags known at run time.
macro_rules! with_flags {
    ($shape:expr, $work:expr; [$($done:tt)*]) => {
        $work.of::<Any<$($done)*>>($shape)
    };
    ($shape:expr, $work:expr; [$($done:tt)*] $flag:expr $(, $rest:expr)*) => {
        if $flag {
            with_flags!($shape, $work; [$($done)* true,] $($rest),*)
        } else {
            with_flags!($shape, $work; [$($done)* false,] $($rest),*)
        }
    };
}

/// Explores a tree in which the framework counts one link to each component after the root, or several (`shared`). With one it
/// saves a check, but does not rely on it.
pub(crate) fn with_flags<W: Exploration>(shape: &Shape, shared: bool, work: W) -> W::Found {
    let [root, second, third, fourth] = shape.rates.map(Rate::is_declared);
    with_flags!(shape, work; [] root, second, third, fourth, shared)
}

/// Records the events that a probe receives.
#[derive(Default)]
pub(crate) struct Recorder(pub(crate) Vec<Event>);

impl Probe for Recorder {
    fn start(&mut self, component: ComponentId) {
        self.0.push(Event::Start(component.index()));
    }

    fn stop(&mut self, component: ComponentId) {
        self.0.push(Event::Stop(component.index()));
    }

    fn skip(&mut self, component: ComponentId) {
        self.0.push(Event::Skip(component.index()));
    }

    fn run(&mut self, component: ComponentId) {
        self.0.push(Event::Run(component.index()));
    }

    fn transition(&mut self, component: ComponentId, from: usize, to: usize) {
        self.0.push(Event::Transition(component.index(), from, to));
    }
}
