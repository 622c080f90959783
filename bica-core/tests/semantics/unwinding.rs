//! Ticks that unwind. At the beginning of the next tick everything that was active is stopped; then all components
//! start anew.

use std::cell::Cell;
use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Once;

use bica_core::{ComponentId, Work};
use proptest::prelude::*;

use super::*;

thread_local! {
    /// Number of calls of user code before one panics.
    static COUNTDOWN: Cell<u32> = const { Cell::new(u32::MAX) };
}

thread_local! {
    /// First violated rule. A panic would be caught like those that the test causes.
    static VIOLATED: Cell<Option<&'static str>> = const { Cell::new(None) };
}

/// Records a violated rule.
fn require(holds: bool, rule: &'static str) {
    if !holds {
        VIOLATED.set(VIOLATED.get().or(Some(rule)));
    }
}

/// Message of the panics that the tests cause.
const EXPECTED: &str = "a panic caused by the test";

/// Called by all user code of the test tree; panics when the countdown ends.
fn user_code() {
    let left = COUNTDOWN.get();
    COUNTDOWN.set(left.wrapping_sub(1));
    assert!(left != 0, "{EXPECTED}");
}

/// Component that counts the calls of its hooks and checks that it runs only when started.
macro_rules! fragile {
    ($name:ident($($option:tt)*) { $($functions:tt)* }) => {
        pub(crate) struct $name {
            started: i32,
            stopped: i32,
        }

        #[component($($option)* crate = bica_core)]
        impl $name {
            const fn new() -> Self {
                Self { started: 0, stopped: 0 }
            }

            #[start]
            fn on_start(&mut self) {
                require(self.started == self.stopped, "started twice");
                self.started += 1;
                user_code();
            }

            #[stop]
            fn on_stop(&mut self) {
                self.stopped += 1;
                require(self.started == self.stopped, "stopped without a start");
                user_code();
            }

            $($functions)*
        }
    };
}

fragile!(Leaf(hz = 50, writers = first,) {
    #[work(takes_ms = 25)]
    fn job(starts: i32) -> i32 {
        user_code();
        starts
    }

    fn step(&mut self, work: &mut Work<Self>) {
        require(self.started == self.stopped + 1, "runs without a start");
        require(work.result().is_none_or(|starts| starts == self.started), "a stop drops the job");
        if work.is_idle() {
            work.begin(self.started);
        }
        user_code();
    }
});

fragile!(Shared() {
    fn step(&mut self, _: &mut Leaf) {
        require(self.started == self.stopped + 1, "runs without a start");
        user_code();
    }
});

/// Machine that changes its state in each run.
macro_rules! mover {
    ($name:ident($($option:tt)*), $first:ty, $second:ty) => {
        fragile!($name($($option)*) {
            #[state(initial)]
            fn first(&mut self, _: $first) {
                user_code();
            }

            #[state]
            fn second(&mut self, _: $second) {
                user_code();
            }

            #[transition(first -> second)]
            fn on(&self) -> bool {
                require(self.started == self.stopped + 1, "runs without a start");
                user_code();
                true
            }

            #[transition(second -> first)]
            fn back(&self) -> bool {
                require(self.started == self.stopped + 1, "runs without a start");
                user_code();
                true
            }

            #[entry(first | second)]
            fn enter(&mut self) {
                user_code();
            }

            #[exit(second)]
            fn leave(&mut self) {
                user_code();
            }
        });
    };
}
mover!(Left(), &mut Leaf, &Shared);
mover!(Right(resume,), &Shared, &mut Leaf);
mover!(Root(hz = 100,), &Left, &mut Right);

activation_tree! {
    pub(crate) struct Fragile {
        root: Root,
        cycle_hz: 100,
        components: [Leaf, Root, Right, Shared, Left],
        crate: bica_core,
    }
}

/// Returns the components that were started and not stopped.
fn open(tree: &Fragile) -> BTreeSet<ComponentId> {
    let each = [
        (Fragile::id::<Leaf>(), tree.get::<Leaf>().started - tree.get::<Leaf>().stopped),
        (Fragile::id::<Root>(), tree.get::<Root>().started - tree.get::<Root>().stopped),
        (Fragile::id::<Right>(), tree.get::<Right>().started - tree.get::<Right>().stopped),
        (Fragile::id::<Shared>(), tree.get::<Shared>().started - tree.get::<Shared>().stopped),
        (Fragile::id::<Left>(), tree.get::<Left>().started - tree.get::<Left>().stopped),
    ];
    each.into_iter().filter(|(_, open)| *open == 1).map(|(id, _)| id).collect()
}

