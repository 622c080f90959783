//! Generic components, several times in one tree.

use bica::prelude::*;

use crate::semantics::test_tree::test_tree;
use crate::semantics::unit::{Unit, unit};

unit!(Root() {
    fn step(&mut self, time: &Time, coarse: &mut Filter<3>, fine: &Filter<5>) {
        self.unit.body("", time, [fine.unit.read()], [&mut coarse.unit]);
    }
});

pub(crate) struct Filter<const N: usize> {
    pub(crate) unit: Unit,
}

#[component(hz = 30)]
impl<const N: usize> Filter<N> {
    pub(crate) const fn new() -> Self {
        Self { unit: Unit::new(if N == 3 { "Filter<3>" } else { "Filter<5>" }) }
    }

    #[start]
    fn started(&mut self) {
        self.unit.started();
    }

    #[stop]
    fn stopped(&mut self) {
        self.unit.stopped();
    }

    #[state(initial)]
    fn open(&mut self, time: &Time, lens: &Lens<N>) {
        self.unit.body("open", time, [lens.unit.read()], []);
    }

    #[state]
    fn shut(&mut self, time: &Time, both: &mut Lens<7>) {
        self.unit.body("shut", time, [], [&mut both.unit]);
    }

    #[transition(open -> shut)]
    fn shuts(&self, lens: &Lens<N>) -> bool {
        self.unit.evaluate("shuts", [lens.unit.read()])
    }

    #[transition(shut -> open, after_ms = 200)]
    fn timer_shut(&self) -> bool {
        true
    }
}

pub(crate) struct Lens<const N: usize> {
    pub(crate) unit: Unit,
}

#[component(hz = 40, writers = first)]
impl<const N: usize> Lens<N> {
    pub(crate) const fn new() -> Self {
        Self {
            unit: Unit::new(match N {
                3 => "Lens<3>",
                5 => "Lens<5>",
                _ => "Lens<7>",
            }),
        }
    }

    #[start]
    fn started(&mut self) {
        self.unit.started();
    }

    #[stop]
    fn stopped(&mut self) {
        self.unit.stopped();
    }

    fn step(&mut self, time: &Time) {
        self.unit.body("", time, [], []);
    }
}

activation_tree! {
    /// Generic components with several parameters.
    pub(crate) struct Generic {
        root: Root,
        cycle_hz: 100,
        components: [Root, Filter<3>, Lens<5>, Lens<7>, Lens<3>, Filter<5>],
    }
}

test_tree!(Generic: [Root, Filter<3>, Lens<5>, Lens<7>, Lens<3>, Filter<5>]);
