//! For random machines and holds, the active components are exactly those visited in the last cycle, and each start and
//! each stop is reported once.

use std::collections::BTreeSet;

use bica_core::ComponentId;
use proptest::prelude::*;

use super::*;

macro_rules! leaf {
    ($($name:ident $(hz = $hz:literal)?;)*) => {
        $(
            pub(crate) struct $name;

            #[component($(hz = $hz,)? crate = bica_core)]
            impl $name {
                const fn new() -> Self {
                    Self
                }

                fn step(&mut self) {}
            }
        )*
    };
}
leaf! { Often; Seldom hz = 3; Shared; Deep hz = 10; }

/// Machine that enters the next of its three states while `goes` is set.
macro_rules! machine {
    ($name:ident, [$($option:ident)?], ($($a:ty),*) ($($b:ty),*) ($($c:ty),*)) => {
        pub(crate) struct $name {
            goes: bool,
        }

        #[component($($option,)? crate = bica_core)]
        impl $name {
            const fn new() -> Self {
                Self { goes: false }
            }

            #[state(initial)]
            fn first(&mut self $(, _: $a)*) {}

            #[state]
            fn second(&mut self $(, _: $b)*) {}

            #[state]
            fn third(&mut self $(, _: $c)*) {}

            #[transition(first -> second)]
            fn on(&self) -> bool {
                self.goes
            }

            #[transition(second -> third)]
            fn further(&self) -> bool {
                self.goes
            }

            #[transition(third -> first)]
            fn back(&self) -> bool {
                self.goes
            }
        }
    };
}
machine!(Inner, [resume], (&Shared)(&mut Deep, &Seldom)());
machine!(Middle, [], (&mut Inner, &Shared)(&Often)(&Inner, &mut Often));
machine!(Top, [], (&Middle)(&mut Middle, &Seldom)(&mut Inner, &Often));

activation_tree! {
    pub(crate) struct Restless {
        root: Top,
        cycle_hz: 10,
        components: [Top, Middle, Inner, Often, Seldom, Shared, Deep],
        crate: bica_core,
    }
}

/// Components visited, started and stopped in a cycle; none may be reported twice.
#[derive(Default)]
struct Seen {
    visited: BTreeSet<ComponentId>,
    started: BTreeSet<ComponentId>,
    stopped: BTreeSet<ComponentId>,
}

impl Probe for Seen {
    fn start(&mut self, component: ComponentId) {
        assert!(self.started.insert(component));
    }

    fn stop(&mut self, component: ComponentId) {
        assert!(self.stopped.insert(component));
    }

    fn skip(&mut self, component: ComponentId) {
        assert!(self.visited.insert(component));
    }

    fn run(&mut self, component: ComponentId) {
        assert!(self.visited.insert(component));
    }
}

/// Inputs before a cycle: its length, ms; the machines that change their state; and an optional hold of a component.
type Event = (u64, [bool; 3], Option<(usize, u8)>);

fn events() -> impl Strategy<Value = Vec<Event>> {
    let hold = proptest::option::weighted(0.3, (0..Restless::COUNT, 0..3_u8));
    let machines = proptest::array::uniform3(proptest::bool::weighted(0.3));
    proptest::collection::vec((0..400_u64, machines, hold), 1..60)
}

proptest! {
    #[test]
    fn the_active_components_are_those_visited(events in events()) {
        let mut tree = Restless::new();
        let (mut now, mut before) = (0, BTreeSet::new());
        for (ms, [top, middle, inner], hold) in events {
            now += ms;
            tree.get_mut::<Top>().goes = top;
            tree.get_mut::<Middle>().goes = middle;
            tree.get_mut::<Inner>().goes = inner;
            if let Some((index, how)) = hold {
                let hold = [Hold::Tree, Hold::Active, Hold::Latent][usize::from(how)];
                tree.hold_at(ComponentId::new(index), hold);
                prop_assert_eq!(tree.active().collect::<BTreeSet<_>>(), before.clone());
            }
            let mut seen = Seen::default();
            tree.tick_with(at(now), &mut seen);
            prop_assert_eq!(tree.active().collect::<BTreeSet<_>>(), seen.visited.clone());
            prop_assert_eq!(seen.started, &seen.visited - &before);
            prop_assert_eq!(seen.stopped, &before - &seen.visited);
            before = seen.visited;
        }
    }
}
