//! Time that a stopwatch records for each component, with a counter that the components advance.

use std::cell::Cell;

use super::*;
use bica_core::stopwatch::{Spent, Stopwatch};

thread_local! {
    /// Value of the counter.
    static TICKS: Cell<u64> = const { Cell::new(0) };
    /// Number of reads of the counter.
    static READS: Cell<u32> = const { Cell::new(0) };
}

fn work(ticks: u64) {
    TICKS.set(TICKS.get().wrapping_add(ticks));
}

fn read() -> u64 {
    READS.set(READS.get() + 1);
    TICKS.get()
}

/// Returns the number of reads of the counter during a cycle.
fn reads(cycle: impl FnOnce()) -> u32 {
    READS.set(0);
    cycle();
    READS.get()
}

/// Component that takes the given number of ticks, and its children.
macro_rules! worker {
    ($name:ident: $ticks:literal $(, $hz:literal Hz)?; $($child:ident)*) => {
        pub(crate) struct $name;

        #[component($(hz = $hz,)? crate = bica_core)]
        impl $name {
            const fn new() -> Self {
                Self
            }

            fn step(&mut self $(, _: &$child)*) {
                work($ticks);
            }

            #[start]
            fn on_start(&mut self) {
                work(1000);
            }

            #[stop]
            fn on_stop(&mut self) {
                work(1000);
            }
        }
    };
}

worker!(Top: 1; Middle Rare);
worker!(Middle: 20; Bottom);
worker!(Bottom: 300;);
worker!(Rare: 4000, 1 Hz;);

activation_tree! {
    pub(crate) struct Bench {
        root: Top,
        cycle_hz: 100,
        components: [Top, Middle, Bottom, Rare],
        crate: bica_core,
    }
}

fn watched(cycles: u64) -> (Bench, Stopwatch<fn() -> u64, 4>) {
    let mut bench = Bench::new();
    let mut watch = Stopwatch::<fn() -> u64, 4>::new(read);
    for cycle in 0..cycles {
        bench.tick_with(at(10 * cycle), &mut watch);
    }
    (bench, watch)
}

#[test]
fn a_component_s_time_excludes_hooks() {
    let (_, watch) = watched(5);
    let spent = |runs, last| Spent { runs, total: runs * last, last };
    assert_eq!(*watch.spent(), [spent(5, 1), spent(5, 20), spent(5, 300), spent(1, 4000)]);
    assert_eq!(watch.of(Bench::id::<Middle>()), Some(spent(5, 20)));
    assert_eq!(watch.of(bica_core::ComponentId::new(4)), None);
}

#[test]
fn adjacent_sections_share_one_read_of_the_counter() {
    let (mut bench, mut watch) = watched(1);
    bench.of_mut::<Rare>().hold(Hold::Latent);
    bench.tick_with(at(10), &mut watch);
    assert_eq!(reads(|| bench.tick_with(at(20), &mut watch)), 4, "three ran");
    bench.of_mut::<Rare>().hold(Hold::Tree);
    bench.tick_with(at(30), &mut watch);
    assert_eq!(reads(|| bench.tick_with(at(40), &mut watch)), 5, "between two that ran one was not due");
}

#[test]
fn a_counter_may_wrap_around() {
    TICKS.set(u64::MAX - 1000 - 310);
    let (_, watch) = watched(3);
    assert_eq!(watch.of(Bench::id::<Bottom>()), Some(Spent { runs: 3, total: 900, last: 300 }));
}

#[test]
fn a_reset_discards_what_was_measured() {
    let (mut bench, mut watch) = watched(3);
    watch.reset();
    assert_eq!(*watch.spent(), [Spent::default(); 4]);
    bench.tick_with(at(30), &mut watch);
    assert_eq!(watch.of(Bench::id::<Top>()), Some(Spent { runs: 1, total: 1, last: 1 }));
}

#[test]
fn components_beyond_its_size_are_not_measured() {
    let mut watch = Stopwatch::<_, 2>::new(read);
    Bench::new().tick_with(at(0), &mut watch);
    assert_eq!(watch.spent().map(|spent| spent.total), [1, 20]);
}

pub(crate) struct Mover;

#[component(crate = bica_core)]
impl Mover {
    const fn new() -> Self {
        Self
    }

    #[state(initial)]
    fn before(&mut self) {
        work(1);
    }

    #[state(last)]
    fn after(&mut self, _: &Bottom) {
        work(2);
    }

    #[exit(before)]
    fn leave(&mut self) {
        work(10);
    }

    #[transition(before -> after, after_ms = 5)]
    fn time_is_up(&self) -> bool {
        true
    }
}

activation_tree! {
    pub(crate) struct Moving {
        root: Mover,
        cycle_hz: 100,
        components: [Mover, Bottom],
        crate: bica_core,
    }
}

#[test]
fn both_sections_of_a_run_count() {
    let (mut tree, mut watch) = (Moving::new(), Stopwatch::<_, 2>::new(read));
    tree.tick_with(at(0), &mut watch);
    tree.tick_with(at(10), &mut watch);
    let mover = Spent { runs: 2, total: 13, last: 12 };
    assert_eq!(*watch.spent(), [mover, Spent { runs: 1, total: 300, last: 300 }]);
}
