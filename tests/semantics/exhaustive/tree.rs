//! Tree whose shape is data: the engine of the framework, with components that interpret a [`Shape`].
//!
//! A loop over the rows of a shape replaces the code that `#[component]` generates. Visits, rates, holds, starts and
//! stops are those of the framework. Facts that the engine knows at compile time are type parameters: whether a
//! component declares a rate (`R`), and whether several links lead to one component (`SHARED`).

use bica_core::__private::{
    Cycle, Engine, Has, Layout, Member, MemberOf, Node as GraphNode, Probe, Slot, State, Visit, visit_functions,
};
use bica_core::{Component, Graph, Tree};

use super::shape::{COMPONENTS, Link, Row, STATES, Shape};

/// Component `I`; it declares a rate if `R`.
#[derive(Clone, Copy)]
pub(crate) struct Node<const I: usize, const R: bool> {
    /// Links in each state.
    rows: [Row; STATES],
    /// State of the machine after its run in this cycle.
    answer: u8,
}

const fn state(name: &'static str, initial: bool) -> State {
    State { name, doc: "", initial, last: false }
}

impl<const I: usize, const R: bool> Component for Node<I, R> {
    type Itself = Self;
    type Block = ();
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
    const HAS_CHILDREN: bool = true;

    fn pass<P: Probe>(cycle: &mut Cycle<'_, T, P>, visit: Visit) {
        let (this, ()) = cycle.borrow::<Self, ()>();
        let (rows, answer) = (this.rows, usize::from(this.answer));
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
    ($($index:literal $field:ident $rated:ident;)*) => {
        /// Slots of a tree.
        pub(crate) struct Slots<$(const $rated: bool),*> {
            $($field: Slot<Node<$index, $rated>>,)*
        }

        /// Tree of the components; each is rated or not, and all are shared or none.
        pub(crate) struct Any<$(const $rated: bool,)* const SHARED: bool> {
            pub(crate) engine: Engine<Self>,
        }

        impl<$(const $rated: bool,)* const SHARED: bool> Any<$($rated,)* SHARED> {
            pub(crate) fn new(shape: &Shape) -> Self {
                let mut tree = Self {
                    engine: Engine::new(Slots {
                        $($field: Slot::new::<Self>(Node { rows: shape.links[$index], answer: 0 }),)*
                    }),
                };
                $(if let Some(hz) = shape.rates[$index].requested() {
                    tree.rate_mut::<Node<$index, $rated>>().set(hz);
                })*
                tree
            }

            pub(crate) fn answer(&mut self, answers: [u8; COMPONENTS]) {
                $(self.get_mut::<Node<$index, $rated>>().answer = answers[$index];)*
            }

            pub(crate) fn link(&mut self, links: &[[Row; STATES]; COMPONENTS]) {
                $(self.get_mut::<Node<$index, $rated>>().rows = links[$index];)*
            }
        }

        impl<$(const $rated: bool,)* const SHARED: bool> Tree for Any<$($rated,)* SHARED> {
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

        impl<$(const $rated: bool,)* const SHARED: bool> Layout for Any<$($rated,)* SHARED> {
            type Slots = Slots<$($rated),*>;
            const CYCLE_HZ: f32 = 100.0;
            const ACTIVATORS: &'static [usize] = &[if SHARED { 2 } else { 1 }; COMPONENTS];
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

            fn set_hz(&mut self, index: usize, hz: Option<f32>) {
                match index {
                    $($index => hz.map_or((), |hz| self.rate_mut::<Node<$index, $rated>>().set(hz)),)*
                    _ => {}
                }
            }
        }
    };
}

macro_rules! members {
    ($($index:literal $field:ident $own:ident;)*) => {$(
        impl<const R0: bool, const R1: bool, const R2: bool, const R3: bool, const SHARED: bool>
            Has<Node<$index, $own>> for Any<R0, R1, R2, R3, SHARED>
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
    0 root R0;
    1 second R1;
    2 third R2;
    3 fourth R3;
}
members! {
    0 root R0;
    1 second R1;
    2 third R2;
    3 fourth R3;
}