/// Ticks a tree in which a call of user code may panic; returns whether the tick unwound.
fn unwinds(tree: &mut Fragile, ms: u64, countdown: u32) -> bool {
    COUNTDOWN.set(countdown);
    let ticked = catch_unwind(AssertUnwindSafe(|| tree.tick(at(ms))));
    COUNTDOWN.set(u32::MAX);
    ticked.is_err()
}

/// Runs a test without printing the panics that it causes, and fails if a rule was violated.
fn without_panic_messages(test: impl FnOnce()) {
    static SILENCE: Once = Once::new();
    SILENCE.call_once(|| {
        let hook = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            if !info.payload_as_str().is_some_and(|text| text.contains(EXPECTED)) {
                hook(info);
            }
        }));
    });
    test();
    assert_eq!(VIOLATED.take(), None);
}

/// Components in the order in which they stop.
const STOP_ORDER: [&str; 5] = ["Root", "Right", "Left", "Shared", "Leaf"];

#[test]
fn an_unwound_tree_stops_and_starts_anew() {
    without_panic_messages(|| {
        let mut tree = Fragile::new();
        tree.tick(at(0));
        tree.tick(at(10));
        assert_eq!(open(&tree), tree.active().collect());
        assert!(unwinds(&mut tree, 20, 3));
        let active: Vec<_> = tree.active().map(|id| Fragile::GRAPH.nodes[id.index()].name).collect();
        let expected: Vec<_> =
            STOP_ORDER.iter().filter(|name| active.contains(name)).map(|name| format!("stop {name}")).collect();
        assert!(expected.len() > 2);
        let lines = cycle(&mut tree, 30);
        assert_eq!(lines[..expected.len()], expected);
        assert_eq!(lines[expected.len()], "start Root");
        let rest = &lines[expected.len()..];
        assert!(rest.iter().all(|line| !line.starts_with("skip") && !line.starts_with("stop")), "{rest:?}");
        assert_eq!(open(&tree), tree.active().collect());
    });
}

#[test]
fn a_hold_after_unwinding_keeps_the_stop() {
    without_panic_messages(|| {
        let mut tree = Fragile::new();
        tree.tick(at(0));
        assert!(unwinds(&mut tree, 10, 0));
        assert_eq!(open(&tree), tree.active().collect());
        tree.of_mut::<Root>().hold(Hold::Latent);
        assert!(tree.of::<Root>().is_active(), "it stops in the next tick");
        let lines = cycle(&mut tree, 20);
        assert!(lines.iter().all(|line| line.starts_with("stop")), "{lines:?}");
        assert_eq!(tree.active().count(), 0);
        tree.of_mut::<Root>().hold(Hold::Tree);
        assert_eq!(cycle(&mut tree, 30)[0], "start Root");
    });
}

/// Records the last transition of `Right`.
struct LastTransition(Option<(usize, usize)>);
impl Probe for LastTransition {
    fn transition(&mut self, component: ComponentId, from: usize, to: usize) {
        if component == Fragile::id::<Right>() {
            self.0 = Some((from, to));
        }
    }
}

#[test]
fn unwinding_discards_a_resumed_state() {
    without_panic_messages(|| {
        let mut tree = Fragile::new();
        tree.of_mut::<Right>().hold(Hold::Active);
        tree.tick(at(0));
        tree.tick(at(10));
        assert!(unwinds(&mut tree, 20, 0));
        COUNTDOWN.set(u32::MAX);
        let mut last = LastTransition(None);
        tree.tick_with(at(30), &mut last);
        assert_eq!(last.0, Some((0, 1)));
    });
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// The hooks and steps themselves check that nothing is started or stopped twice, and that nothing runs without a
    /// start.
    #[test]
    fn starts_and_stops_are_pairs_wherever_ticks_unwind(
        ticks in prop::collection::vec((0..40_u32, 0..30_u64, prop::option::weighted(0.2, (0..5_usize, 0..3_usize))), 1..30),
    ) {
        without_panic_messages(|| {
            let mut tree = Fragile::new();
            let mut now = 0;
            for (countdown, ms, hold) in ticks {
                now += ms;
                if let Some((index, how)) = hold {
                    tree.at_mut(index).unwrap().hold([Hold::Tree, Hold::Active, Hold::Latent][how]);
                }
                let unwound = unwinds(&mut tree, now, countdown);
                let active: BTreeSet<_> = tree.active().collect();
                if unwound {
                    assert!(open(&tree).is_subset(&active), "{:?} {active:?}", open(&tree));
                } else {
                    assert_eq!(open(&tree), active);
                }
            }
            let mut now = now + 10;
            for _ in 0..3 {
                now += 10;
                assert!(!unwinds(&mut tree, now, u32::MAX));
                assert_eq!(open(&tree), tree.active().collect());
            }
        });
    }
}
