//! Minimum times of BICA, of functions by hand, of boxed components and of the state machines, in one process: a preview of
//! `cargo xtask peers` that does not need copper-rs.
//!
//! With the argument `once` each case runs 1000 cycles in a function with its own name, for `valgrind --tool=callgrind`.

use std::hint::black_box;
use std::time::Instant;

use peers::boxed::Boxed;
use peers::framework::{self, BicaSubject};
use peers::machine::{ByHand, Smlang, Statig};
use peers::part::{DIAMOND, FORWARD, chain, set_rounds};
use peers::plain;
use peers::report::claim::overhead;
use peers::report::figures::{Design, Figures, Workload};
use peers::report::table;
use peers::subject::{CYCLE_US, Subject};

/// Number of cycles of a measurement.
const CYCLES: u64 = 500;
/// Number of measurements of each case.
const ROUNDS: usize = 3000;

/// A case: its design and workload, and the function that runs cycles.
type Case = (Design, Workload, Box<dyn FnMut(u64)>);

/// Creates the cases. Each has a function of its own, which a profiler can tell from the others.
macro_rules! cases {
    ($($name:ident: $design:ident $workload:ident = $subject:expr;)*) => {
        vec![$({
            #[inline(never)]
            fn $name(subject: &mut impl Subject, now: &mut u64, cycles: u64) {
                for _ in 0..cycles {
                    black_box(&mut *subject).cycle(*now);
                    *now += CYCLE_US;
                }
            }
            let (mut subject, mut now) = ($subject, 0);
            let run: Box<dyn FnMut(u64)> = Box::new(move |cycles| $name(&mut subject, &mut now, cycles));
            (Design::$design, Workload::$workload, run)
        }),*]
    };
}

fn cases() -> Vec<Case> {
    cases! {
        chain_3_bica: Bica Chain3 = BicaSubject::<framework::Chain3, _>::new(());
        chain_3_by_hand: ByHand Chain3 = plain::Chain::<_, 3, false>::new(());
        chain_3_inlined: ByHandInlined Chain3 = plain::Chain::<_, 3, true>::new(());
        chain_3_boxed: Boxed Chain3 = Boxed::new(&chain::<3>(), ());
        chain_10_bica: Bica Chain10 = BicaSubject::<framework::Chain10, _>::new(());
        chain_10_by_hand: ByHand Chain10 = plain::Chain::<_, 10, false>::new(());
        chain_10_inlined: ByHandInlined Chain10 = plain::Chain::<_, 10, true>::new(());
        chain_10_boxed: Boxed Chain10 = Boxed::new(&chain::<10>(), ());
        chain_100_bica: Bica Chain100 = BicaSubject::<framework::Chain100, _>::new(());
        chain_100_by_hand: ByHand Chain100 = plain::Chain::<_, 100, false>::new(());
        chain_100_inlined: ByHandInlined Chain100 = plain::Chain::<_, 100, true>::new(());
        chain_100_boxed: Boxed Chain100 = Boxed::new(&chain::<100>(), ());
        diamond_bica: Bica Diamond = BicaSubject::<framework::Diamond, _>::new(());
        diamond_by_hand: ByHand Diamond = plain::Diamond::<_, false>::new(());
        diamond_inlined: ByHandInlined Diamond = plain::Diamond::<_, true>::new(());
        diamond_boxed: Boxed Diamond = Boxed::new(&DIAMOND, ());
        tree_bica: Bica Forward = BicaSubject::<framework::Forward, _>::new(());
        tree_by_hand: ByHand Forward = plain::Forward::<_, false>::new(());
        tree_inlined: ByHandInlined Forward = plain::Forward::<_, true>::new(());
        tree_boxed: Boxed Forward = Boxed::new(&FORWARD, ());
        machine_bica: Bica Machine = BicaSubject::<framework::Machine, _>::new(());
        machine_by_hand: ByHand Machine = ByHand::new(());
        machine_statig: Statig Machine = Statig::new();
        machine_smlang: Smlang Machine = Smlang::new();
        sized_chain_bica: Bica SizedChain10 = BicaSubject::<framework::Chain10, _>::new(());
        sized_chain_by_hand: ByHand SizedChain10 = plain::Chain::<_, 10, false>::new(());
        sized_chain_boxed: Boxed SizedChain10 = Boxed::new(&chain::<10>(), ());
        sized_tree_bica: Bica SizedForward = BicaSubject::<framework::Forward, _>::new(());
        sized_tree_by_hand: ByHand SizedForward = plain::Forward::<_, false>::new(());
        sized_tree_boxed: Boxed SizedForward = Boxed::new(&FORWARD, ());
        sized_machine_bica: Bica SizedMachine = BicaSubject::<framework::Machine, _>::new(());
        sized_machine_by_hand: ByHand SizedMachine = ByHand::new(());
        sized_machine_statig: Statig SizedMachine = Statig::new();
        sized_machine_smlang: Smlang SizedMachine = Smlang::new();
    }
}

fn main() {
    let mut cases = cases();
    for (_, workload, run) in &mut cases {
        set_rounds(workload.rounds());
        run(1000);
    }
    if std::env::args().any(|word| word == "once") {
        return;
    }
    let mut figures = Figures::default();
    for _ in 0..ROUNDS {
        for (design, workload, run) in &mut cases {
            set_rounds(workload.rounds());
            let began = Instant::now();
            run(CYCLES);
            figures.record(*design, *workload, began.elapsed().as_nanos() as f64 / CYCLES as f64);
        }
    }
    println!("{}\n{}\n{}", table::times(&figures), table::sized_times(&figures), overhead(&figures));
}
