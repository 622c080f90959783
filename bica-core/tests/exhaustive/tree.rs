//! Tree whose shape is data: the engine of the framework, with components that interpret a [`Shape`].
//!
//! A loop over the rows of a shape replaces the code that `#[component]` generates. Visits, rates, holds, starts and
//! stops are those of the framework. Facts that the engine knows at compile time are type parameters: whether a
//! component declares a rate (`R`), and whether several links lead to it (`S`).

use bica_core::__private::{
    Cycle, Engine, Has, Layout, Member, MemberOf, Node as GraphNode, Probe, Slot, State, Visit, visit_functions,
};
use bica_core::{Component, Graph, Tree};

use crate::shape::{COMPONENTS, Link, Shape};

/// Component `I`; it declares a rate if `R`.
#[derive(Clone, Copy)]
pub(crate) struct Node<const I: usize, const R: bool> {
    shape: Shape,
    /// State of each machine after its run in this cycle.
    answers: [u8; COMPONENTS],
}

const fn state(name: &'static str, initial: bool) -> State {
    State { name, doc: "", initial, last: false }
}

impl<const I: usize, const R: bool> Component for Node<I, R> {
    const NAME: &'static str = "Node";
    const DOC: &'static str = "";
    const HZ: Option<f32> = if R { Some(50.0) } else { None };
    const BUDGET_US: Option<f32> = None;
    const RESUME: bool = false;
    type Params = ();
    const DEFAULT_PARAMS: () = ();
    const CONSTANT_PARAMS: &'static () = &();
    const STATES: &'static [State] = &[state("first", true), state("second", false), state("third", false)];
}

impl<const I: usize, const R: bool, T: Has<Self>> MemberOf<T> for Node<I, R> {
    const WRITTEN: &'static [bica_core::__private::WrittenLink] = &[];
    const NODE: GraphNode = GraphNode { hz: Self::HZ, states: Self::STATES, ..GraphNode::new("Node") };
    const TIMED: bool = false;

    fn pass<P: Probe>(cycle: &mut Cycle<'_, T, P>, visit: Visit) {
        let (this, ()) = cycle.borrow::<Self, ()>();
        let (rows, answer) = (this.shape.links[I], this.answers[I] as usize);
        let mut machine = cycle.machine::<Self>(visit);
        loop {
            let row = rows[machine.state];
            visit_all(cycle, row, Link::Requirement);
            if visit.due {
                cycle.begin_state::<Self>(machine);
                if !machine.moved && answer != machine.state {
                    machine = cycle.transition::<Self>(machine.state, answer);
                    continue;
                }
                cycle.end_code::<Self>();
            }
            visit_all(cycle, row, Link::Modulation);
            return;
        }
    }
}

fn visit_all<T: Layout, P: Probe>(cycle: &mut Cycle<'_, T, P>, row: [Link; COMPONENTS], kind: Link) {
    for (index, _) in row.iter().enumerate().filter(|(_, link)| **link == kind) {
        T::visit(cycle, index);
    }
}

macro_rules! tree {
    ($($index:literal $field:ident $rated:ident $shared:ident;)*) => {
        /// Slots of a tree.
        pub(crate) struct Slots<$(const $rated: bool),*> {
            $($field: Slot<Node<$index, $rated>>,)*
        }

        /// Tree of the components; each is rated or not, and shared or not.
        pub(crate) struct Any<$(const $rated: bool, const $shared: bool),*> {
            pub(crate) engine: Engine<Self>,
        }

        impl<$(const $rated: bool, const $shared: bool),*> Any<$($rated, $shared),*> {
            pub(crate) fn new(shape: Shape) -> Self {
                let mut tree = Self {
                    engine: Engine::new(Slots {
                        $($field: Slot::new::<Self>(Node { shape, answers: [0; COMPONENTS] }),)*
                    }),
                };
                $(if let Some(hz) = shape.rates[$index].requested() {
                    tree.rate_mut::<Node<$index, $rated>>().set(hz);
                })*
                tree
            }

            pub(crate) fn answer(&mut self, answers: [u8; COMPONENTS]) {
                $(self.get_mut::<Node<$index, $rated>>().answers = answers;)*
            }
        }

        impl<$(const $rated: bool, const $shared: bool),*> Tree for Any<$($rated, $shared),*> {
            const GRAPH: Graph = Graph {
                name: "Any",
                doc: "",
                cycle_hz: 100.0,
                budget_ms: None,
                tunable: false,
                root: 0,
                nodes: &[$(<Node<$index, $rated> as MemberOf<Self>>::NODE),*],
            };
        }

        impl<$(const $rated: bool, const $shared: bool),*> Layout for Any<$($rated, $shared),*> {
            type Slots = Slots<$($rated),*>;
            const CYCLE_HZ: f32 = 100.0;
            const ACTIVATORS: &'static [usize] = &[$(if $shared { 2 } else { 1 }),*];
            const ORDER: &'static [u16] = &[$($index),*];

            fn engine(&self) -> &Engine<Self> {
                &self.engine
            }

            fn engine_mut(&mut self) -> &mut Engine<Self> {
                &mut self.engine
            }

            fn visit_root<P: Probe>(cycle: &mut Cycle<'_, Self, P>) {
                <Self as Layout>::visit(cycle, 0);
            }

            fn visit<P: Probe>(cycle: &mut Cycle<'_, Self, P>, index: usize) {
                match index {
                    $($index => <Self as Has<Node<$index, $rated>>>::visit(cycle),)*
                    _ => {}
                }
            }

            fn stop<P: Probe>(cycle: &mut Cycle<'_, Self, P>, index: usize) {
                match index {
                    $($index => cycle.stop::<Node<$index, $rated>>(),)*
                    _ => {}
                }
            }

            fn component_state(slots: &Self::Slots, index: usize) -> Option<&bica_core::__private::ComponentState> {
                match index {
                    $($index => Some(slots.$field.state()),)*
                    _ => None,
                }
            }

            fn member<M: Member<Self>>(index: usize, action: M) -> Option<M::Output> {
                match index {
                    $($index => Some(action.visit::<Node<$index, $rated>>()),)*
                    _ => None,
                }
            }

            fn hz(&self, index: usize) -> Option<f32> {
                match index {
                    $($index => self.rate::<Node<$index, $rated>>().hz(),)*
                    _ => None,
                }
            }

            fn set_hz(&mut self, index: usize, hz: f32) {
                match index {
                    $($index => self.rate_mut::<Node<$index, $rated>>().set(hz),)*
                    _ => {}
                }
            }
        }
    };
}

macro_rules! members {
    ($($index:literal $field:ident $own:ident;)*) => {$(
        impl<const R0: bool, const S0: bool, const R1: bool, const S1: bool, const R2: bool, const S2: bool, const R3: bool, const S3: bool>
            Has<Node<$index, $own>> for Any<R0, S0, R1, S1, R2, S2, R3, S3>
        {
            type Member = Node<$index, $own>;
            type Stored = ();
            const INDEX: usize = $index;

            fn slot(slots: &Self::Slots) -> &Slot<Node<$index, $own>> {
                &slots.$field
            }

            visit_functions!(Node<$index, $own>, __pass_of_generic);
        }
    )*};
}

tree! {
    0 root R0 S0;
    1 second R1 S1;
    2 third R2 S2;
    3 fourth R3 S3;
}
members! {
    0 root R0;
    1 second R1;
    2 third R2;
    3 fourth R3;
}
